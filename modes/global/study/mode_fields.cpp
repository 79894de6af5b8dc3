#include "modes/global/study/mode_fields.hpp"

#include "dns/fluid/equations/ghosts.hpp"
#include "modes/global/equations/jacobian.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

template <class Scalar>
struct PlaneGradient {
  Field<Scalar> y, z;

  // f with its ghosts.
  PlaneGradient(const dns::Metrics<Scalar>& metrics, const Field<Scalar>& f)
      : y(f.extent()), z(f.extent()) {
    dns::gradient<Scalar>(metrics, 0, f, nullptr, {nullptr, &y, &z});
  }
};

// omega_x; the ghosts of v and w as PlaneEquations left them.
template <class Scalar>
Field<Scalar> vorticity(const dns::Metrics<Scalar>& metrics, const PlaneFlow<Scalar>& q) {
  const PlaneGradient<Scalar> v(metrics, q.u[dns::along_y]), w(metrics, q.u[dns::along_z]);
  Field<Scalar> omega = w.y;
  for (std::size_t k = 0; k < omega.values().size(); ++k) omega.values()[k] -= v.z.values()[k];
  return omega;
}

// With ghosts for its derivatives.
Field<double> extended(Field<double> f) {
  dns::extrapolate_to_wall(0, f);
  dns::extend_outward(0, true, f);
  f.wrap_theta(0, -2, f.extent().n_rho + 2);
  return f;
}

class FieldsOfPair {
 public:
  FieldsOfPair(const OGrid& grid, const BaseFlow& base, const CoupledOperator& coupled)
      : coupled_(coupled),
        equations_(grid, base.parameters, base.q.components()),
        complex_equations_(grid, base.parameters, base.q.components()),
        base_(base.q),
        work_(base.q.p.extent(), base.q.components()),
        complex_work_(work_.p.extent(), base.q.components()) {
    PlaneFlow<double> R(work_);
    equations_.set_inflow(base.is_inflow);
    complex_equations_.set_inflow(base.is_inflow);
    equations_.evaluate(base_, nullptr, R, nullptr);  // for the ghosts
    base_vorticity_ = vorticity(equations_.metrics(), base_);
    for (int f = 0; f < base_.fields(); ++f)
      gradients_.emplace_back(equations_.metrics(), base_.field(f));
    gradients_.emplace_back(equations_.metrics(), extended(base_vorticity_));
  }

  const Field<double>& base_vorticity() const { return base_vorticity_; }

  ModeFields operator()(const Eigenpair& pair) {
    const Complex scale = scale_of(pair, coupled_);
    const Eigen::VectorXcd q = pair.q / scale;
    const Extent& extent = base_.p.extent();
    ModeFields mode{PlaneFlow<Complex>(extent, base_.components()),
                    Field<Complex>(extent),
                    PlaneFlow<Complex>(extent, base_.components()),
                    Field<Complex>(extent),
                    displaced(q, coupled_.zeta(0)),
                    {}};
    coupled_.flow().unpack<Complex>(q.head(coupled_.flow().unknowns()), mode.moving);
    mode.moving_vorticity = change_of_vorticity(mode, displaced(q, coupled_.zeta_t(0)));
    for (int f = 0; f < base_.fields(); ++f)
      at_fixed_points(mode.moving.field(f), gradients_[static_cast<std::size_t>(f)],
                      mode.displacement, mode.fixed.field(f));
    at_fixed_points(mode.moving_vorticity, gradients_.back(), mode.displacement,
                    mode.fixed_vorticity);
    const Eigen::Index nodes = coupled_.flow().columns() + 1;
    mode.zeta.assign(static_cast<std::size_t>(nodes - coupled_.flag_nodes()), 0);
    for (Eigen::Index node = 0; node < coupled_.flag_nodes(); ++node)
      mode.zeta.push_back(q[coupled_.zeta(node)]);
    if (pair.p.size() > 0) mode.adjoint = adjoint_fields(pair, coupled_, mode.fixed, scale);
    return mode;
  }

 private:
  // The corners, as the flag's nodes move by the unknowns from the first on.
  Displacement<Complex> displaced(const Eigen::VectorXcd& q, Eigen::Index first) const {
    return MovingCorners(base_.p.extent())
        .unpack<Complex>(coupled_.fluid().corners(q.segment(first, coupled_.flag_nodes())));
  }

  // At points that move with the grid: a complex step for the real part of the mode and one for
  // the imaginary part, of the velocities, the metrics and the wall's velocity.
  Field<Complex> change_of_vorticity(const ModeFields& mode, const Displacement<Complex>& moved) {
    Field<Complex> change(base_.p.extent());
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
      PlaneFlow<Complex> q = complex_flow(base_);
      for (int f = 0; f < q.fields(); ++f)
        for (std::size_t k = 0; k < q.p.values().size(); ++k)
          q.field(f).values()[k] += step(mode.moving.field(f).values()[k]);
      complex_equations_.set_grid(steps(mode.displacement), nullptr);
      complex_equations_.set_grid_velocity(steps(moved));
      complex_equations_.evaluate(q, nullptr, complex_work_, nullptr);
      const Field<Complex> omega = vorticity(complex_equations_.metrics(), q);
      for (std::size_t k = 0; k < omega.values().size(); ++k)
        change.values()[k] += unit * omega.values()[k].imag() / complex_step;
    }
    return change;
  }

  // f - d . grad F.
  static void at_fixed_points(const Field<Complex>& f, const PlaneGradient<double>& gradient,
                              const Displacement<Complex>& d, Field<Complex>& fixed) {
    const auto centre = [](const Field<Complex>& corners, int j, int i) {
      const Complex *below = corners.row(0, j), *above = corners.row(0, j + 1);
      return 0.25 * (below[i] + below[i + 1] + above[i] + above[i + 1]);
    };
    for (int j = 0; j < f.extent().n_rho; ++j)
      for (int i = 0; i < f.extent().n_theta; ++i)
        fixed.row(0, j)[i] = f.row(0, j)[i] - centre(d.y, j, i) * gradient.y.row(0, j)[i] -
                             centre(d.z, j, i) * gradient.z.row(0, j)[i];
  }

  const CoupledOperator& coupled_;
  PlaneEquations<double> equations_;
  PlaneEquations<Complex> complex_equations_;
  PlaneFlow<double> base_, work_;
  PlaneFlow<Complex> complex_work_;
  Field<double> base_vorticity_;
  std::vector<PlaneGradient<double>> gradients_;  // of the fields, then of the vorticity
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
