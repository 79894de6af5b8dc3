/// Snapshots in memory, for tests of what decomposes them.
#pragma once

#include <random>
#include <vector>

#include "analysis/decomposition/bands.hpp"

namespace pennon::test {

template <class Scalar>
class HeldSnapshots final : public decomposition::Snapshots {
 public:
  /// `q`: values x times.
  HeldSnapshots(std::vector<double> t, DenseMatrix<Scalar> q, Eigen::MatrixXd weights = {})
      : Snapshots({.name = "test",
                   .quantity = "q",
                   .t = std::move(t),
                   .points = static_cast<std::size_t>(q.rows()),
                   .components = {"q"},
                   .is_complex = !std::is_same_v<Scalar, double>,
                   .has_changing_weights = weights.cols() > 1}),
        q_(std::move(q)),
        weights_(weights.size() > 0 ? std::move(weights) : Eigen::MatrixXd::Ones(q_.rows(), 1)) {}

  void read(decomposition::Band band, Eigen::MatrixXd& values) const override {
    values = of(q_, band).real();
  }
  void read_complex(decomposition::Band band, Eigen::MatrixXcd& values) const override {
    values = of(q_, band).template cast<std::complex<double>>();
  }
  Eigen::MatrixXd weights(decomposition::Band band) const override { return of(weights_, band); }

 private:
  template <class Matrix>
  static auto of(const Matrix& matrix, decomposition::Band band) {
    return matrix.middleRows(static_cast<Eigen::Index>(band.first),
                             static_cast<Eigen::Index>(band.count));
  }
  DenseMatrix<Scalar> q_;
  Eigen::MatrixXd weights_;
};

inline std::vector<double> steps(Eigen::Index count, double dt, double from = 0) {
  std::vector<double> t;
  for (Eigen::Index m = 0; m < count; ++m) t.push_back(from + dt * static_cast<double>(m));
  return t;
}

/// Independent normal numbers of unit variance.
class NormalNumbers {
 public:
  explicit NormalNumbers(unsigned seed) : engine_(seed) {}
  double operator()() { return normal_(engine_); }
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return normal_(engine_); });
  }
  /// Circular: real and imaginary parts of variance 1/2.
  Eigen::MatrixXcd complex_matrix(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXcd values(rows, columns);
    values.real() = matrix(rows, columns) * std::sqrt(0.5);
    values.imag() = matrix(rows, columns) * std::sqrt(0.5);
    return values;
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace pennon::test
