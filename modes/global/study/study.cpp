#include "modes/global/study/study.hpp"

#include "common/errors.hpp"
#include "common/stop_watch.hpp"
#include "dns/flag/of_case.hpp"
#include "modes/global/study/mode_search.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

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

}  // namespace

Result run(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
           const EigenSolver& solve) {
  CoupledProblem problem = coupled_problem(flag, flow, settings);
  Result result{.flag = flag,
                .base = problem.base,
                .k_x = *settings.k_x,
                .n_x = static_cast<int>(settings.n_x),
                .nodes = problem.coupled.flag.nodes};
  FoundModes& found = result.found;
  found.base_flow = {result.base.drag_coefficient, result.base.residual, result.base.tension};
  found.chord = problem.chord;
  found.unknowns = problem.coupled.size();
  found.base_seconds = problem.base_seconds;
  found.operator_seconds = problem.operator_seconds;
  const StopWatch watch;
  KindFinder kinds(flag, flow, settings, solve);
  const FoundPairs sorted = search_modes(problem, settings, solve, kinds);
  found.eigen_seconds = watch.seconds();
  found.requested = sorted.requested;
  found.converged = sorted.converged;
  found.searched = sorted.searched;
  found.box = sorted.box;
  found.too_fast = sorted.too_fast;
  found.checked = sorted.checked;
  if (sorted.pairs.empty() && settings.n_modes > 0)
    throw SolverError(
        "no global mode converged; another modes.global.target or a finer grid may help");
  std::vector<Eigenpair> pairs;
  pairs.reserve(sorted.pairs.size());
  for (const SortedPair& each : sorted.pairs) {
    GlobalMode& mode = found.modes.emplace_back(mode_of(each.pair, problem.coupled));
    mode.shares = each.shares;
    mode.kind = each.kind;
    if (settings.adjoint)
      mode.sensitivity =
          sensitivity(each.pair, problem.coupled, dns::material_of(flag), problem.flag_of);
    pairs.push_back(each.pair);
  }
  if (settings.adjoint)
    found.biorthogonality_defect = biorthogonality_defect(problem.coupled, pairs);
  result.fields = fields_of_modes(problem.grid, result.base, problem.coupled, pairs);
  return result;
}

}  // namespace pennon::modes::global
