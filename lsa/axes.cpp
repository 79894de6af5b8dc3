#include "lsa/axes.hpp"

#include <numbers>

#include "common/case/parameters.hpp"

namespace pennon::lsa {
namespace {

struct AxisInfo {
  std::string name;
  std::string meaning;
  std::string symbol;
  Range range;
  double Point::*parameter;
  Lanes PointBatch::*lanes;
};

const AxisInfo& info(Axis axis) {
  static const std::array<AxisInfo, axis_count> all = {{
      {"mu", "mass ratio rho_s h/(rho_f L)", "μ", ranges::mu, &Point::mu, &PointBatch::mu},
      {"Re", "Reynolds number V L/nu", "Re", ranges::Re, &Point::Re, &PointBatch::Re},
      {"k_x", "spanwise wavenumber, in 1/L", "k_x L", ranges::k_x, &Point::k_x, &PointBatch::k_x},
      {"k_y", "streamwise wavenumber, in 1/L", "k_y L", ranges::k_y, &Point::k_y, &PointBatch::k_y},
      {"nu_s", "Poisson ratio", "ν_s", ranges::nu_s, &Point::nu_s, &PointBatch::nu_s},
      {"gamma", "spanwise period S/L", "γ", ranges::gamma, &Point::k_x, &PointBatch::k_x},
      {"K_B", "bending stiffness EI/(rho_f V^2 L^3)", "K_B", ranges::K_B, &Point::K_B,
       &PointBatch::K_B},
      {"U", "cross-flow U/V", "U/V", ranges::U, &Point::U, &PointBatch::U},
  }};
  return all[static_cast<std::size_t>(axis)];
}

}  // namespace

const std::string& name(Axis axis) {
  return info(axis).name;
}
const std::string& meaning(Axis axis) {
  return info(axis).meaning;
}
const std::string& symbol(Axis axis) {
  return info(axis).symbol;
}
const Range& range(Axis axis) {
  return info(axis).range;
}

double lane_value(Axis axis, double value) {
  return axis == Axis::gamma ? 2 * std::numbers::pi / value : value;
}

double value(const Point& point, Axis axis) {
  return lane_value(axis, point.*info(axis).parameter);  // 2 pi/x is its own inverse
}

void set(Point& point, Axis axis, double value) {
  point.*info(axis).parameter = lane_value(axis, value);
}

Lanes& lanes(PointBatch& points, Axis axis) {
  return points.*info(axis).lanes;
}

}  // namespace pennon::lsa
