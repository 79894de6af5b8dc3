/// A few eigenpairs of A q = lambda B q next to a target, by SLEPc: Krylov-Schur (Stewart 2001) on
/// the shifted and inverted operator (A - target B)^-1 B, factored once by MUMPS.
///
/// Part of the program pennon-global alone: complex PETSc, which no program with the real one holds.
#pragma once

#include <Eigen/SparseCore>
#include <complex>
#include <vector>

namespace pennon::modes::global {

struct Eigenpair {
  std::complex<double> lambda;
  Eigen::VectorXcd q;
  double residual;  ///< |A q - lambda B q| over |A q| + |lambda| |B q|, found anew
};

struct EigenSettings {
  std::complex<double> target;
  int requested = 6;
  double tolerance = 1e-9;  ///< of SLEPc, relative to lambda
  int most_iterations = 300;
};

struct Spectrum {
  std::vector<Eigenpair> pairs;  ///< the converged ones, the most unstable first
  int requested = 0, converged = 0;
  double factor_seconds = 0, solve_seconds = 0;
};

/// Precondition: a petsc::Session. A target on an eigenvalue is moved aside a little. Throws
/// SolverError where the factors do not fit into memory or nothing converged.
Spectrum eigenpairs_near(const Eigen::SparseMatrix<std::complex<double>>& A,
                         const Eigen::SparseMatrix<std::complex<double>>& B, const EigenSettings&);

}  // namespace pennon::modes::global
