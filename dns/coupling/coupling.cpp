#include "dns/coupling/coupling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/parallel/interrupted_step.hpp"
#include "common/parallel/ranks.hpp"
#include "common/stop_watch.hpp"

namespace pennon::dns {
namespace {

// The grid's wall is led back to the flag, from which it strays by what the extrapolation misses,
// at this rate, in V/L.
constexpr double rate_of_return = 1;

}  // namespace

template <int dim>
NodeVectors<dim> stretched_by_friction(const FlagMesh& mesh, const NodeVectors<dim>& x, double K_S,
                                       double Re) {
  NodeVectors<dim> stretched = x;
  for (int m = 0; m < mesh.stations(); ++m)
    for (int j = 1; j < mesh.chord_nodes(); ++j) {
      const double tension = 1.3 / std::sqrt(Re) * (1 - std::sqrt((mesh.y(j - 1) + mesh.y(j)) / 2));
      const int node = mesh.index(m, j);
      stretched.col(node) =
          stretched.col(node - 1) + (1 + tension / K_S) * (x.col(node) - x.col(node - 1));
    }
  return stretched;
}

template <int dim>
Coupling<dim>::Coupling(Fluid& fluid, const Flag<dim>& flag,
                        const Eigen::Matrix<double, dim, 1>& gravity,
                        const CouplingSettings& settings)
    : fluid_(fluid),
      flag_(flag),
      grid_(fluid.grid()),
      settings_(settings),
      added_mass_(fluid.grid(), flag.mesh(), flag.material().mu),
      friction_(fluid),
      newton_(flag, {.contraction = usual_contraction<dim>}),
      acceleration_(Eigen::Index{flag.mesh().stations()} * (flag.mesh().chord_nodes() - 1),
                    static_cast<int>(settings.most_passes)),
      stations_(flag.mesh().stations()),
      segments_(flag.mesh().chord_nodes() - 1),
      weights_(stations_, segments_) {
  equation_.loads.gravity = gravity;
  equation_.added_mass = &added_mass_;
  for (int s = 0; s < segments_; ++s)
    weights_.col(s).setConstant(std::sqrt(flag.mesh().dy(s) / stations_));
}

template <int dim>
CoupledState<dim> Coupling<dim>::start(const NodeVectors<dim>& x, double t) {
  CoupledState<dim> state;
  state.flag.t = t;
  state.flag.x = x;
  state.flag.v = NodeVectors<dim>::Zero(dim, x.cols());
  state.fluid = fluid_.impulsive_start([&](double, WallShape& wall) { wall = wall_of(x); }, t);
  return state;
}

// --- From the flag to the fluid's wall, and back

template <int dim>
void Coupling<dim>::place_wall(const NodeVectors<dim>& x, WallShape& wall) const {
  const Extent& extent = fluid_.extent();
  wall.y.resize(extent.wall_faces());
  wall.z.resize(extent.wall_faces());
  for (int plane = 0; plane < extent.planes; ++plane)
    for (int i = 0; i < extent.n_theta; ++i) {
      const int j = std::abs(extent.n_theta / 2 - i);
      const auto node = x.col(flag_.mesh().index(fluid_.span().first_plane() + plane, j));
      wall.y[extent.wall_face(plane, i)] = node[dim - 2] - flag_.mesh().y(j);
      wall.z[extent.wall_face(plane, i)] = node[dim - 1];
    }
}

template <int dim>
WallShape Coupling<dim>::wall_of(const NodeVectors<dim>& x) const {
  WallShape wall;
  place_wall(x, wall);
  return wall;
}

template <int dim>
void Coupling<dim>::find_velocity_ahead(const CoupledState<dim>& state, const BackwardDifference& D,
                                        NodeVectors<dim>& velocity) const {
  velocity = D.guess_last * state.flag.v;
  if (D.guess_before != 0) velocity += D.guess_before * state.flag.previous_v;
}

// The wall at the end of the step: its velocity by backward differences is the flag's,
// extrapolated.
template <int dim>
void Coupling<dim>::place_wall_ahead(const CoupledState<dim>& state,
                                     const NodeVectors<dim>& velocity, const BackwardDifference& D,
                                     WallShape& wall) const {
  const Extent& extent = fluid_.extent();
  place_wall(state.flag.x, wall);
  for (int plane = 0; plane < extent.planes; ++plane)
    for (int i = 0; i < extent.n_theta; ++i) {
      const int j = std::abs(extent.n_theta / 2 - i);
      const auto v = velocity.col(flag_.mesh().index(fluid_.span().first_plane() + plane, j));
      const std::size_t face = extent.wall_face(plane, i);
      const auto ahead = [&](double v_c, double at_flag, Field<double> Displacement<double>::*c) {
        const double last = (state.fluid.grid[0].*c).row(plane, 0)[i];
        const double before = (state.fluid.grid[1].*c).row(plane, 0)[i];
        return (v_c + rate_of_return * (at_flag - last) - D.last * last - D.before * before) /
               D.next;
      };
      wall.y[face] = ahead(v[dim - 2], wall.y[face], &Displacement<double>::y);
      wall.z[face] = ahead(v[dim - 1], wall.z[face], &Displacement<double>::z);
    }
}

// What append(plane, s, values) adds for each segment s of the planes here; of all ranks.
template <int dim>
template <class Append>
const std::vector<double>& Coupling<dim>::gather(const Append& append) {
  here_.clear();
  for (int plane = 0; plane < fluid_.extent().planes; ++plane)
    for (int s = 0; s < segments_; ++s) append(plane, s, here_);
  ranks::gather_all(here_, gathered_);
  return gathered_;
}

// Of the segments, as their upper faces have them.
template <int dim>
void Coupling<dim>::find_areas(NodeVectors<dim>& areas) {
  const FaceMetrics<double>& faces = fluid_.metrics().rho_faces;
  const int n_theta = grid_.n_theta();
  const std::vector<double>& all = gather([&](int plane, int s, std::vector<double>& values) {
    for (std::size_t axis = 3 - dim; axis < 3; ++axis)
      values.push_back(area_along(faces, component_of[axis]).row(plane, 0)[upper_face(n_theta, s)]);
  });
  areas = Eigen::Map<const NodeVectors<dim>>(all.data(), dim, Eigen::Index{stations_} * segments_);
}

// Those on the nodes that the passes do not change: the friction of both sides and outer_force_.
template <int dim>
void Coupling<dim>::find_fixed_forces(NodeVectors<dim>& forces) {
  const WallTraction& traction = friction_.find(fluid_.predicted_velocity());
  const Extent& extent = fluid_.extent();
  const std::vector<double>& all = gather([&](int plane, int s, std::vector<double>& values) {
    for (std::size_t axis = 3 - dim; axis < 3; ++axis)
      values.push_back(sum_of_sides(extent.n_theta, s,
                                    traction.force[axis].data() + extent.wall_face(plane, 0)));
  });
  const double half = 0.5 * (dim == 2 ? 1.0 : flag_.mesh().dx());
  forces = outer_force_;
  if (forces.size() == 0) forces.setZero(dim, flag_.mesh().nodes());
  const double* force = all.data();
  for (int m = 0; m < stations_; ++m)
    for (int s = 0; s < segments_; ++s, force += dim) {
      const Eigen::Map<const Eigen::Matrix<double, dim, 1>> of_segment(force);
      forces.col(flag_.mesh().index(m, s)) += half * of_segment;
      forces.col(flag_.mesh().index(m, s + 1)) += half * of_segment;
    }
}

// [p], the pressure below less that above: of the sign opposite to AddedMass::find_response().
template <int dim>
void Coupling<dim>::find_jump(const FluidState& state, SegmentValues& jump) {
  find_wall_pressure(state.p, wall_pressure_);
  const Extent& extent = fluid_.extent();
  const std::vector<double>& all = gather([&](int plane, int s, std::vector<double>& values) {
    values.push_back(
        pressure_jump(extent.n_theta, s, wall_pressure_.data() + extent.wall_face(plane, 0)));
  });
  jump = Eigen::Map<const SegmentValues>(all.data(), stations_, segments_);
}

template <int dim>
void Coupling<dim>::move_wall(const NodeVectors<dim>& v) {
  const Extent& extent = fluid_.extent();
  face_velocity_.resize(extent.wall_faces());
  for (std::size_t axis = 3 - dim; axis < 3; ++axis) {
    for (int plane = 0; plane < extent.planes; ++plane)
      for (int s = 0; s < segments_; ++s) {
        const int node = flag_.mesh().index(fluid_.span().first_plane() + plane, s);
        const auto row = static_cast<Eigen::Index>(axis) - (3 - dim);
        const double mean = 0.5 * (v(row, node) + v(row, node + 1));
        face_velocity_[extent.wall_face(plane, upper_face(extent.n_theta, s))] = mean;
        face_velocity_[extent.wall_face(plane, lower_face(extent.n_theta, s))] = mean;
      }
    fluid_.set_wall_velocity(component_of[axis], face_velocity_);
  }
}

// --- The step

template <int dim>
void Coupling<dim>::guess_reduced_jump(const CoupledState<dim>& state, const BackwardDifference& D,
                                       SegmentValues& g) const {
  if (state.reduced_jump.size() == 0)
    g.setZero(stations_, segments_);
  else if (state.previous_reduced_jump.size() == 0)
    g = state.reduced_jump;
  else
    g = D.guess_last * state.reduced_jump + D.guess_before * state.previous_reduced_jump;
}

template <int dim>
double Coupling<dim>::root_mean_square(const SegmentValues& jump) const {
  return jump.cwiseProduct(weights_).norm();
}

// The flag's end of the step under fixed_ and the reduced jump g_: x_, v_, a_.
template <int dim>
void Coupling<dim>::solve_flag(const CoupledState<dim>& state, CoupledStepSummary& summary) {
  const StopWatch watch;
  equation_.loads.node_forces = fixed_;
  added_mass_.add_force(g_, equation_.loads.node_forces);
  StepSummary newton;
  if (!newton_.solve(state.flag.x, equation_, x_, v_, newton))
    throw SolverError(fmt::format(
        "at t = {:.6g}: the flag's step did not converge in {} Newton iterations, the "
        "last moved a node by {:.3g} L; try a smaller dns.dt or dns.first_dt, or another "
        "flag.damping; runs were tried with flag.mu from 1e-4 and flag.K_S to 1e5",
        state.fluid.t, newton.iterations, newton_.last_change()));
  a_ = equation_.mass_factor * (x_ - equation_.inertial);
  summary.flag_iterations += newton.iterations;
  summary.flag_factorisations += newton.factorisations;
  summary.flag_seconds += watch.seconds();
}

template <int dim>
CoupledStepSummary Coupling<dim>::advance(CoupledState<dim>& state, double dt) {
  const BackwardDifference D(dt, state.fluid.previous_dt);
  CoupledStepSummary summary;
  find_velocity_ahead(state, D, velocity_);
  move_wall(velocity_);  // along x, where the grid does not follow
  place_wall_ahead(state, velocity_, D, wall_);
  fluid_.begin_step(state.fluid, wall_, dt);
  find_fixed_forces(fixed_);
  find_areas(areas_);
  added_mass_.set_areas(areas_);
  equation_.pose(state.flag, D, dt);
  // An error of the positions is one of the jump, mass_factor (mu + added mass) times as large.
  constexpr double rounding = 1e-14;
  newton_.set_tolerance(std::max(0.2 * settings_.tolerance / equation_.mass_factor, rounding));
  double pressure_tolerance = std::min(fluid_.tolerances().pressure, 0.1 * settings_.tolerance);
  guess_reduced_jump(state, D, g_);
  // The positions that the extrapolated velocity leads to.
  x_ = (velocity_ - equation_.velocity_rest) / D.next - state.flag.x;
  flag_.clear_held(x_);
  x_ += state.flag.x;
  acceleration_.restart();
  newton_.begin_step();
  for (summary.passes = 1;; ++summary.passes) {
    solve_flag(state, summary);
    ranks::stop_if_interrupted();
    move_wall(v_);
    // It bounds the error's mean over the fluid; that at an edge of the flag can be much larger,
    // and the jump then stays as it is.
    if (fluid_.solve_pressure(state.fluid, pressure_tolerance) == 0) pressure_tolerance *= 0.1;
    added_mass_.find_response(a_, change_);
    find_jump(state.fluid, found_);
    change_ += found_ - g_;
    summary.residual = root_mean_square(change_) / std::max(1.0, root_mean_square(g_));
    if (summary.residual <= settings_.tolerance) break;
    if (summary.passes == settings_.most_passes || !std::isfinite(summary.residual))
      throw SolverError(fmt::format(
          "at t = {:.6g}: the flag and the fluid did not agree in {} passes: the pressure jump "
          "changes by {:.3g}, dns.coupling.tolerance is {:.3g}; try a smaller dns.dt or, at the "
          "start, dns.first_dt",
          state.fluid.t, summary.passes, summary.residual, settings_.tolerance));
    // Weighted, so that its norm is the root mean square over the flag.
    g_.array() *= weights_.array();
    change_.array() *= weights_.array();
    acceleration_.advance(Eigen::Map<Eigen::VectorXd>(g_.data(), g_.size()),
                          Eigen::Map<Eigen::VectorXd>(change_.data(), change_.size()));
    g_.array() /= weights_.array();
  }
  added_mass_.add_force(found_, fixed_);
  accept(state, fixed_);
  summary.fluid = fluid_.finish_step(state.fluid);
  return summary;
}

// The step as the last pass left it; `force`: of the fluid and outer_force_ on the nodes.
template <int dim>
void Coupling<dim>::accept(CoupledState<dim>& state, const NodeVectors<dim>& force) {
  FlagState<dim>& flag = state.flag;
  const double power = force.cwiseProduct(v_).sum();
  flag.work += equation_.dt * (state.power + power) / 2;
  flag.dissipated += flag_.stretch().dissipated(flag.x, x_, equation_.dt);
  state.power = power;
  const auto replace = [](auto& now, auto& previous, const auto& next) {
    std::swap(now, previous);
    now = next;
  };
  replace(flag.x, flag.previous_x, x_);
  replace(flag.v, flag.previous_v, v_);
  flag.previous_dt = equation_.dt;
  flag.t += equation_.dt;
  replace(state.reduced_jump, state.previous_reduced_jump, g_);
}

template <int dim>
CoupledStepSummary Coupling<dim>::advance_held(CoupledState<dim>& state, double dt) {
  CoupledStepSummary summary;
  summary.fluid = fluid_.advance(
      state.fluid, [&](double, WallShape& wall) { wall = wall_of(state.flag.x); }, dt);
  state.flag.previous_x = state.flag.x;
  state.flag.previous_v = state.flag.v;
  state.flag.previous_dt = dt;
  state.flag.t += dt;
  std::swap(state.reduced_jump, state.previous_reduced_jump);
  find_jump(state.fluid, state.reduced_jump);
  return summary;
}

template class Coupling<2>;
template class Coupling<3>;
template NodeVectors<2> stretched_by_friction(const FlagMesh&, const NodeVectors<2>&, double,
                                              double);
template NodeVectors<3> stretched_by_friction(const FlagMesh&, const NodeVectors<3>&, double,
                                              double);

}  // namespace pennon::dns
