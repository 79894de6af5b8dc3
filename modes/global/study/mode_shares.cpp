#include "modes/global/study/mode_shares.hpp"

#include <algorithm>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

double energy_of_flag(const FlagOperator& flag, Complex lambda, const Eigen::VectorXcd& zeta) {
  const double kinetic = std::norm(lambda) * flag.mass.dot(zeta.cwiseAbs2());
  const double elastic = zeta.dot(flag.stiffness * zeta).real();
  return (kinetic + elastic) / 2;
}

// The share of a cell's area outside r = R/2: the last cells may be larger than R/2.
double share_outside(const OGrid& grid, int j, int i) {
  const auto r_squared = [&](int corner) {
    return std::norm(OGrid::place(grid.rho(corner), grid.theta_centre(i)) - 0.5);
  };
  const double R = grid.settings().R, inner = r_squared(j), outer = r_squared(j + 1);
  return std::clamp((outer - R * R / 4) / (outer - inner), 0.0, 1.0);
}

}  // namespace

EnergyShares energy_shares(const OGrid& grid, const CoupledOperator& coupled,
                           const FixedPoints& fixed_points, const Eigenpair& pair) {
  const HalfPlane& flow = coupled.flow();
  const Extent extent{1, flow.rows(), 2 * flow.columns()};
  PlaneFlow<Complex> moving(extent, flow.fields() - 1), fixed(extent, flow.fields() - 1);
  flow.unpack<Complex>(pair.q.head(flow.unknowns()), moving);
  const Displacement<Complex> d = displacement_of(coupled, pair.q, coupled.zeta(0));
  for (int f = 0; f < moving.components(); ++f)
    fixed.field(f) = fixed_points.of_field(f, moving.field(f), d);
  const Eigen::VectorXcd v = flow.pack(fixed), volume = coupled.fluid().B_vv.diagonal();
  EnergyShares share;
  share.flag = energy_of_flag(coupled.flag, pair.lambda,
                              pair.q.segment(coupled.zeta(0), coupled.flag_nodes()));
  // Both halves of the plane; the volume in the rows of the pressure is 0.
  flow.for_each([&](int, int j, int i, Eigen::Index k) {
    const bool is_in_wake =
        OGrid::place(grid.rho_centre(j), grid.theta_centre(i)).real() > wake_begin;
    const double outside = share_outside(grid, j, i), energy = volume[k].real() * std::norm(v[k]);
    share.outer += outside * energy;
    (is_in_wake ? share.wake : share.near) += (1 - outside) * energy;
  });
  const double total = share.flag + share.near + share.wake + share.outer;
  for (double* part : {&share.flag, &share.near, &share.wake, &share.outer}) *part /= total;
  return share;
}

}  // namespace pennon::modes::global
