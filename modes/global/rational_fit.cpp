#include "modes/global/rational_fit.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <numeric>

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
      weights =
          Eigen::BDCSVD<Eigen::MatrixXcd>(loewner, Eigen::ComputeFullV).matrixV().col(columns - 1);
      return;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXcd> factors(loewner);
    const Eigen::MatrixXcd triangle =
        factors.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
    weights = Eigen::JacobiSVD<Eigen::MatrixXcd>(triangle, Eigen::ComputeFullV)
                  .matrixV()
                  .col(columns - 1);
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
  support_.reserve(fit.support().size());
  for (const Index j : fit.support()) support_.push_back(samples[static_cast<std::size_t>(j)]);
  weights_ = fit.weights;
  error_ = fit.error;
}

Eigen::MatrixXcd RationalFit::operator()(Complex lambda) const {
  Eigen::MatrixXcd above = Eigen::MatrixXcd::Zero(support_[0].F.rows(), support_[0].F.cols());
  Complex below = 0;
  for (std::size_t j = 0; j < support_.size(); ++j) {
    if (lambda == support_[j].lambda) return support_[j].F;
    const Complex by = weights_[static_cast<Index>(j)] / (lambda - support_[j].lambda);
    above += by * support_[j].F;
    below += by;
  }
  return above / below;
}

Eigen::MatrixXcd RationalFit::derivative(Complex lambda) const {
  const Eigen::MatrixXcd value = (*this)(lambda);
  Eigen::MatrixXcd above = Eigen::MatrixXcd::Zero(value.rows(), value.cols());
  Complex below = 0;
  const auto at = std::ranges::find(support_, lambda, &MatrixSample::lambda);
  for (std::size_t j = 0; j < support_.size(); ++j) {
    if (at != support_.end() && &*at == &support_[j]) {
      below = -weights_[static_cast<Index>(j)];
      continue;
    }
    const Complex distance = lambda - support_[j].lambda, w = weights_[static_cast<Index>(j)];
    above +=
        (value - support_[j].F) * (at == support_.end() ? w / (distance * distance) : w / distance);
    if (at == support_.end()) below += w / distance;
  }
  return above / below;
}

}  // namespace pennon::modes::global
