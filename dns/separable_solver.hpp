/// Direct solution on the flat O-grid, where the operators of the fluid are Kronecker sums:
///
///   (R p)(j, i) + (T p)(j, i) = f(j, i),
///
/// R tridiagonal along rho, T along theta with T = S^-1 A, S diagonal and positive, A symmetric:
/// eigenvectors along theta (by FFT where A is circulant), then a tridiagonal system along rho for
/// each of them (Lynch, Rice & Thomas 1964).
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace pennon::dns {

/// A tridiagonal matrix; lower[0] and upper[n - 1] are not used.
struct Tridiagonal {
  Eigen::VectorXd lower, diagonal, upper;
};

/// The eigenvectors of S^-1 A along theta. Rows of n numbers are taken to their coefficients and
/// back.
class ThetaBasis {
 public:
  /// `is_circulant`: A is, and S is constant.
  ThetaBasis(const Eigen::VectorXd& S, const Eigen::MatrixXd& A, bool is_circulant);
  ~ThetaBasis();
  ThetaBasis(ThetaBasis&&) noexcept;
  ThetaBasis& operator=(ThetaBasis&&) noexcept;

  const Eigen::VectorXd& eigenvalues() const { return eigenvalues_; }
  /// In place, `rows` rows one behind the other.
  void to_coefficients(double* values, int rows);
  void to_values(double* coefficients, int rows);

 private:
  class Transform;
  class Fourier;
  class Dense;
  class Parity;
  std::unique_ptr<Transform> transform_;
  Eigen::VectorXd eigenvalues_;
};

class SeparableSolver {
 public:
  SeparableSolver(const Tridiagonal& along_rho, ThetaBasis along_theta);

  /// Solves in place; n_rho rows of n_theta numbers.
  void solve(double* values);

 private:
  ThetaBasis basis_;
  Eigen::VectorXd lower_, upper_;
  // One over the pivots of the eliminations: a row for each rho, a column for each eigenvector.
  Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> inverse_pivot_;
};

}  // namespace pennon::dns
