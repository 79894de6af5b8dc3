#include "dns/fluid/forces.hpp"

#include <algorithm>
#include <cmath>

#include "common/parallel/ranks.hpp"
#include "dns/fluid/equations/wall_forces.hpp"

namespace pennon::dns {
namespace {

bool has(const Fluid& fluid, std::size_t axis) {
  return static_cast<int>(component_of[axis]) < fluid.components();
}

// A component with its ghosts, and its derivative by x where there is a span.
struct Extended {
  Field<double> f, f_xi;

  Extended(const Fluid& fluid, const FluidState& state, std::size_t axis)
      : f(state.u[component_of[axis]]) {
    fluid.extend_velocity(component_of[axis], f);
    if (!fluid.span().has_span()) return;
    f_xi = Field<double>(f.extent());
    fluid.span().differentiate(f, f_xi);
  }
  const Field<double>* slope() const { return f_xi.empty() ? nullptr : &f_xi; }
};

}  // namespace

void find_wall_pressure(const Field<double>& p, std::vector<double>& pressure) {
  const Extent& extent = p.extent();
  pressure.resize(extent.wall_faces());
  for (int plane = 0; plane < extent.planes; ++plane)
    wall_pressure_of(plane, p, pressure.data() + extent.wall_face(plane, 0));
}

WallFriction::WallFriction(const Fluid& fluid)
    : fluid_(fluid), layer_(Extent{fluid.extent().planes, 2, fluid.extent().n_theta}) {
  if (fluid.span().has_span()) layer_xi_ = Field<double>(layer_.extent());
  for (std::vector<double>* values : {&traction_.pressure, &traction_.friction, &traction_.force[0],
                                      &traction_.force[1], &traction_.force[2]})
    values->assign(fluid.extent().wall_faces(), 0);
}

const WallTraction& WallFriction::find(const std::vector<Field<double>>& u) {
  const Extent& extent = fluid_.extent();
  const FaceMetrics<double>& faces = fluid_.metrics().rho_faces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!has(fluid_, axis)) continue;
    const std::size_t component = component_of[axis];
    for (int plane = 0; plane < extent.planes; ++plane) {
      for (int j = 0; j < layer_.extent().n_rho; ++j)
        std::copy_n(u[component].row(plane, j), extent.n_theta, layer_.row(plane, j));
      extend_inward(plane, fluid_.wall_velocity()[component].data() + extent.wall_face(plane, 0),
                    layer_);
    }
    if (!layer_xi_.empty()) fluid_.span().differentiate(layer_, layer_xi_);
    for (int plane = 0; plane < extent.planes; ++plane)
      wall_friction_of(fluid_.metrics(), plane, 1 / fluid_.parameters().Re, layer_,
                       layer_xi_.empty() ? nullptr : &layer_xi_,
                       traction_.force[axis].data() + extent.wall_face(plane, 0));
  }
  for (int plane = 0; plane < extent.planes; ++plane)
    for (int i = 0; i < extent.n_theta; ++i) {
      const std::size_t face = extent.wall_face(plane, i);
      const double A_y = faces.area_y.row(plane, 0)[i], A_z = faces.area_z.row(plane, 0)[i];
      // The tangent of growing theta is (-A_z, A_y)/|A|.
      traction_.friction[face] = (traction_.force[2][face] * A_y - traction_.force[1][face] * A_z) /
                                 (A_y * A_y + A_z * A_z);
    }
  return traction_;
}

WallTraction wall_traction(const Fluid& fluid, const FluidState& state) {
  const Extent& extent = fluid.extent();
  const FaceMetrics<double>& faces = fluid.metrics().rho_faces;
  WallTraction traction = WallFriction(fluid).find(state.u);
  find_wall_pressure(state.p, traction.pressure);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Field<double>& area = area_along(faces, component_of[axis]);
    if (area.empty()) continue;
    for (int plane = 0; plane < extent.planes; ++plane)
      for (int i = 0; i < extent.n_theta; ++i) {
        const std::size_t face = extent.wall_face(plane, i);
        traction.force[axis][face] -= traction.pressure[face] * area.row(plane, 0)[i];
      }
  }
  return traction;
}

Vector3 plane_force(const Fluid& fluid, const WallTraction& traction, int plane) {
  const auto n_theta = static_cast<std::size_t>(fluid.extent().n_theta);
  Vector3 sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < n_theta; ++i)
      sum[axis] += traction.force[axis][static_cast<std::size_t>(plane) * n_theta + i];
  return sum;
}

Vector3 total_force(const Fluid& fluid, const WallTraction& traction) {
  Vector3 mean{};
  for (int plane = 0; plane < fluid.extent().planes; ++plane) {
    const Vector3 force = plane_force(fluid, traction, plane);
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += force[axis] / fluid.span().planes();
  }
  ranks::sum(mean);
  return mean;
}

FluidBudget fluid_budget(const Fluid& fluid, const FluidState& state,
                         const WallTraction& traction) {
  const Extent& extent = fluid.extent();
  const Metrics<double>& metrics = fluid.metrics();
  const bool has_span = fluid.span().has_span();
  const double share = 1.0 / fluid.span().planes(), nu = 1 / fluid.parameters().Re;
  const Vector3 stream = {fluid.stream(along_x), fluid.stream(along_y), 0};
  const std::array<const Field<double>*, 3> outer_areas = {nullptr, &metrics.rho_faces.area_y,
                                                           &metrics.rho_faces.area_z};
  FluidBudget budget;
  Field<double> u_x(has_span ? extent : Extent{0, 0, 0}), u_y(extent), u_z(extent);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!has(fluid, axis)) continue;
    const Extended u(fluid, state, axis);
    for (int plane = 0; plane < extent.planes; ++plane) {
      gradient(metrics, plane, u.f, u.slope(), {has_span ? &u_x : nullptr, &u_y, &u_z});
      for (int j = 0; j < extent.n_rho; ++j)
        for (int i = 0; i < extent.n_theta; ++i) {
          const double volume = share * metrics.volume.row(plane, j)[i];
          const double disturbance = u.f.row(plane, j)[i] - stream[axis];
          budget.kinetic_energy += volume * disturbance * disturbance / 2;
          budget.momentum[axis] += volume * disturbance;
          const double x = has_span ? u_x.row(plane, j)[i] : 0.0, y = u_y.row(plane, j)[i],
                       z = u_z.row(plane, j)[i];
          budget.dissipation += nu * volume * (x * x + y * y + z * z);
        }
      const int n = extent.n_rho;
      for (int i = 0; i < extent.n_theta; ++i) {
        const std::size_t face = extent.wall_face(plane, i);
        // Convection and pressure, in the disturbance as the last cells hold it.
        const double flux = share * fluid.flux_across_rho().row(plane, n)[i];
        const double outside =
            outside_value(u.f.row(plane, n - 1)[i], u.f.row(plane, n - 2)[i]) - stream[axis];
        const double push = outer_areas[axis] ? share * fluid.outer_pressure()[face] *
                                                    outer_areas[axis]->row(plane, n)[i]
                                              : 0.0;
        budget.outer_power -= flux * outside * outside / 2 + push * outside;
        budget.outer_force[axis] -= flux * outside + push;
        budget.wall_power -= share * traction.force[axis][face] *
                             (fluid.wall_velocity()[component_of[axis]][face] - stream[axis]);
      }
    }
  }
  for (double* value :
       {&budget.kinetic_energy, &budget.dissipation, &budget.wall_power, &budget.outer_power})
    *value = ranks::sum(*value);
  ranks::sum(budget.momentum);
  ranks::sum(budget.outer_force);
  return budget;
}

}  // namespace pennon::dns
