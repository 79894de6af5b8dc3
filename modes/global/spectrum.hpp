/// Eigenpairs of A q = lambda B q that were found next to one or several targets.
#pragma once

#include <Eigen/SparseCore>
#include <complex>
#include <vector>

namespace pennon::modes::global {

struct Eigenpair {
  std::complex<double> lambda;
  Eigen::VectorXcd q;
  double residual = 0;  ///< |A q - lambda B q| over |A q| + |lambda| |B q|
};

struct Spectrum {
  std::vector<Eigenpair> pairs;  ///< converged; the most unstable first
  int requested = 0;
};

/// The residual of a pair.
double residual_of(const Eigen::SparseMatrix<std::complex<double>>& A,
                   const Eigen::SparseMatrix<std::complex<double>>& B, const Eigenpair&);

/// Adds the pairs that are not there yet: eigenvalues closer than their own accuracy are one, of
/// which the better pair is kept. The most unstable first.
void merge(std::vector<Eigenpair> others, Spectrum&);

/// Inverse iteration (Wielandt 1944) from a target, which is moved toward the eigenvalue now and then,
/// for one eigenpair, by UMFPACK. Throws SolverError where it does not settle.
Eigenpair eigenpair_near(const Eigen::SparseMatrix<std::complex<double>>& A,
                         const Eigen::SparseMatrix<std::complex<double>>& B,
                         std::complex<double> target);

}  // namespace pennon::modes::global
