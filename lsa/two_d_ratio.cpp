#include "lsa/two_d_ratio.hpp"

#include <cmath>
#include <limits>

namespace pennon::lsa {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TwoDRatio two_d_ratio(const Point& point, const Theory& theory) {
  Theory paper = theory;
  paper.model.bending = false;
  paper.model.cross_flow = false;
  Point flat = point;
  flat.k_x = 0;
  const Coefficients c = coefficients(point, paper);
  const Coefficients c_2d = coefficients(flat, paper);
  const Stability three_d = solve(c, paper.model.form);
  const Stability two_d = solve(c_2d, paper.model.form);

  const double slope = point.k_x / point.k_y;
  const double spanwise = slope * slope * point.nu_s * c.B / (point.k_y * point.k_y);
  const bool grows = two_d.is_unstable();
  TwoDRatio ratio{none, none, none, none};
  if (grows) ratio.growth_ratio = three_d.growth / two_d.growth;
  if (theory.model.form == Form::as_printed) {
    const double P_2D = -(c.mu * c.c_m + (c.mu + c.c_m) * c.B) / (c.c_m * c.c_m);
    ratio.frequency_ratio = c.c_m / c_2d.c_m;
    ratio.P_expansion = P_2D + spanwise / (c.c_m * c.c_m);
    ratio.growth_ratio_expansion = 1 - spanwise / (c.c_m * P_2D);
    return ratio;
  }
  if (grows && three_d.is_unstable()) ratio.frequency_ratio = three_d.frequency / two_d.frequency;
  const double step = spanwise * (c.mu + c.c_m) / (c.c_m * c.c_m);
  ratio.P_expansion = two_d.P + step;
  if (grows) ratio.growth_ratio_expansion = 1 + step / (2 * two_d.P);
  return ratio;
}

}  // namespace pennon::lsa
