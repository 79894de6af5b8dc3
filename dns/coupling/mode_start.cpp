#include "dns/coupling/mode_start.hpp"

#include "common/errors.hpp"
#include "dns/coupling/visit_state.hpp"
#include "dns/grid/elliptic_grid.hpp"

namespace pennon::dns {
namespace {

using Complex = std::complex<double>;

// The grids of three times have to agree to much more than the amplitude: their differences are
// its velocity.
constexpr double grid_tolerance = 1e-14;  // in L
constexpr int most_passes = 300;

template <int dim>
class ModeStart {
 public:
  ModeStart(Coupling<dim>& coupling, const Fluid& fluid, const Flag<dim>& flag,
            const FlowMode& mode, double amplitude, double dt)
      : coupling_(coupling),
        fluid_(fluid),
        mesh_(flag.mesh()),
        mode_(mode),
        amplitude_(amplitude),
        dt_(dt),
        elliptic_(fluid.grid()) {}

  CoupledState<dim> state() {
    CoupledState<dim> state = coupling_.start(flag_at(0), 0);
    visit(state, *this);
    state.fluid.previous_dt = state.flag.previous_dt = dt_;
    return state;
  }

  // What a member of the state is in the mode, at its time. The numbers are those of a start.
  void operator()(const MemberInfo&, FluidState& fluid) { visit(fluid, *this); }
  void operator()(const MemberInfo&, FlagState<dim>& flag) { visit(flag, *this); }
  void operator()(const MemberInfo& info, std::vector<Field<double>>& u) {
    if (info.kind == MemberKind::guess) return;
    for (std::size_t c = 0; c < u.size(); ++c)
      place(time_of(info), mode_.steady_u[c], mode_.u[c], u[c]);
  }
  void operator()(const MemberInfo& info, Field<double>& p) {
    place(time_of(info), mode_.steady_p, mode_.p, p);
  }
  void operator()(const MemberInfo&, std::vector<Displacement<double>>& grid) {
    for (std::size_t n = 0; n < grid.size(); ++n)
      place_grid(-dt_ * static_cast<double>(n), grid[n]);
  }
  void operator()(const MemberInfo&, std::vector<bool>& is_inflow) {
    for (int plane = 0; plane < fluid_.extent().planes; ++plane)
      for (int i = 0; i < fluid_.extent().n_theta; ++i)
        is_inflow[fluid_.extent().wall_face(plane, i)] =
            mode_.is_inflow[static_cast<std::size_t>(i)];
  }
  void operator()(const MemberInfo& info, NodeVectors<dim>& nodes) {
    nodes = info.kind == MemberKind::velocity ? velocity_at(time_of(info)) : flag_at(time_of(info));
  }
  // The reduced jump stays empty: the first step begins without one.
  void operator()(const MemberInfo&, SegmentValues&) {}
  void operator()(const MemberInfo&, double&) {}

 private:
  double time_of(const MemberInfo& info) const { return -dt_ * info.steps_before; }

  Complex factor(double t, double x) const {
    return amplitude_ * std::exp(mode_.lambda * t + Complex(0, mode_.k_x * x));
  }

  void place(double t, const Field<double>& steady, const Field<Complex>& mode,
             Field<double>& f) const {
    for (int plane = 0; plane < fluid_.extent().planes; ++plane) {
      const Complex by = factor(t, fluid_.span().x(plane));
      for (int j = 0; j < fluid_.extent().n_rho; ++j)
        for (int i = 0; i < fluid_.extent().n_theta; ++i)
          f.row(plane, j)[i] = steady.row(0, j)[i] + (by * mode.row(0, j)[i]).real();
    }
  }

  void place_grid(double t, Displacement<double>& grid) {
    const WallShape wall = coupling_.wall_of(flag_at(t));
    for (int plane = 0; plane < fluid_.extent().planes; ++plane) {
      const std::size_t first = fluid_.extent().wall_face(plane, 0);
      const EllipticGridSummary found = elliptic_.follow(
          plane, wall.y.data() + first, wall.z.data() + first, grid, grid_tolerance, most_passes);
      if (!(found.least_area > 0))
        throw SolverError(
            "no grid fits the flag displaced by dns.initial.mode_amplitude times the global mode; "
            "a smaller dns.initial.mode_amplitude starts");
    }
  }

  NodeVectors<dim> flag_at(double t) const {
    NodeVectors<dim> x(dim, mesh_.nodes());
    for_each_node([&](int m, int j) {
      const int node = mesh_.index(m, j);
      const auto& [along_x, along_y] = mode_.flag[static_cast<std::size_t>(j)];
      if constexpr (dim == 3) x(0, node) = mesh_.x(m) + along_x;
      x(dim - 2, node) = along_y;
      x(dim - 1, node) = real_part(mode_.zeta, t, m, j);
    });
    return x;
  }

  NodeVectors<dim> velocity_at(double t) const {
    NodeVectors<dim> v = NodeVectors<dim>::Zero(dim, mesh_.nodes());
    for_each_node(
        [&](int m, int j) { v(dim - 1, mesh_.index(m, j)) = real_part(mode_.zeta_t, t, m, j); });
    return v;
  }

  double real_part(const std::vector<Complex>& q, double t, int m, int j) const {
    const double x = mesh_.is_two_d() ? 0 : mesh_.x(m);
    return (factor(t, x) * q[static_cast<std::size_t>(j)]).real();
  }

  template <class Use>
  void for_each_node(const Use& use) const {
    for (int m = 0; m < mesh_.stations(); ++m)
      for (int j = 0; j < mesh_.chord_nodes(); ++j) use(m, j);
  }

  Coupling<dim>& coupling_;
  const Fluid& fluid_;
  const FlagMesh& mesh_;
  const FlowMode& mode_;
  double amplitude_, dt_;
  EllipticGrid elliptic_;
};

}  // namespace

template <int dim>
CoupledState<dim> start_in_mode(Coupling<dim>& coupling, const Fluid& fluid, const Flag<dim>& flag,
                                const FlowMode& mode, double amplitude, double dt) {
  return ModeStart<dim>(coupling, fluid, flag, mode, amplitude, dt).state();
}

template CoupledState<2> start_in_mode(Coupling<2>&, const Fluid&, const Flag<2>&, const FlowMode&,
                                       double, double);
template CoupledState<3> start_in_mode(Coupling<3>&, const Fluid&, const Flag<3>&, const FlowMode&,
                                       double, double);

}  // namespace pennon::dns
