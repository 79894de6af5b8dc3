#include "dns/numerics/anderson.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace pennon::dns {
namespace {

constexpr int most_depth = Anderson::most_depth;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_depth, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_depth, most_depth>;

}  // namespace

Anderson::Anderson(Eigen::Index n, int depth)
    : next_differences_(n, std::min(depth, most_depth)),
      f_differences_(n, next_differences_.cols()),
      products_(next_differences_.cols(), next_differences_.cols()),
      last_next_(n),
      last_f_(n),
      right_(next_differences_.cols()),
      last_right_(next_differences_.cols()) {}

void Anderson::advance(Eigen::Ref<Eigen::VectorXd> x, const Eigen::Ref<const Eigen::VectorXd>& f) {
  const int depth = static_cast<int>(f_differences_.cols());
  x += f;
  if (has_last_) {
    if (kept_ == 0) next_ = 0;
    auto newest = f_differences_.col(next_);
    newest = f - last_f_;
    next_differences_.col(next_) = x - last_next_;
    kept_ = std::min(kept_ + 1, depth);
    // The columns' products with the newest are differences of those with f and the f before.
    right_.head(kept_).noalias() = f_differences_.leftCols(kept_).transpose() * f;
    products_.col(next_).head(kept_) = right_.head(kept_) - last_right_.head(kept_);
    products_(next_, next_) = newest.squaredNorm();
    products_.row(next_).head(kept_) = products_.col(next_).head(kept_).transpose();
    next_ = (next_ + 1) % depth;
  }
  last_next_ = x;
  last_f_ = f;
  has_last_ = true;
  last_right_ = right_;
  if (kept_ == 0) return;
  // Normal equations, scaled to a unit diagonal; their rank is decided by pivoting.
  const auto gram = products_.topLeftCorner(kept_, kept_);
  const SmallVector scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const SmallMatrix scaled = scale.asDiagonal() * gram * scale.asDiagonal();
  Eigen::ColPivHouseholderQR<SmallMatrix> factors(scaled);
  factors.setThreshold(1e-12);
  const SmallVector weights =
      scale.cwiseProduct(factors.solve(scale.cwiseProduct(right_.head(kept_))));
  x.noalias() -= next_differences_.leftCols(kept_) * weights;
}

}  // namespace pennon::dns
