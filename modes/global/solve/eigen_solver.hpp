/// The interface of an eigensolver as the studies of global modes use it, whichever solver it is.
#pragma once

#include <complex>
#include <functional>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// A few eigenpairs of A q = lambda B q next to a target, normalised.
using EigenSolver = std::function<Spectrum(const CoupledOperator&, std::complex<double> target,
                                           int n_modes, bool with_adjoints)>;

}  // namespace pennon::modes::global
