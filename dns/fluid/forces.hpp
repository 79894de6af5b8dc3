/// What the fluid does to the flag, and its budgets of momentum and kinetic energy.
///
/// The traction is -p n + 1/Re (n . grad) v, (2.3) without the part 1/Re (grad v) . n: on a wall
/// that part depends on the wall's velocity alone, and cancels between the flag's two sides.
///
/// Momentum and kinetic energy are those of the disturbance v' = v - (U, 1, 0), which are finite
/// however large the domain: with K = 1/2 int |v'|^2,
///
///   dK/dt = -(force on the flag) . (v_w - stream) - 1/Re int |grad v|^2
///           - int (u_n |v'|^2/2 + p v'_n) over the outer boundary.
#pragma once

#include <array>
#include <vector>

#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// Along x, y, z.
using Vector3 = std::array<double, 3>;

/// What the fluid does to the wall's faces, n_theta numbers for each plane. The forces act on
/// the flag; each is that of one face, per unit of x.
struct WallTraction {
  std::array<std::vector<double>, 3> force;  ///< along x, y, z, of pressure and friction
  std::vector<double> pressure;              ///< at the middle of the face
  std::vector<double> friction;              ///< shear stress along growing theta, rho_f V^2
};

/// Finds the friction on the wall, again and again in the same memory.
class WallFriction {
 public:
  explicit WallFriction(const Fluid&);

  /// Of a velocity (components as FluidState::u) about the wall as it moves now; no pressure.
  const WallTraction& find(const std::vector<Field<double>>& u);

 private:
  const Fluid& fluid_;
  Field<double> layer_, layer_xi_;  // the two cells next to the wall, and their derivative by x
  WallTraction traction_;
};

WallTraction wall_traction(const Fluid&, const FluidState&);
/// The pressure at the middle of the wall's faces.
void find_wall_pressure(const Field<double>& p, std::vector<double>& pressure);

/// The sum over both sides and the span, per unit of x: C_D and C_L are twice its y and z.
Vector3 total_force(const Fluid&, const WallTraction&);
/// The same of one plane: the force on the flag's station in it.
Vector3 plane_force(const Fluid&, const WallTraction&, int plane);

/// Per unit of x.
struct FluidBudget {
  double kinetic_energy = 0;  ///< of the disturbance
  Vector3 momentum{};         ///< of the disturbance
  double dissipation = 0;     ///< rate
  double wall_power = 0;      ///< what the flag does on the fluid
  double outer_power = 0;     ///< what enters through the outer boundary, by flow and by pressure
  Vector3 outer_force{};      ///< momentum that enters there
};

FluidBudget fluid_budget(const Fluid&, const FluidState&, const WallTraction&);

}  // namespace pennon::dns
