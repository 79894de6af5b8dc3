#include "modes/global/study/fixed_points.hpp"

#include "dns/fluid/equations/ghosts.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// With ghosts for its derivatives.
Field<double> extended(Field<double> f) {
  dns::extrapolate_to_wall(0, f);
  dns::extend_outward(0, true, f);
  f.wrap_theta(0, -2, f.extent().n_rho + 2);
  return f;
}

// f - d . grad f_0.
Field<Complex> at_fixed_points(const Field<Complex>& f, const PlaneGradient<double>& gradient,
                               const Displacement<Complex>& d) {
  const auto centre = [](const Field<Complex>& corners, int j, int i) {
    const Complex *below = corners.row(0, j), *above = corners.row(0, j + 1);
    return 0.25 * (below[i] + below[i + 1] + above[i] + above[i + 1]);
  };
  Field<Complex> fixed(f.extent());
  for (int j = 0; j < f.extent().n_rho; ++j)
    for (int i = 0; i < f.extent().n_theta; ++i)
      fixed.row(0, j)[i] = f.row(0, j)[i] - centre(d.y, j, i) * gradient.y.row(0, j)[i] -
                           centre(d.z, j, i) * gradient.z.row(0, j)[i];
  return fixed;
}

}  // namespace

Displacement<Complex> displacement_of(const CoupledOperator& coupled, const Eigen::VectorXcd& q,
                                      Eigen::Index first) {
  const Extent extent{1, coupled.flow().rows(), 2 * coupled.flow().columns()};
  return MovingCorners(extent).unpack<Complex>(
      coupled.fluid().corners(q.segment(first, coupled.flag_nodes())));
}

FixedPoints::FixedPoints(const OGrid& grid, const BaseFlow& base) : base_(base.q) {
  PlaneEquations<double> equations(grid, base.parameters, base.q.components());
  PlaneFlow<double> R(base.q.p.extent(), base.q.components());
  equations.set_inflow(base.is_inflow);
  equations.evaluate(base_, nullptr, R, nullptr);  // for the ghosts
  base_vorticity_ = vorticity(equations.metrics(), base_);
  for (int f = 0; f < base_.fields(); ++f)
    gradients_.emplace_back(equations.metrics(), base_.field(f));
  gradients_.emplace_back(equations.metrics(), extended(base_vorticity_));
}

Field<Complex> FixedPoints::of_field(int field, const Field<Complex>& f,
                                     const Displacement<Complex>& d) const {
  return at_fixed_points(f, gradients_[static_cast<std::size_t>(field)], d);
}

Field<Complex> FixedPoints::of_vorticity(const Field<Complex>& f,
                                         const Displacement<Complex>& d) const {
  return at_fixed_points(f, gradients_.back(), d);
}

}  // namespace pennon::modes::global
