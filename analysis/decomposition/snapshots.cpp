#include "analysis/decomposition/snapshots.hpp"

#include <fmt/format.h>

#include <cmath>

#include "common/errors.hpp"

namespace pennon::decomposition {
namespace {

// The part of a number that is not finite.
double part_at_fault(double value) {
  return value;
}
double part_at_fault(std::complex<double> value) {
  return std::isfinite(value.real()) ? value.imag() : value.real();
}

}  // namespace

void Snapshots::read_complex(Band band, Eigen::MatrixXcd& values) const {
  Eigen::MatrixXd real;
  read(band, real);
  values = real.cast<std::complex<double>>();
}

template <class Scalar>
void expect_finite(const Layout& layout, const DenseMatrix<Scalar>& values, std::size_t from) {
  for (Eigen::Index m = 0; m < values.cols(); ++m)
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      const double at_fault = part_at_fault(values(i, m));
      if (std::isfinite(at_fault)) continue;
      const std::size_t value = from + static_cast<std::size_t>(i);
      const auto snapshot = static_cast<std::size_t>(m);
      throw InputError(
          layout.name,
          fmt::format("has {} at t = {} (snapshot {}), point {} of {}; every value must be finite: "
                      "leave that time out with decompose.from and decompose.to, or mend the data",
                      at_fault, layout.t[snapshot], snapshot, value % layout.points,
                      layout.components[value / layout.points]));
    }
}

template void expect_finite(const Layout&, const Eigen::MatrixXd&, std::size_t);
template void expect_finite(const Layout&, const Eigen::MatrixXcd&, std::size_t);

}  // namespace pennon::decomposition
