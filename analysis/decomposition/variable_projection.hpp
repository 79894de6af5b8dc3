/// A matrix of signals as a sum of exponentials in time, by variable projection: the lambda_j that
/// minimise
///
///     min over B of |Z - Phi B|^2,   Phi_mj = exp(lambda_j t_m)
///
/// for signals Z at times t_m, a row for each time (Golub & Pereyra 1973; Kaufman 1975; for dynamic
/// modes Askham & Kutz 2018).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace pennon::decomposition {

struct ExponentialFit {
  Eigen::VectorXcd lambda;
  Eigen::MatrixXcd Phi;       ///< exp(lambda_j t_m)
  double misfit_squared = 0;  ///< |Z - Phi B|^2
  /// Of the change of lambda_j by an error of unit variance in each entry of Z: the mean of its
  /// squared modulus, and where the errors are real, of its square (else zero).
  Eigen::VectorXd variance;
  Eigen::VectorXcd pseudo_variance;
  int iterations = 0;
};

/// From the values `lambda` on. Those of real signals stay in conjugate pairs. Throws SolverError
/// where two exponentials cannot be told apart, or the iteration does not converge; Interrupted.
ExponentialFit fit_exponentials(const Eigen::MatrixXcd& Z, const std::vector<double>& t,
                                Eigen::VectorXcd lambda, bool is_real);

}  // namespace pennon::decomposition
