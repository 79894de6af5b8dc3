#include "dns/initial_shape.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::dns {

template <int dim>
NodeVectors<dim> initial_shape(const InitialSettings& initial,
                               const std::optional<ShapeFunction>& zeta, const FlagMesh& mesh) {
  NodeVectors<dim> x = rest<dim>(mesh);
  if constexpr (dim == 3)
    if (const double amplitude = initial.plate_mode; amplitude != 0) {
      for (int i = 0; i < mesh.stations(); ++i)
        for (int j = 0; j < mesh.chord_nodes(); ++j)
          x(2, mesh.index(i, j)) = amplitude *
                                   std::sin(std::numbers::pi * mesh.x(i) / mesh.span()) *
                                   std::sin(std::numbers::pi * mesh.y(j));
      return x;
    }
  const double angle = initial.angle;
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 1; j < mesh.chord_nodes(); ++j) {
      auto node = x.col(mesh.index(i, j));
      if (!zeta) {
        node[dim - 2] = mesh.y(j) * std::cos(angle);
        node[dim - 1] = mesh.y(j) * std::sin(angle);
        continue;
      }
      const auto before = x.col(mesh.index(i, j - 1));
      node[dim - 1] = (*zeta)(mesh.x(i), mesh.y(j)) - (*zeta)(mesh.x(i), 0);
      const double rise = node[dim - 1] - before[dim - 1];
      const double run = mesh.dy(j - 1) * mesh.dy(j - 1) - rise * rise;
      if (run <= 0)
        throw InputError(
            "dns.initial",
            fmt::format("the shape is steeper than the flag is long between y = {:.3g} and "
                        "{:.3g}; take smaller amplitudes",
                        mesh.y(j - 1), mesh.y(j)));
      node[dim - 2] = before[dim - 2] + std::sqrt(run);
    }
  return x;
}

template NodeVectors<2> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>&,
                                      const FlagMesh&);
template NodeVectors<3> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>&,
                                      const FlagMesh&);

}  // namespace pennon::dns
