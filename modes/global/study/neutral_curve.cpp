#include "modes/global/study/neutral_curve.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "modes/global/map/sampled_fit.hpp"
#include "modes/global/study/linearisation.hpp"
#include "modes/global/study/mode_search.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_samples = 80;
// Between a mode and where it was expected: farther off it is another one, or none.
constexpr double same_omega = 0.5;
constexpr double same_mu = 0.3;  // of its logarithm

// Where a branch is expected.
struct Expected {
  int branch;
  double omega, mu;

  /// 1 where it is another mode.
  double distance(const NeutralMode& mode) const {
    return std::hypot((mode.omega - omega) / same_omega, std::log(mode.mu / mu) / same_mu);
  }
  bool is(const NeutralMode& mode) const { return distance(mode) < 1; }
};

class Curve {
 public:
  Curve(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
        const EigenSolver& solve, std::shared_ptr<SparseFactors> factors)
      : settings_(settings),
        wanted_(settings.neutral),
        solve_(solve),
        linearisations_(flag, flow, settings, parameter(wanted_), std::move(factors)),
        values_(sweep(wanted_).values()),
        is_log_(sweep(wanted_).scale == Scale::log) {}

  NeutralCurve run(const Keeper<CurveProgress>& keeper) {
    CurveProgress so_far = keeper.begin();
    so_far.found.resize(values_.size());
    so_far.faults.resize(values_.size());
    branches_ = so_far.branches;
    auto& [found, faults, next, last_scan, scan_to, branches] = so_far;
    const std::size_t last = values_.size() - 1;
    const auto every = static_cast<std::size_t>(wanted_.scan_every);
    Progress progress(names_of_progress[0], static_cast<std::int64_t>(values_.size()), true);
    progress.begin_at(static_cast<std::int64_t>(next));
    while (so_far.next <= last) {
      stop_if_interrupted("no neutral curve was written");
      const std::size_t i = next++;
      CurvePoint& point = found[i];
      point = CurvePoint{};
      point.value = values_[i];
      const int known = branches_;
      const bool is_due =
          i <= scan_to || i == last || i % every == 0 || !linearisations_.fluid_varies();
      faults[i] = find(is_due, expectations(found, i), point);
      progress.advance_to(static_cast<std::int64_t>(i + 1));
      if (point.fit_error != 0) {
        if (i > last_scan + 1 && i > scan_to && has_new_lowest(point, known)) {
          // It was already there, or came in between.
          scan_to = i;
          next = last_scan + 1;
        } else {
          last_scan = i;
        }
      }
      branches = branches_;
      keeper.keep(so_far);
    }
    NeutralCurve curve{.parameter = parameter(wanted_), .points = {}, .missing = {}};
    for (std::size_t i = 0; i <= last; ++i) {
      if (found[i].modes.empty())
        curve.missing.push_back({found[i].value, faults[i]});
      else
        curve.points.push_back(std::move(found[i]));
    }
    return curve;
  }

 private:
  // The modes at a point, followed or sought. Returns why there are none, or nothing.
  std::string find(bool is_due, const std::vector<Expected>& expected, CurvePoint& point) try {
    const StopWatch watch;
    Linearisation linearised = linearisations_.at(point.value);
    if (is_due || !follow(linearised, expected, point)) scan(linearised, expected, point);
    point.seconds = watch.seconds();
    if (point.modes.empty())
      return "no neutral mode with its mass ratio and frequency between those given";
    if (wanted_.check && (point.value == values_.front() || point.value == values_.back()))
      verify(linearised, point);
    return {};
  } catch (const SolverError& fault) {
    point.modes.clear();
    return fault.what();
  }

  double coordinate(std::size_t i) const { return is_log_ ? std::log(values_[i]) : values_[i]; }

  // By the last two points, for the branches of the last one.
  std::vector<Expected> expectations(const std::vector<CurvePoint>& found, std::size_t i) const {
    std::vector<Expected> expected;
    if (i == 0) return expected;
    expected.reserve(found[i - 1].modes.size());
    for (const BranchPoint& last : found[i - 1].modes) {
      Expected next{last.branch, last.mode.omega, last.mode.mu};
      if (i > 1)
        for (const BranchPoint& earlier : found[i - 2].modes)
          if (earlier.branch == last.branch) {
            const double share =
                (coordinate(i) - coordinate(i - 1)) / (coordinate(i - 1) - coordinate(i - 2));
            next.omega += share * (last.mode.omega - earlier.mode.omega);
            next.mu *= std::pow(last.mode.mu / earlier.mode.mu, share);
          }
      expected.push_back(next);
    }
    return expected;
  }

  void add(Linearisation& linearised, int branch, const NeutralMode& mode,
           CurvePoint& point) const {
    const CoupledOperator coupled = linearised.with_mass_ratio(mode.mu);
    const Eigenpair pair{Complex(0, mode.omega), linearised.F.mode(mode.zeta)};
    point.modes.push_back({branch, mode, residual_of(coupled, pair)});
    point.evaluations += mode.evaluations;
  }

  // Whether all branches were found again.
  bool follow(Linearisation& linearised, const std::vector<Expected>& expected,
              CurvePoint& point) const {
    for (const Expected& branch : expected) {
      const auto mode =
          neutral_mode(linearised.aerodynamics(), linearised.flag, branch.omega, branch.mu);
      if (!mode || !branch.is(*mode)) return false;
      add(linearised, branch.branch, *mode, point);
    }
    std::ranges::sort(point.modes, {}, [](const BranchPoint& p) { return p.mode.mu; });
    return !point.modes.empty();
  }

  // That of the nearest expected mode which no other is, or a new one.
  int branch_of(const NeutralMode& mode, const std::vector<Expected>& expected,
                const CurvePoint& point) {
    const Expected* nearest = nullptr;
    for (const Expected& branch : expected) {
      const bool is_taken = std::ranges::any_of(
          point.modes, [&](const BranchPoint& known) { return known.branch == branch.branch; });
      if (!is_taken && branch.is(mode) &&
          (!nearest || branch.distance(mode) < nearest->distance(mode)))
        nearest = &branch;
    }
    return nearest ? nearest->branch : branches_++;
  }

  void sample(Linearisation& linearised, const std::vector<Interval>& windows) {
    fits_.clear();
    for (const Interval& window : windows)
      fits_.push_back(sampled_fit([&](Complex lambda) { return linearised.F.at(lambda); }, window,
                                  wanted_.fit_tolerance, most_samples));
  }

  void scan(Linearisation& linearised, const std::vector<Expected>& expected, CurvePoint& point) {
    point.modes.clear();
    const std::vector<Interval> windows = frequency_windows(
        {wanted_.omega[0], wanted_.omega[1]}, linearised.coupled.fluid().is_symmetric);
    if (fits_.empty() || linearisations_.fluid_varies()) sample(linearised, windows);
    std::vector<NeutralMode> starts;
    for (std::size_t w = 0; w < windows.size(); ++w) {
      point.fit_error = std::max(point.fit_error, fits_[w].error);
      std::ranges::move(neutral_modes(fits_[w].aerodynamics(), linearised.flag, windows[w],
                                      {wanted_.mu[0], wanted_.mu[1]}),
                        std::back_inserter(starts));
    }
    std::ranges::sort(starts, {}, &NeutralMode::mu);
    for (const NeutralMode& start : starts) {
      if (static_cast<std::int64_t>(point.modes.size()) == wanted_.branches) break;
      const auto mode =
          neutral_mode(linearised.aerodynamics(), linearised.flag, start.omega, start.mu);
      if (!mode || !Expected{0, start.omega, start.mu}.is(*mode)) continue;
      add(linearised, branch_of(*mode, expected, point), *mode, point);
    }
    std::ranges::sort(point.modes, {}, [](const BranchPoint& p) { return p.mode.mu; });
  }

  static bool has_new_lowest(const CurvePoint& point, int known_branches) {
    return !point.modes.empty() && point.modes.front().branch >= known_branches;
  }

  void verify(const Linearisation& linearised, CurvePoint& point) const {
    const NeutralMode& neutral = point.modes.front().mode;
    const Spectrum spectrum =
        leading_pairs(linearised.with_mass_ratio(neutral.mu), modes_verified, solve_);
    for (const Eigenpair& pair : spectrum.pairs) {
      point.largest_growth =
          std::max(point.largest_growth.value_or(pair.lambda.real()), pair.lambda.real());
      const double distance = std::abs(pair.lambda - Complex(0, neutral.omega));
      point.distance = std::min(point.distance.value_or(distance), distance);
    }
  }

  static constexpr int modes_verified = 6;

  const Settings& settings_;
  const NeutralSettings& wanted_;
  const EigenSolver& solve_;
  Linearisations linearisations_;
  std::vector<double> values_;
  bool is_log_;
  std::vector<SampledFit> fits_;  // of each window
  int branches_ = 0;              // so far
};

}  // namespace

NeutralCurve neutral_curve(const FlagParameters& flag, const FlowParameters& flow,
                           const Settings& settings, const EigenSolver& solve,
                           const std::shared_ptr<SparseFactors>& factors,
                           const Keeper<CurveProgress>& keeper) {
  return Curve(flag, flow, settings, solve, factors).run(keeper);
}

}  // namespace pennon::modes::global
