/// A few eigenpairs of A q = lambda B q next to a target, by SLEPc: Krylov-Schur (Stewart 2001) on
/// the shifted and inverted operator (A - target B)^-1 B, factored once by MUMPS. PETSc's options
/// with the prefix global_ reach them.
///
/// Part of the program pennon-global alone: complex PETSc, which no program with the real one
/// holds.
#pragma once

#include "modes/global/spectrum.hpp"

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
/// `with_adjoints` those whose adjoint converged too, by the same factors transposed (a two-sided
/// solver was seen to fail without saying so).
/// Throws SolverError where the matrix cannot be factored.
Spectrum eigenpairs_near(const Eigen::SparseMatrix<std::complex<double>>& A,
                         const Eigen::SparseMatrix<std::complex<double>>& B,
                         std::complex<double> target, int requested, bool with_adjoints);

}  // namespace pennon::modes::global
