#include "modes/global/map/rational_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <numeric>

#include "common/linear_algebra/svd.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Index = Eigen::Index;

// The samples' coordinates in an orthonormal basis of the space they span: a column for each, with
// the same distances as the matrices, but no longer than there are samples.
Eigen::MatrixXcd coordinates(const std::vector<MatrixSample>& samples) {
  const auto count = static_cast<Index>(samples.size());
  Eigen::MatrixXcd entries(samples.front().F.size(), count);
  for (Index i = 0; i < count; ++i)
    entries.col(i) = samples[static_cast<std::size_t>(i)].F.reshaped();
  if (entries.rows() <= count) return entries;
  const Eigen::HouseholderQR<Eigen::MatrixXcd> factors(entries);
  return factors.matrixQR().topRows(count).triangularView<Eigen::Upper>();
}

// Support points and the others, as columns of the coordinates.
struct Division {
  std::vector<Index> support, others;
};

class Fit {
 public:
  explicit Fit(const std::vector<MatrixSample>& samples) : f_(coordinates(samples)) {
    for (const MatrixSample& sample : samples) lambda_.push_back(sample.lambda);
    scale_ = f_.colwise().norm().maxCoeff();
    division_.others.resize(samples.size());
    std::iota(division_.others.begin(), division_.others.end(), Index{0});
  }

  void run(double tolerance) {
    Eigen::MatrixXcd found = f_.rowwise().mean().replicate(1, f_.cols());
    // With one sample left the weights are still determined.
    while (division_.others.size() > 1) {
      const auto worst = std::ranges::max_element(
          division_.others, {}, [&](Index i) { return (f_.col(i) - found.col(i)).squaredNorm(); });
      division_.support.push_back(*worst);
      division_.others.erase(worst);
      find_weights();
      error = 0;
      for (const Index i : division_.others) {
        found.col(i) = value_at(i);
        error = std::max(error, (f_.col(i) - found.col(i)).norm() / scale_);
      }
      if (error <= tolerance) return;
    }
  }

  Eigen::VectorXcd weights;
  double error = 0;
  const std::vector<Index>& support() const { return division_.support; }

 private:
  Complex lambda(Index i) const { return lambda_[static_cast<std::size_t>(i)]; }

  // The right singular vector of the least singular value of Loewner's matrix
  // (f_i - f_j)/(lambda_i - lambda_j), i of the others and j of the support.
  void find_weights() {
    const Index length = f_.rows();
    Eigen::MatrixXcd loewner(length * static_cast<Index>(division_.others.size()),
                             static_cast<Index>(division_.support.size()));
    Index row = 0, column = 0;
    for (const Index i : division_.others) {
      column = 0;
      for (const Index j : division_.support)
        loewner.col(column++).segment(row, length) =
            (f_.col(i) - f_.col(j)) / (lambda(i) - lambda(j));
      row += length;
    }
    const Index columns = loewner.cols();
    if (loewner.rows() < columns) {
      weights = full_svd(loewner).V.col(columns - 1);
      return;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXcd> factors(loewner);
    const Eigen::MatrixXcd triangle =
        factors.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
    weights = thin_svd(triangle).V.col(columns - 1);
  }

  Eigen::VectorXcd value_at(Index i) const {
    Eigen::VectorXcd above = Eigen::VectorXcd::Zero(f_.rows());
    Complex below = 0;
    for (std::size_t j = 0; j < division_.support.size(); ++j) {
      const Index s = division_.support[j];
      const Complex by = weights[static_cast<Index>(j)] / (lambda(i) - lambda(s));
      above += by * f_.col(s);
      below += by;
    }
    return above / below;
  }

  Eigen::MatrixXcd f_;
  std::vector<Complex> lambda_;
  double scale_ = 1;
  Division division_;
};

}  // namespace

RationalFit::RationalFit(const std::vector<MatrixSample>& samples, double tolerance) {
  Fit fit(samples);
  fit.run(tolerance);
  rows_ = samples.front().F.rows();
  const auto count = static_cast<Index>(fit.support().size());
  lambda_.resize(count);
  F_.resize(samples.front().F.size(), count);
  for (Index j = 0; j < count; ++j) {
    const auto from = static_cast<std::size_t>(fit.support()[static_cast<std::size_t>(j)]);
    lambda_[j] = samples[from].lambda;
    F_.col(j) = samples[from].F.reshaped();
  }
  weights_ = fit.weights;
  error_ = fit.error;
}

// b_j/sum b with b_j = w_j/(lambda - lambda_j).
Eigen::VectorXcd RationalFit::shares(Complex lambda) const {
  for (Index j = 0; j < lambda_.size(); ++j)
    if (lambda == lambda_[j]) return Eigen::VectorXcd::Unit(lambda_.size(), j);
  const Eigen::VectorXcd b = weights_.array() / (lambda - lambda_.array());
  return b / b.sum();
}

// r' sum b = sum b_j (r - F_j)/(lambda - lambda_j); at a support point s
// r' w_s = -sum w_j (F_s - F_j)/(lambda_s - lambda_j), j != s.
Eigen::VectorXcd RationalFit::shares_of_derivative(Complex lambda) const {
  const Index count = lambda_.size();
  for (Index s = 0; s < count; ++s) {
    if (lambda != lambda_[s]) continue;
    Eigen::VectorXcd c = Eigen::VectorXcd::Zero(count);
    for (Index j = 0; j < count; ++j)
      if (j != s) c[j] = weights_[j] / (weights_[s] * (lambda - lambda_[j]));
    c[s] = -c.sum();
    return c;
  }
  const Eigen::ArrayXcd b = weights_.array() / (lambda - lambda_.array());
  const Eigen::ArrayXcd b_over = b / (lambda - lambda_.array());
  return (b * (b_over.sum() / b.sum()) - b_over) / b.sum();
}

Eigen::MatrixXcd RationalFit::operator()(Complex lambda) const {
  Eigen::MatrixXcd value(rows_, F_.rows() / rows_);
  value.reshaped().noalias() = F_ * shares(lambda);
  return value;
}

Eigen::VectorXcd RationalFit::derivative(Complex lambda, const Eigen::VectorXcd& x) const {
  const Eigen::VectorXcd slope = F_ * shares_of_derivative(lambda);
  return slope.reshaped(rows_, x.size()) * x;
}

RationalFit RationalFit::projected(const Eigen::MatrixXcd& basis) const {
  RationalFit small;
  small.lambda_ = lambda_;
  small.weights_ = weights_;
  small.error_ = error_;
  small.rows_ = basis.cols();
  small.F_.resize(basis.cols() * basis.cols(), F_.cols());
  for (Index j = 0; j < F_.cols(); ++j) {
    const Eigen::MatrixXcd F = basis.adjoint() * F_.col(j).reshaped(rows_, basis.rows()) * basis;
    small.F_.col(j) = F.reshaped();
  }
  return small;
}

}  // namespace pennon::modes::global
