#include "dns/run/initial_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::dns {
namespace {

// Moves the nodes with the chordwise index j along x until the segments between them, and across
// the seam, are of one length.
void share_strain(const FlagMesh& mesh, int j, NodeVectors<3>& x) {
  const int stations = mesh.stations();
  Eigen::ArrayXd rise_squared(stations);
  for (int m = 0; m < stations; ++m) {
    const Eigen::Vector3d rise = x.col(mesh.index((m + 1) % stations, j)) - x.col(mesh.index(m, j));
    rise_squared[m] = rise.tail<2>().squaredNorm();
  }
  const double steepest = std::sqrt(rise_squared.maxCoeff());
  if ((steepest * steepest - rise_squared).sqrt().sum() > mesh.span())
    throw InputError(
        "dns.initial",
        fmt::format("makes a shape that along the span, at y = {:.3g}, is steeper than "
                    "the flag is long; take smaller amplitudes",
                    mesh.y(j)));
  // The length l for which the runs (l^2 - rise^2)^1/2 add up to the span. Their sum is a concave
  // function of l, for which Newton's method comes up to it from below; a first step that leads
  // below the steepest rise is cut.
  double length = mesh.dx() + steepest;
  constexpr int most_iterations = 100;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Eigen::ArrayXd runs = (length * length - rise_squared).sqrt();
    const double change = (runs.sum() - mesh.span()) / (length / runs).sum();
    length = std::max(length - change, (length + steepest) / 2);
    if (std::abs(change) < 1e-15 * length) break;
  }
  const Eigen::ArrayXd runs = (length * length - rise_squared).sqrt();
  for (int m = 1; m < stations; ++m)
    x(0, mesh.index(m, j)) = x(0, mesh.index(m - 1, j)) + runs[m - 1];
}

}  // namespace

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
            fmt::format(
                "makes a shape that is steeper than the flag is long between y = {:.3g} and "
                "{:.3g}; take smaller amplitudes",
                mesh.y(j - 1), mesh.y(j)));
      node[dim - 2] = before[dim - 2] + std::sqrt(run);
    }
  if constexpr (dim == 3)
    if (mesh.is_periodic())
      for (int j = 1; j < mesh.chord_nodes(); ++j) share_strain(mesh, j, x);
  return x;
}

template NodeVectors<2> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>&,
                                      const FlagMesh&);
template NodeVectors<3> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>&,
                                      const FlagMesh&);

}  // namespace pennon::dns
