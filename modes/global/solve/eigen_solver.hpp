/// The interface of an eigensolver as the studies of global modes use it, whichever solver it is.
/// The one that the program takes is in slepc/krylov_schur.hpp.
#pragma once

#include <complex>
#include <functional>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// The n_modes eigenpairs of A q = lambda B q nearest to a target, of which those that do not
/// converge are left out; normalised (normalise()), and with adjoints where they are asked for.
using EigenSolver = std::function<Spectrum(const CoupledOperator&, std::complex<double> target,
                                           int n_modes, bool with_adjoints)>;

}  // namespace pennon::modes::global
