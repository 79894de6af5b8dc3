#include "modes/global/study/mode_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// Where the leading modes are sought without a target. Where the spectrum is symmetric the modes
// with a negative frequency are the others' mirror images.
std::vector<Complex> usual_targets(bool is_symmetric) {
  std::vector<Complex> targets = {{0.5, 0}, {0.5, 2}, {0.5, 5}, {0.5, 8}, {0.5, 11}};
  if (!is_symmetric)
    for (std::size_t k = targets.size(); k-- > 1;) targets.push_back(std::conj(targets[k]));
  return targets;
}

std::vector<Complex> targets_of(const std::vector<double>& pairs) {
  std::vector<Complex> targets;
  targets.reserve(pairs.size() / 2);
  for (std::size_t k = 0; k + 1 < pairs.size(); k += 2)
    targets.emplace_back(pairs[k], pairs[k + 1]);
  return targets;
}

constexpr double rounding = 1e-6;  // of the frequency of a mode that does not swing

bool is_mirror_image(const Eigenpair& pair) {
  return pair.lambda.imag() < -rounding * (1 + std::abs(pair.lambda));
}

Spectrum pairs_near(const CoupledOperator& coupled, Complex target, int n, bool adjoint,
                    const EigenSolver& solve) {
  // A target on an eigenvalue leaves little of the others in the shifted and inverted operator: all
  // are sought once more from so far beside it.
  constexpr double beside_target = 1e-3;
  Spectrum found = solve(coupled, target, n, adjoint);
  const bool is_on_one = std::ranges::any_of(found.pairs, [&](const Eigenpair& pair) {
    return std::abs(pair.lambda - target) < beside_target;
  });
  return is_on_one ? solve(coupled, target + beside_target, n, adjoint) : found;
}

Spectrum pairs_near_all(const CoupledOperator& coupled, const std::vector<Complex>& targets, int n,
                        bool adjoint, const EigenSolver& solve) {
  Spectrum spectrum;
  for (const Complex& target : targets)
    merge(pairs_near(coupled, target, n, adjoint, solve).pairs, spectrum);
  return spectrum;
}

bool is_of_box(const SortedPair& sorted) {
  return sorted.kind == ModeKind::box;
}

bool grows_more(const SortedPair& a, const SortedPair& b) {
  return a.pair.lambda.real() > b.pair.lambda.real();
}

class Search {
 public:
  Search(const CoupledProblem& problem, const Settings& settings, const EigenSolver& solve,
         KindFinder& kinds)
      : problem_(problem),
        settings_(settings),
        solve_(solve),
        kinds_(kinds),
        fixed_points_(problem.grid, problem.base) {}

  FoundPairs run() {
    const CoupledOperator& coupled = problem_.coupled;
    const bool is_symmetric = coupled.fluid().is_symmetric;
    const int n = static_cast<int>(settings_.n_modes);
    FoundPairs found;
    if (settings_.target.empty()) {
      const std::vector<SortedPair> all =
          sought(usual_targets(is_symmetric),
                 [&](const Eigenpair& pair) { return !(is_symmetric && is_mirror_image(pair)); });
      keep(all, grows_more, found);
      found.requested = n;
    } else {
      for (const Complex target : targets_of(settings_.target)) {
        keep(
            sought({target}, [](const Eigenpair&) { return true; }),
            [&](const SortedPair& a, const SortedPair& b) {
              return std::abs(a.pair.lambda - target) < std::abs(b.pair.lambda - target);
            },
            found);
        found.requested += n;
      }
    }
    finish(found);
    return found;
  }

 private:
  // Of all that are found next to the targets, those that `wants` wants, with their kinds.
  template <class Wants>
  std::vector<SortedPair> sought(const std::vector<Complex>& targets, const Wants& wants) {
    constexpr int most = 4;  // times n_modes
    const int n = static_cast<int>(settings_.n_modes);
    std::vector<SortedPair> found;
    for (const int pairs : {n, most * n}) {
      searched_ = std::max(searched_, pairs);
      Spectrum spectrum =
          pairs_near_all(problem_.coupled, targets, pairs, settings_.adjoint, solve_);
      std::erase_if(spectrum.pairs, [&](const Eigenpair& pair) { return !wants(pair); });
      std::erase_if(spectrum.pairs, [&](const Eigenpair& pair) { return is_too_fast(pair); });
      found = sorted(std::move(spectrum.pairs));
      if (found.size() - static_cast<std::size_t>(std::ranges::count_if(found, is_of_box)) >=
          static_cast<std::size_t>(n))
        break;
    }
    return found;
  }

  bool is_too_fast(const Eigenpair& pair) {
    const auto is_same = [&](const Complex& lambda) { return are_same(lambda, pair.lambda); };
    if (!(std::abs(pair.lambda) * *settings_.dt > 1)) return false;
    if (std::ranges::none_of(too_fast_, is_same)) too_fast_.push_back(pair.lambda);
    return true;
  }

  std::vector<SortedPair> sorted(std::vector<Eigenpair> pairs) {
    std::vector<SortedPair> result;
    result.reserve(pairs.size());
    for (Eigenpair& pair : pairs) {
      const auto known = std::ranges::find_if(
          known_, [&](const Known& other) { return are_same(other.lambda, pair.lambda); });
      if (known != known_.end()) {
        result.push_back({std::move(pair), known->shares, known->kind});
        continue;
      }
      const EnergyShares shares =
          energy_shares(problem_.grid, problem_.coupled, fixed_points_, pair);
      const ModeKind kind = kinds_.kind_of(pair.lambda, shares);
      known_.push_back({pair.lambda, shares, kind});
      result.push_back({std::move(pair), shares, kind});
    }
    return result;
  }

  // The first n_modes that are not of the box and as many that are.
  template <class Before>
  void keep(std::vector<SortedPair> sorted, const Before& before, FoundPairs& found) const {
    std::ranges::sort(sorted, before);
    std::int64_t others = 0, box = 0;
    for (SortedPair& each : sorted) {
      if ((is_of_box(each) ? box : others)++ >= settings_.n_modes) continue;
      const bool is_new = std::ranges::none_of(found.pairs, [&](const SortedPair& known) {
        return are_same(known.pair.lambda, each.pair.lambda);
      });
      if (is_new) found.pairs.push_back(std::move(each));
    }
  }

  void finish(FoundPairs& found) const {
    std::ranges::sort(found.pairs, [](const SortedPair& a, const SortedPair& b) {
      return is_of_box(a) != is_of_box(b) ? is_of_box(b) : grows_more(a, b);
    });
    found.box = static_cast<int>(std::ranges::count(known_, ModeKind::box, &Known::kind));
    found.converged = static_cast<int>(std::ranges::count_if(found.pairs, std::not_fn(is_of_box)));
    found.searched = searched_;
    found.too_fast = static_cast<int>(too_fast_.size());
    found.checked = kinds_.checked();
  }

  const CoupledProblem& problem_;
  const Settings& settings_;
  const EigenSolver& solve_;
  KindFinder& kinds_;
  FixedPoints fixed_points_;
  struct Known {
    Complex lambda;
    EnergyShares shares;
    ModeKind kind;
  };
  std::vector<Known> known_;
  std::vector<Complex> too_fast_;
  int searched_ = 0;  // pairs next to a target, at most
};

}  // namespace

Spectrum leading_pairs(const CoupledOperator& coupled, int n, const EigenSolver& solve) {
  const bool is_symmetric = coupled.fluid().is_symmetric;
  Spectrum spectrum = pairs_near_all(coupled, usual_targets(is_symmetric), n, false, solve);
  spectrum.requested = n;
  if (is_symmetric) std::erase_if(spectrum.pairs, is_mirror_image);
  if (spectrum.pairs.size() > static_cast<std::size_t>(n))
    spectrum.pairs.resize(static_cast<std::size_t>(n));
  return spectrum;
}

FoundPairs search_modes(const CoupledProblem& problem, const Settings& settings,
                        const EigenSolver& solve, KindFinder& kinds) {
  if (settings.n_modes == 0) return {};
  FoundPairs found = Search(problem, settings, solve, kinds).run();
  std::vector<Eigenpair> pairs;
  pairs.reserve(found.pairs.size());
  for (SortedPair& sorted : found.pairs) pairs.push_back(std::move(sorted.pair));
  biorthogonalise(problem.coupled, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) found.pairs[k].pair = std::move(pairs[k]);
  return found;
}

}  // namespace pennon::modes::global
