#include "modes/normal/gauss_legendre.hpp"

#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <new>

namespace pennon::modes {
namespace {

// GSL tabulates the points for this number; most others it computes to 1e-10 only.
constexpr std::size_t points_per_panel = 20;

}  // namespace

std::vector<QuadraturePoint> gauss_legendre(std::span<const double> panels) {
  const std::unique_ptr<gsl_integration_glfixed_table,
                        decltype(&gsl_integration_glfixed_table_free)>
      table(gsl_integration_glfixed_table_alloc(points_per_panel),
            gsl_integration_glfixed_table_free);
  if (!table) throw std::bad_alloc();
  std::vector<QuadraturePoint> points;
  for (std::size_t panel = 0; panel + 1 < panels.size(); ++panel)
    for (std::size_t i = 0; i < points_per_panel; ++i) {
      double root = 0;
      double weight = 0;
      gsl_integration_glfixed_point(std::sqrt(panels[panel]), std::sqrt(panels[panel + 1]), i,
                                    &root, &weight, table.get());
      points.push_back({root * root, 2 * root * weight});
    }
  return points;
}

}  // namespace pennon::modes
