#include "dns/anderson.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace pennon::dns {

Anderson::Anderson(Eigen::Index n, int depth)
    : x_differences_(n, depth),
      f_differences_(n, depth),
      products_(depth, depth),
      last_x_(n),
      last_f_(n) {}

void Anderson::advance(Eigen::Ref<Eigen::VectorXd> x, const Eigen::Ref<const Eigen::VectorXd>& f) {
  const int depth = static_cast<int>(x_differences_.cols());
  if (has_last_) {
    if (kept_ == 0) next_ = 0;
    x_differences_.col(next_) = x - last_x_;
    f_differences_.col(next_) = f - last_f_;
    kept_ = std::min(kept_ + 1, depth);
    products_.col(next_).head(kept_) =
        f_differences_.leftCols(kept_).transpose() * f_differences_.col(next_);
    products_.row(next_).head(kept_) = products_.col(next_).head(kept_).transpose();
    next_ = (next_ + 1) % depth;
  }
  last_x_ = x;
  last_f_ = f;
  has_last_ = true;
  x += f;
  if (kept_ == 0) return;
  // Normal equations, scaled to a unit diagonal; their rank is decided by pivoting.
  const auto gram = products_.topLeftCorner(kept_, kept_);
  const Eigen::VectorXd scale = gram.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * gram * scale.asDiagonal();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(scaled);
  factors.setThreshold(1e-12);
  const Eigen::VectorXd right = scale.cwiseProduct(f_differences_.leftCols(kept_).transpose() * f);
  const Eigen::VectorXd weights = scale.cwiseProduct(factors.solve(right));
  x.noalias() -= x_differences_.leftCols(kept_) * weights;
  x.noalias() -= f_differences_.leftCols(kept_) * weights;
}

}  // namespace pennon::dns
