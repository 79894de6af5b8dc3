#include "modes/global/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/stop_watch.hpp"
#include "dns/flag/of_case.hpp"
#include "dns/fluid/equations/wall_faces.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// Where the leading modes are sought without a target. Those that do not swing belong to the wake.
// Where the spectrum is symmetric the modes with a negative frequency are the others' mirror
// images.
std::vector<Complex> usual_targets(bool is_symmetric) {
  std::vector<Complex> targets = {{0.5, 0}, {0.5, 2}, {0.5, 5}, {0.5, 8}, {0.5, 11}};
  if (!is_symmetric)
    for (std::size_t k = targets.size(); k-- > 1;) targets.push_back(std::conj(targets[k]));
  return targets;
}

constexpr double rounding = 1e-6;  // of the frequency of a mode that does not swing

bool is_mirror_image(const Eigenpair& pair) {
  return pair.lambda.imag() < -rounding * (1 + std::abs(pair.lambda));
}

// A target on an eigenvalue leaves little of the others in the shifted and inverted operator: all
// are sought once more from so far beside it.
constexpr double beside_target = 1e-3;

SegmentForces<double> scaled(SegmentForces<double> forces, double factor) {
  for (std::vector<double>* force : {&forces.x, &forces.y, &forces.z})
    for (double& value : *force) value *= factor;
  return forces;
}

// The node that moves most has the displacement 1.
GlobalMode mode_of(const Eigenpair& pair, const CoupledOperator& coupled) {
  const Eigen::VectorXcd zeta =
      pair.q.segment(coupled.zeta(0), coupled.flag_nodes()) / scale_of(pair, coupled);
  GlobalMode mode{pair.lambda,
                  pair.residual,
                  {Complex(0)},  // the leading edge is held
                  pair.adjoint_residual};
  mode.zeta.insert(mode.zeta.end(), zeta.begin(), zeta.end());
  return mode;
}

std::vector<Complex> targets_of(const std::vector<double>& pairs) {
  std::vector<Complex> targets;
  targets.reserve(pairs.size() / 2);
  for (std::size_t k = 0; k + 1 < pairs.size(); k += 2)
    targets.emplace_back(pairs[k], pairs[k + 1]);
  return targets;
}

}  // namespace

PlaneParameters plane_parameters(const FlowParameters& flow, const Settings& settings) {
  return {.Re = flow.Re,
          .U = flow.U,
          .dt_of_pressure = 2 * *settings.dt / 3,
          .upwinding = dns::upwinding_of(*settings.convection)};
}

OGrid grid_of(const Settings& settings) try {
  return OGrid({static_cast<int>(settings.n_rho), static_cast<int>(settings.n_theta), *settings.R,
                *settings.wall_spacing, *settings.wake_clustering});
} catch (const InputError& fault) {
  const InputFault& first = fault.faults().front();
  throw InputError("modes.global", fmt::format("makes no grid: {} {}", first.where, first.what));
}

Spectrum spectrum_of(const CoupledOperator& coupled, const Settings& settings,
                     const EigenSolver& solve) {
  const int n_modes = static_cast<int>(settings.n_modes);
  const bool are_given = !settings.target.empty(), is_symmetric = coupled.fluid().is_symmetric;
  const std::vector<Complex> targets =
      are_given ? targets_of(settings.target) : usual_targets(is_symmetric);
  Spectrum spectrum;
  spectrum.requested = are_given ? n_modes * static_cast<int>(targets.size()) : n_modes;
  for (const Complex& target : targets) {
    Spectrum found = solve(coupled, target, n_modes, settings.adjoint);
    const bool is_on_one = std::ranges::any_of(found.pairs, [&](const Eigenpair& pair) {
      return std::abs(pair.lambda - target) < beside_target;
    });
    if (is_on_one) found = solve(coupled, target + beside_target, n_modes, settings.adjoint);
    merge(std::move(found.pairs), spectrum);
  }
  if (!are_given && is_symmetric) std::erase_if(spectrum.pairs, is_mirror_image);
  if (!are_given && spectrum.pairs.size() > static_cast<std::size_t>(n_modes))
    spectrum.pairs.resize(static_cast<std::size_t>(n_modes));
  biorthogonalise(coupled, spectrum.pairs);
  return spectrum;
}

Result run(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
           const EigenSolver& solve) {
  const OGrid grid = grid_of(settings);
  const double k_x = *settings.k_x;
  const PlaneParameters parameters = plane_parameters(flow, settings);
  StopWatch watch;
  Result result{.flag = flag,
                .base = base_flow(grid, parameters, k_x != 0 ? 3 : 2),
                .k_x = k_x,
                .n_x = static_cast<int>(settings.n_x)};
  FoundModes& found = result.found;
  found.base_flow = {result.base.drag_coefficient, result.base.residual, result.base.tension};
  found.chord = dns::coupled_chord(grid);
  found.base_seconds = watch.lap();
  const dns::FlagMaterial material = dns::material_of(flag);
  const dns::Edge edge = dns::leading_edge_of(flag);
  const FlagOf flag_of = [&](const dns::FlagMaterial& its, double share) {
    return flag_operator(found.chord, edge, its, scaled(result.base.forces, share), k_x,
                         result.n_x);
  };
  const CoupledOperator coupled = coupled_operator(grid, result.base, flag_of(material, 1), k_x);
  result.nodes = coupled.flag.nodes;
  found.unknowns = coupled.size();
  found.operator_seconds = watch.lap();
  const Spectrum spectrum =
      settings.n_modes > 0 ? spectrum_of(coupled, settings, solve) : Spectrum{};
  found.eigen_seconds = watch.seconds();
  found.requested = spectrum.requested;
  found.converged = static_cast<int>(spectrum.pairs.size());
  if (spectrum.pairs.empty() && settings.n_modes > 0)
    throw SolverError(
        "no global mode converged; another modes.global.target or a finer grid may help");
  for (const Eigenpair& pair : spectrum.pairs) {
    GlobalMode& mode = found.modes.emplace_back(mode_of(pair, coupled));
    if (settings.adjoint) mode.sensitivity = sensitivity(pair, coupled, material, flag_of);
  }
  if (settings.adjoint)
    found.biorthogonality_defect = biorthogonality_defect(coupled, spectrum.pairs);
  result.fields = fields_of_modes(grid, result.base, coupled, spectrum.pairs);
  return result;
}

}  // namespace pennon::modes::global
