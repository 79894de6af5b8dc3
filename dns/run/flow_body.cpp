#include "dns/run/flow_body.hpp"

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/coupling/mode_start.hpp"
#include "dns/flag/of_case.hpp"
#include "dns/run/flow_mode_file.hpp"
#include "dns/run/initial_shape.hpp"
#include "dns/run/state_file.hpp"

namespace pennon::dns {
namespace {

class PrescribedBody : public FlowBody {
 public:
  PrescribedBody(Fluid& fluid, WallMotion motion) : fluid_(fluid), motion_(std::move(motion)) {}

  FluidState& fluid() override { return state_; }
  const FluidState& fluid() const override { return state_; }
  void start(double) override { state_ = fluid_.impulsive_start(motion_, 0); }
  CoupledStepSummary advance(double dt) override {
    CoupledStepSummary summary;
    summary.fluid = fluid_.advance(state_, motion_, dt);
    return summary;
  }
  void keep_state() override { kept_ = state_; }
  void restore_state() override { state_ = kept_; }

 private:
  Fluid& fluid_;
  WallMotion motion_;
  FluidState state_, kept_;
};

template <int dim>
class CoupledBody : public FlowBody {
 public:
  CoupledBody(Fluid& fluid, const Settings& settings, const FlagParameters& parameters,
              const std::optional<ShapeFunction>& zeta)
      : fluid_(fluid),
        parameters_(parameters),
        initial_(settings.initial),
        flag_(mesh_of(settings.flag, settings.n_x, parameters, coupled_chord(fluid.grid())),
              material_of(parameters)),
        gravity_(Eigen::Map<const Eigen::Vector3d>(parameters.gravity.data()).template tail<dim>()),
        shape_(stretched_by_friction<dim>(flag_.mesh(),
                                          initial_shape<dim>(initial_, zeta, flag_.mesh()),
                                          parameters.K_S, fluid.parameters().Re)),
        coupling_(fluid, flag_, gravity_, settings.coupling) {}

  FluidState& fluid() override { return state_.fluid; }
  const FluidState& fluid() const override { return state_.fluid; }
  void start(double dt) override {
    if (initial_.global_modes.empty()) {
      state_ = coupling_.start(shape_, 0);
    } else {
      const FlowMode mode = read_flow_mode(
          initial_.global_modes, static_cast<int>(initial_.global_mode), fluid_, parameters_);
      state_ = start_in_mode(coupling_, fluid_, flag_, mode, initial_.mode_amplitude, dt);
    }
    energy_at_start_ = energies().total();
  }

  CoupledStepSummary advance(double dt) override {
    constexpr double slack = 1e-9;  // of a step
    if (state_.fluid.t + (1 - slack) * dt < initial_.release)
      return coupling_.advance_held(state_, dt);
    kick(state_.fluid.t + dt);
    return coupling_.advance(state_, dt);
  }

  void keep_state() override {
    kept_ = state_;
    kept_tangent_ = coupling_.kept_tangent();
  }
  void restore_state() override {
    state_ = kept_;
    is_restored_ = true;
  }

  void complete_row(const CoupledStepSummary& summary, FluidHistory& history) const override {
    const FlagEnergies e = energies();
    const double share = dim == 2 ? 1.0 : 1 / flag_.mesh().span();
    const auto [least, greatest] = flag_.stretch().strain_range(state_.flag.x);
    const FlagMesh& mesh = flag_.mesh();
    const double defect = e.total() - energy_at_start_ + state_.flag.dissipated - state_.flag.work;
    history.flag.push_back(
        {share * e.kinetic, share * e.bending, share * e.stretch_2d, share * e.stretch_3d,
         share * e.gravity, share * state_.flag.dissipated, share * state_.flag.work,
         share * defect, static_cast<double>(summary.passes), summary.residual, least, greatest});
    for (int m = 0; m < mesh.stations(); ++m) {
      const auto end = state_.flag.x.col(mesh.index(m, mesh.chord_nodes() - 1));
      history.trailing_edge.insert(history.trailing_edge.end(),
                                   {dim == 3 ? end[0] : 0.0, end[dim - 2], end[dim - 1]});
    }
    constexpr std::size_t trailing_edge_column = 2;
    history.rows.back()[trailing_edge_column] = state_.flag.x(dim - 1, mesh.chord_nodes() - 1);
  }

  void add_shape(FluidHistory& history) const override {
    dns::add_shape(flag_, state_.flag.t, state_.flag.x, state_.flag.v, history.shapes);
  }

  void write(hdf5::Writer& file) const override {
    write_flag_of(state_, energy_at_start_, file);
    write_tangent(is_restored_ ? kept_tangent_ : coupling_.kept_tangent(), file);
  }

  void read(const hdf5::Reader& file) override {
    energy_at_start_ = read_flag_of(file, flag_.mesh().nodes(), flag_.mesh().stations(), state_);
    keep_tangent_of(file, coupling_);
  }

 private:
  FlagEnergies energies() const {
    FlagLoads<dim> loads;
    loads.gravity = gravity_;
    return flag_.energies(state_.flag.x, state_.flag.v, loads);
  }

  // A force along z for a while after the release: the momentum per area initial_.kick at the
  // trailing edge, less toward the leading edge.
  void kick(double t) {
    const double since = t - initial_.release, duration = initial_.kick_duration;
    if (initial_.kick == 0 || since < 0 || since >= duration) {
      coupling_.set_outer_force({});
      return;
    }
    const double pulse = 2 / duration * std::pow(std::sin(std::numbers::pi * since / duration), 2);
    const FlagMesh& mesh = flag_.mesh();
    NodeVectors<dim> force = NodeVectors<dim>::Zero(dim, mesh.nodes());
    for (int m = 0; m < mesh.stations(); ++m)
      for (int j = 0; j < mesh.chord_nodes(); ++j)
        force(dim - 1, mesh.index(m, j)) = initial_.kick * pulse * mesh.y(j) * mesh.area(m, j);
    coupling_.set_outer_force(std::move(force));
  }

  const Fluid& fluid_;
  FlagParameters parameters_;
  InitialSettings initial_;
  Flag<dim> flag_;
  Eigen::Matrix<double, dim, 1> gravity_;
  NodeVectors<dim> shape_;
  Coupling<dim> coupling_;
  CoupledState<dim> state_, kept_;
  std::optional<KeptTangent> kept_tangent_;  // with kept_
  bool is_restored_ = false;
  double energy_at_start_ = 0;
};

}  // namespace

std::unique_ptr<FlowBody> prescribed_body(Fluid& fluid, WallMotion motion) {
  return std::make_unique<PrescribedBody>(fluid, std::move(motion));
}

std::unique_ptr<FlowBody> coupled_body(Fluid& fluid, const Settings& settings,
                                       const FlagParameters& parameters,
                                       const std::optional<ShapeFunction>& zeta) {
  if (parameters.gamma) return std::make_unique<CoupledBody<3>>(fluid, settings, parameters, zeta);
  return std::make_unique<CoupledBody<2>>(fluid, settings, parameters, zeta);
}

}  // namespace pennon::dns
