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
/// back. Of a circulant A by FFT; else by matrix products of half the size if A and S do not change
/// under i -> n - 1 - i (the flag's two sides), of a quarter if neither do the halves (uniform
/// theta).
class ThetaBasis {
 public:
  /// `is_circulant`: A is, and S is constant.
  ThetaBasis(const Eigen::VectorXd& S, const Eigen::MatrixXd& A, bool is_circulant);
  ~ThetaBasis();
  ThetaBasis(const ThetaBasis&) = delete;
  ThetaBasis& operator=(const ThetaBasis&) = delete;
  ThetaBasis(ThetaBasis&&) noexcept;
  ThetaBasis& operator=(ThetaBasis&&) noexcept;

  /// One for each coefficient of a row: n, and for real Fourier coefficients n + 2 of which two
  /// vanish.
  const Eigen::VectorXd& eigenvalues() const { return eigenvalues_; }
  /// `rows` rows, one behind the other; what is taken is destroyed.
  void to_coefficients(double* values, double* coefficients, int rows);
  void to_values(double* coefficients, double* values, int rows);

 private:
  class Transform;
  class Fourier;
  class Folded;
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
  // A row for each rho, a column for each eigenvector.
  using Rows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Rows inverse_pivot_;  // of the eliminations
  Rows coefficients_;
};

}  // namespace pennon::dns
