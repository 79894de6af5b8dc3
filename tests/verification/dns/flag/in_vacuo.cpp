/// The discrete flag against the modes in vacuum of modes/, another discretisation of the same
/// equations.
#include <gtest/gtest.h>

#include <cmath>

#include "dns/flag/statics.hpp"
#include "modes/normal/in_vacuo.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

constexpr double Re = 1000;
const double tau = 1.3 / std::sqrt(Re);

FlagParameters paper_flag(LeadingEdge leading_edge, std::optional<double> gamma) {
  FlagParameters flag;
  flag.mu = 0.125;
  flag.K_B = 1e-3;
  flag.nu_s = 0.3;
  flag.leading_edge = leading_edge;
  flag.gamma = gamma;
  return flag;
}

double tension(double y) {
  return tau * (1 - std::sqrt(y));
}

// The flat flag under the drag of its boundary layers, as forces along the chord: each segment then
// carries the tension of its middle.
template <int dim>
LinearModes modes_under_drag(const Flag<dim>& flag) {
  const FlagMesh& mesh = flag.mesh();
  const int last = mesh.chord_nodes() - 1;
  const auto in_segment = [&](int j) { return tension((mesh.y(j) + mesh.y(j + 1)) / 2); };
  FlagLoads<dim> loads;
  loads.node_forces = NodeVectors<dim>::Zero(dim, mesh.nodes());
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 1; j <= last; ++j)
      loads.node_forces(dim - 2, mesh.index(i, j)) =
          mesh.span_share(i) * (in_segment(j - 1) - (j < last ? in_segment(j) : 0.0));
  NodeVectors<dim> x = flag.rest();
  find_equilibrium(flag, loads, x);
  return transverse_modes(flag, x, loads);
}

std::vector<double> reference(const FlagParameters& flag, int n) {
  FlowParameters flow;
  flow.Re = Re;
  std::vector<double> omega;
  for (const auto& mode :
       modes::in_vacuo_modes({{n}, 4}, flag, flow, modes::TensionProfile::blasius, 200).modes)
    omega.push_back(mode.omega);
  return omega;
}

FlagMaterial material_of_stiff(const FlagParameters& flag) {
  return {flag.mu, flag.K_B, 1e4, flag.nu_s, 0};
}

TEST(FlagInVacuo, HasTheModesOfTheOtherDiscretisationInTwoDimensions) {
  for (const LeadingEdge held : {LeadingEdge::pinned, LeadingEdge::clamped}) {
    const FlagParameters parameters = paper_flag(held, std::nullopt);
    const std::vector<double> exact = reference(parameters, 0);
    const Edge leading = held == LeadingEdge::clamped ? Edge::clamped : Edge::pinned;
    const auto omega = [&](int N) {
      return modes_under_drag(Flag<2>(FlagMesh(uniform_chord(N), {leading, Edge::free}),
                                      material_of_stiff(parameters)))
          .omega;
    };
    const Eigen::VectorXd coarse = omega(51), fine = omega(101);
    for (Eigen::Index m = 0; m < 4; ++m) {
      const double limit = fine[m] + (fine[m] - coarse[m]) / 3;
      // The square root of the tension at the leading edge leaves an error of order 3/2 that the
      // extrapolation does not remove.
      EXPECT_NEAR(limit / exact[static_cast<std::size_t>(m)], 1, 5e-4) << m;
    }
  }
}

// With a wave along the span: bending of a Kirchhoff plate with its free edge, and the spanwise
// tension that the Poisson ratio leaves in a flag of fixed span.
TEST(FlagInVacuo, HasTheModesOfTheOtherDiscretisationWithAWaveAlongTheSpan) {
  const FlagParameters parameters = paper_flag(LeadingEdge::pinned, 1.0);
  const std::vector<double> exact = reference(parameters, 1);
  const auto error = [&](int stations, int N) {
    const Flag<3> flag(FlagMesh(uniform_chord(N), stations, 1.0, {}),
                       material_of_stiff(parameters));
    const LinearModes modes = modes_under_drag(flag);
    // The lowest mode that has one wave along the span at the trailing edge.
    for (Eigen::Index m = 0; m < modes.omega.size(); ++m) {
      std::complex<double> first_wave = 0;
      double square = 0;
      for (int i = 0; i < stations; ++i) {
        const double zeta = modes.shapes(i * (N - 1) + N - 2, m);
        first_wave += zeta * std::polar(1.0, 2 * M_PI * i / stations);
        square += zeta * zeta;
      }
      if (std::norm(first_wave) > 0.45 * stations * square) return modes.omega[m] / exact[0] - 1;
    }
    return HUGE_VAL;
  };
  const double coarse = error(8, 17), fine = error(16, 33);
  EXPECT_LT(std::abs(fine), 0.02);
  EXPECT_GE(order(coarse, fine, 2), 1.8);
}

}  // namespace
}  // namespace pennon::dns
