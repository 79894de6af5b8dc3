/// A few eigenpairs of A q = lambda B q next to a target, by SLEPc: Krylov-Schur (Stewart 2001) on
/// the shifted and inverted operator T = (A - target B)^-1 B, whose eigenvalues are
/// 1/(lambda - target). SLEPc's options with the prefix global_ reach it.
///
/// Only the program pennon-global links it: it needs PETSc with complex numbers, which cannot be in
/// one program with PETSc with real ones.
#pragma once

#include "modes/global/solve/eigen_solver.hpp"
#include "modes/global/solve/shifted_inverse.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// Starts SLEPc and ends it on destruction. Precondition: a petsc::Session lives as long.
class SlepcSession {
 public:
  SlepcSession();
  ~SlepcSession();
  SlepcSession(const SlepcSession&) = delete;
  SlepcSession& operator=(const SlepcSession&) = delete;
};

/// Those of the n_modes pairs nearest to the target that converged, normalised, each with its
/// residual computed from A and B. Where adjoints are asked for, only pairs whose adjoint converged
/// too; the adjoints are found by a second solution with the same factors, since SLEPc's two-sided
/// solver can fail without reporting it. `inverse` is that of A - target B.
Spectrum eigenpairs_near(const Pencil&, const ShiftedInverse& inverse, std::complex<double> target,
                         int n_modes, bool with_adjoints);

/// The same for the coupled operator, with these factors for the flow's block.
Spectrum coupled_eigenpairs_near(const CoupledOperator&, std::complex<double> target, int n_modes,
                                 bool with_adjoints, const std::shared_ptr<SparseFactors>&);

/// The same as an EigenSolver; all its calls share the analysis of the factors.
EigenSolver coupled_eigensolver(std::shared_ptr<SparseFactors>);

}  // namespace pennon::modes::global
