#include "common/linear_algebra/signal_rank.hpp"

#include <algorithm>

namespace pennon {

Eigen::Index signal_rank(const Eigen::VectorXd& sigma, double beta, double roundoff) {
  constexpr Eigen::Index fewest = 8;
  const double omega = ((0.56 * beta - 0.95) * beta + 1.82) * beta + 1.43;
  const double noise = sigma.size() < fewest ? 0 : omega * sigma(sigma.size() / 2);
  const double least = std::max(noise, roundoff * sigma(0));
  return std::count_if(sigma.begin(), sigma.end(), [&](double value) { return value > least; });
}

}  // namespace pennon
