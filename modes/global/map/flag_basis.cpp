#include "modes/global/map/flag_basis.hpp"

#include "common/linear_algebra/svd.hpp"

namespace pennon::modes::global {
namespace {

using Index = Eigen::Index;

// Of a shape of size 1: less than this is in the basis already.
constexpr double least_share = 1e-9;

}  // namespace

FlagBasis::FlagBasis(const Eigen::VectorXd& mass, const std::vector<Eigen::VectorXcd>& shapes,
                     double tolerance)
    : mass_(mass) {
  const Eigen::VectorXd root = mass.cwiseSqrt();
  Eigen::MatrixXcd all(mass.size(), static_cast<Index>(shapes.size()));
  for (std::size_t i = 0; i < shapes.size(); ++i)
    all.col(static_cast<Index>(i)) = root.cwiseProduct(shapes[i]).normalized();
  const auto [U, sigma, V] = thin_svd(all);
  const Index kept = (sigma.array() > tolerance * sigma[0]).count();
  Z_ = root.cwiseInverse().asDiagonal() * U.leftCols(kept);
}

void FlagBasis::add(const Eigen::VectorXcd& shape) {
  if (is_whole()) return;
  const auto size = [&](const Eigen::VectorXcd& v) {
    return v.cwiseProduct(mass_.cwiseSqrt()).norm();
  };
  Eigen::VectorXcd rest = shape / size(shape);
  // Twice, for rounding.
  for (int time = 0; time < 2; ++time)
    rest -= Z_ * (Z_.adjoint() * mass_.cwiseProduct(rest)).eval();
  if (size(rest) < least_share) return;
  Z_.conservativeResize(Eigen::NoChange, Z_.cols() + 1);
  Z_.col(Z_.cols() - 1) = rest / size(rest);
}

FlagOperator FlagBasis::reduced(const FlagOperator& flag) const {
  return {Eigen::VectorXd::Ones(size()), reduced(flag.stiffness)};
}

}  // namespace pennon::modes::global
