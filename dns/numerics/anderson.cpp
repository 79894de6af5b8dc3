#include "dns/numerics/anderson.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace pennon::dns {

Anderson::Anderson(Eigen::Index n, int depth)
    : next_differences_(n, depth),
      f_differences_(n, depth),
      products_(depth, depth),
      last_next_(n),
      last_f_(n),
      right_(depth),
      last_right_(depth) {}

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
  const Eigen::VectorXd scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * gram * scale.asDiagonal();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(scaled);
  factors.setThreshold(1e-12);
  const Eigen::VectorXd weights =
      scale.cwiseProduct(factors.solve(scale.cwiseProduct(right_.head(kept_))));
  x.noalias() -= next_differences_.leftCols(kept_) * weights;
}

}  // namespace pennon::dns
