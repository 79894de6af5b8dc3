/// A few eigenpairs of A q = lambda B q next to a target, by SLEPc: Krylov-Schur (Stewart 2001) on
/// the shifted and inverted operator T = (A - target B)^-1 B, whose eigenvalues are
/// 1/(lambda - target). SLEPc's options with the prefix global_ reach it.
///
/// Part of the program pennon-global alone: complex PETSc, which no program with the real one
/// holds.
#pragma once

#include "modes/global/solve/eigen_solver.hpp"
#include "modes/global/solve/shifted_inverse.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// SLEPc from construction to destruction, within a petsc::Session.
class SlepcSession {
 public:
  SlepcSession();
  ~SlepcSession();
  SlepcSession(const SlepcSession&) = delete;
  SlepcSession& operator=(const SlepcSession&) = delete;
};

/// The `requested` pairs nearest to the target that converged, each with the residual found anew;
/// `with_adjoints` those whose adjoint converged too, by the same factors (a two-sided solver was
/// seen to fail without saying so).
Spectrum eigenpairs_near(const Pencil&, const ShiftedInverse&, std::complex<double> target,
                         int requested, bool with_adjoints);

/// The same of the coupled operator, with these factors for the flow's block.
Spectrum coupled_eigenpairs_near(const CoupledOperator&, std::complex<double> target, int requested,
                                 bool with_adjoints, const std::shared_ptr<SparseFactors>&);

/// The same as a study of global modes asks it, with the factors' analysis shared by all its calls.
EigenSolver coupled_eigensolver(std::shared_ptr<SparseFactors>);

}  // namespace pennon::modes::global
