#include "analysis/decomposition/snapshots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/errors.hpp"

namespace pennon::decomposition {

template <>
Eigen::MatrixXd values_of(const Snapshots& snapshots, Band band) {
  return snapshots.read(band);
}

template <>
Eigen::MatrixXcd values_of(const Snapshots& snapshots, Band band) {
  return snapshots.read_complex(band);
}

void expect_finite(const Layout& layout, const Eigen::MatrixXd& values, std::size_t from) {
  // A sum is finite where all terms are, but for overflow, which the search below forgives.
  for (Eigen::Index m = 0; m < values.cols(); ++m) {
    if (std::isfinite(values.col(m).sum())) continue;
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (std::isfinite(values(i, m))) continue;
      const std::size_t value = from + static_cast<std::size_t>(i);
      const auto snapshot = static_cast<std::size_t>(m);
      throw InputError(
          layout.name,
          fmt::format("has {} at t = {} (snapshot {}), point {} of {}; every value must "
                      "be finite: leave that time out with decompose.from and "
                      "decompose.to, or mend the data",
                      values(i, m), layout.t[snapshot], snapshot, value % layout.points,
                      layout.components[value / layout.points]));
    }
  }
}

}  // namespace pennon::decomposition
