#include "modes/global/study/mode_fields.hpp"

#include "modes/global/equations/jacobian.hpp"
#include "modes/global/study/fixed_points.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

class FieldsOfPair {
 public:
  FieldsOfPair(const OGrid& grid, const BaseFlow& base, const CoupledOperator& coupled)
      : coupled_(coupled),
        fixed_points_(grid, base),
        equations_(grid, base.parameters, base.q.components()),
        work_(base.q.p.extent(), base.q.components()) {
    equations_.set_inflow(base.is_inflow);
  }

  const Field<double>& base_vorticity() const { return fixed_points_.base_vorticity(); }

  ModeFields operator()(const Eigenpair& pair) {
    const Complex scale = scale_of(pair, coupled_);
    const Eigen::VectorXcd q = pair.q / scale;
    const PlaneFlow<double>& base = fixed_points_.base();
    const Extent& extent = base.p.extent();
    ModeFields mode{PlaneFlow<Complex>(extent, base.components()),  Field<Complex>(extent),
                    PlaneFlow<Complex>(extent, base.components()),  Field<Complex>(extent),
                    displacement_of(coupled_, q, coupled_.zeta(0)), {}};
    coupled_.flow().unpack<Complex>(q.head(coupled_.flow().unknowns()), mode.moving);
    mode.moving_vorticity =
        change_of_vorticity(mode, displacement_of(coupled_, q, coupled_.zeta_t(0)));
    for (int f = 0; f < base.fields(); ++f)
      mode.fixed.field(f) = fixed_points_.of_field(f, mode.moving.field(f), mode.displacement);
    mode.fixed_vorticity = fixed_points_.of_vorticity(mode.moving_vorticity, mode.displacement);
    const Eigen::Index nodes = coupled_.flow().columns() + 1;
    mode.zeta.assign(static_cast<std::size_t>(nodes - coupled_.flag_nodes()), 0);
    for (Eigen::Index node = 0; node < coupled_.flag_nodes(); ++node)
      mode.zeta.push_back(q[coupled_.zeta(node)]);
    if (pair.p.size() > 0) mode.adjoint = adjoint_fields(pair, coupled_, mode.fixed, scale);
    return mode;
  }

 private:
  // At points that move with the grid: a complex step for the real part of the mode and one for
  // the imaginary part, of the velocities, the metrics and the wall's velocity.
  Field<Complex> change_of_vorticity(const ModeFields& mode, const Displacement<Complex>& moved) {
    const PlaneFlow<double>& base = fixed_points_.base();
    Field<Complex> change(base.p.extent());
    for (const Complex unit : {Complex(1, 0), Complex(0, 1)}) {
      const auto step = [&](const Complex& value) {
        return Complex(0, complex_step * (std::conj(unit) * value).real());
      };
      const auto steps = [&](const Displacement<Complex>& d) {
        Displacement<Complex> result(d);
        for (Complex& value : result.y.values()) value = step(value);
        for (Complex& value : result.z.values()) value = step(value);
        return result;
      };
      PlaneFlow<Complex> q = complex_flow(base);
      for (int f = 0; f < q.fields(); ++f)
        for (std::size_t k = 0; k < q.p.values().size(); ++k)
          q.field(f).values()[k] += step(mode.moving.field(f).values()[k]);
      equations_.set_grid(steps(mode.displacement), nullptr);
      equations_.set_grid_velocity(steps(moved));
      equations_.evaluate(q, nullptr, work_, nullptr);
      const Field<Complex> omega = vorticity(equations_.metrics(), q);
      for (std::size_t k = 0; k < omega.values().size(); ++k)
        change.values()[k] += unit * omega.values()[k].imag() / complex_step;
    }
    return change;
  }

  const CoupledOperator& coupled_;
  FixedPoints fixed_points_;
  PlaneEquations<Complex> equations_;
  PlaneFlow<Complex> work_;
};

std::vector<double> points_of(const OGrid& grid, const Extent& extent) {
  const std::size_t corners =
      static_cast<std::size_t>(extent.n_rho + 1) * static_cast<std::size_t>(extent.n_theta + 1);
  std::vector<double> y(corners), z(corners), points;
  corners_of(grid, 0, Displacement<double>(extent), y.data(), z.data());
  points.reserve(2 * corners);
  for (std::size_t k = 0; k < corners; ++k) points.insert(points.end(), {y[k], z[k]});
  return points;
}

}  // namespace

Complex scale_of(const Eigenpair& pair, const CoupledOperator& coupled) {
  const Eigen::VectorXcd zeta = pair.q.segment(coupled.zeta(0), coupled.flag_nodes());
  Eigen::Index largest = 0;
  zeta.cwiseAbs().maxCoeff(&largest);
  return zeta[largest] == 0.0 ? Complex(1) : zeta[largest];
}

FieldsOfModes fields_of_modes(const OGrid& grid, const BaseFlow& base,
                              const CoupledOperator& coupled, const std::vector<Eigenpair>& pairs) {
  FieldsOfPair fields_of(grid, base, coupled);
  FieldsOfModes fields{points_of(grid, base.q.p.extent()), fields_of.base_vorticity(), {}};
  fields.modes.reserve(pairs.size());
  for (const Eigenpair& pair : pairs) fields.modes.push_back(fields_of(pair));
  return fields;
}

}  // namespace pennon::modes::global
