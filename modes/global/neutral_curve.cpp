#include "modes/global/neutral_curve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "dns/wall_faces.hpp"
#include "modes/global/aerodynamic_matrix.hpp"
#include "modes/global/sampled_fit.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_samples = 80;
// Between a mode and where it was expected: farther off it is another one, or none.
constexpr double same_omega = 0.3;
constexpr double same_mu = 0.2;  // relative

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Parameters {
  dns::FlagMaterial material;
  PlaneParameters flow;
  double k_x;
};

// Flow, flag (with mu = 1) and response at a point of the curve.
struct Station {
  BaseFlow base;
  FlagOperator flag;
  CoupledOperator coupled;
  AerodynamicMatrix F;

  Station(const OGrid& grid, BaseFlow its_base, FlagOperator its_flag, double k_x)
      : base(std::move(its_base)),
        flag(std::move(its_flag)),
        coupled(coupled_operator(grid, base, flag, k_x)),
        F(coupled, flag.stiffness) {}

  Aerodynamics aerodynamics() {
    return [this](Complex lambda) {
      return Response{F.at(lambda),
                      [this](const Eigen::VectorXcd& zeta) { return F.derivative(zeta); }};
    };
  }

  CoupledOperator with_mass_ratio(double mu) const {
    CoupledOperator scaled = coupled;
    for (Eigen::Index node = 0; node < scaled.flag_nodes; ++node)
      scaled.B.coeffRef(scaled.zeta_t(node), scaled.zeta_t(node)) *= mu;
    return scaled;
  }
};

// Where a branch is expected.
struct Expected {
  int branch;
  double omega, mu;

  bool is(const NeutralMode& mode) const {
    return std::abs(mode.omega - omega) < same_omega && std::abs(mode.mu - mu) < same_mu * mu;
  }
};

class Curve {
 public:
  Curve(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
        const EigenSolver& solve)
      : settings_(settings),
        wanted_(settings.neutral),
        solve_(solve),
        grid_(grid_of(settings)),
        chord_(dns::coupled_chord(grid_)),
        edge_(flag.leading_edge == LeadingEdge::clamped ? dns::Edge::clamped : dns::Edge::pinned),
        parameters_{{1, flag.K_B, flag.K_S, flag.nu_s, flag.damping},
                    {.Re = flow.Re, .U = flow.U, .tau = 2 * *settings.dt / 3},
                    *settings.k_x},
        values_(sweep(wanted_).values()),
        is_log_(sweep(wanted_).scale == Scale::log) {}

  NeutralCurve run() {
    std::vector<CurvePoint> found(values_.size());
    const std::size_t last = values_.size() - 1;
    const auto every = static_cast<std::size_t>(wanted_.scan_every);
    std::size_t last_scan = 0, scan_to = 0;
    for (std::size_t i = 0; i <= last; ++i) {
      const auto begin = std::chrono::steady_clock::now();
      Station station = station_at(i);
      CurvePoint& point = found[i];
      point = CurvePoint{};
      point.value = values_[i];
      const std::vector<Expected> expected = expectations(found, i);
      const bool is_due = i <= scan_to || i == last || i % every == 0 || !fluid_varies();
      if (is_due || !follow(station, expected, point)) {
        const int known = branches_;
        scan(station, expected, point);
        if (i > last_scan + 1 && i > scan_to && has_new_lowest(point, known)) {
          // It was already there, or came in between.
          scan_to = i;
          i = last_scan;
          continue;
        }
        last_scan = i;
      }
      point.seconds = seconds_since(begin);
      if (wanted_.check && (i == 0 || i == last)) verify(station, point);
    }
    NeutralCurve curve{.parameter = parameter(wanted_), .points = {}, .missing = {}};
    for (CurvePoint& point : found) {
      if (point.modes.empty())
        curve.missing.push_back(point.value);
      else
        curve.points.push_back(std::move(point));
    }
    return curve;
  }

 private:
  // Whether F does, from point to point.
  bool fluid_varies() const {
    return parameter(wanted_) == CurveParameter::Re || parameter(wanted_) == CurveParameter::k_x;
  }

  Parameters parameters_at(double value) const {
    Parameters there = parameters_;
    switch (parameter(wanted_)) {
      case CurveParameter::Re:
        there.flow.Re = value;
        break;
      case CurveParameter::k_x:
        there.k_x = value;
        break;
      case CurveParameter::K_B:
        there.material.K_B = value;
        break;
      case CurveParameter::nu_s:
        there.material.nu_s = value;
        break;
    }
    return there;
  }

  Station station_at(std::size_t i) {
    const Parameters there = parameters_at(values_[i]);
    const int components = there.k_x != 0 ? 3 : 2;
    if (!base_)
      base_ = base_flow(grid_, there.flow, components);
    else if (base_->parameters.Re != there.flow.Re || base_->q.components() != components)
      base_ = base_flow(grid_, there.flow, components, *base_);
    return {grid_, *base_,
            flag_operator(chord_, edge_, there.material, base_->forces, there.k_x,
                          static_cast<int>(settings_.n_x)),
            there.k_x};
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

  void add(Station& station, int branch, const NeutralMode& mode, CurvePoint& point) const {
    const CoupledOperator coupled = station.with_mass_ratio(mode.mu);
    const Eigenpair pair{Complex(0, mode.omega), station.F.mode(mode.zeta)};
    point.modes.push_back({branch, mode, residual_of(coupled.A, coupled.B, pair)});
    point.evaluations += mode.evaluations;
  }

  // Whether all branches were found again.
  bool follow(Station& station, const std::vector<Expected>& expected, CurvePoint& point) const {
    for (const Expected& branch : expected) {
      const auto mode = neutral_mode(station.aerodynamics(), station.flag, branch.omega, branch.mu);
      if (!mode || !branch.is(*mode)) return false;
      add(station, branch.branch, *mode, point);
    }
    std::ranges::sort(point.modes, {}, [](const BranchPoint& p) { return p.mode.mu; });
    return !point.modes.empty();
  }

  void scan(Station& station, const std::vector<Expected>& expected, CurvePoint& point) {
    point.modes.clear();
    const Interval omega{wanted_.omega[0], wanted_.omega[1]}, mu{wanted_.mu[0], wanted_.mu[1]};
    if (!fit_ || fluid_varies())
      fit_ = sampled_fit([&](Complex lambda) { return station.F.at(lambda); }, omega,
                         wanted_.fit_tolerance, most_samples);
    point.fit_error = fit_->error;
    for (const NeutralMode& start : neutral_modes(fit_->aerodynamics(), station.flag, omega, mu)) {
      if (static_cast<std::int64_t>(point.modes.size()) == wanted_.branches) break;
      const auto mode = neutral_mode(station.aerodynamics(), station.flag, start.omega, start.mu);
      if (!mode || !Expected{0, start.omega, start.mu}.is(*mode)) continue;
      const auto known =
          std::ranges::find_if(expected, [&](const Expected& branch) { return branch.is(*mode); });
      add(station, known != expected.end() ? known->branch : branches_++, *mode, point);
    }
    std::ranges::sort(point.modes, {}, [](const BranchPoint& p) { return p.mode.mu; });
  }

  static bool has_new_lowest(const CurvePoint& point, int known_branches) {
    return !point.modes.empty() && point.modes.front().branch >= known_branches;
  }

  void verify(const Station& station, CurvePoint& point) const {
    if (point.modes.empty()) return;
    const NeutralMode& neutral = point.modes.front().mode;
    Settings leading = settings_;
    leading.target.clear();
    leading.adjoint = false;
    leading.n_modes = modes_verified;
    const Spectrum spectrum = spectrum_of(station.with_mass_ratio(neutral.mu), leading, solve_);
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
  OGrid grid_;
  std::vector<double> chord_;
  dns::Edge edge_;
  Parameters parameters_;
  std::vector<double> values_;
  bool is_log_;
  std::optional<BaseFlow> base_;
  std::optional<SampledFit> fit_;
  int branches_ = 0;  // so far
};

template <class Value>
nlohmann::ordered_json value_or_null(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

NeutralCurve neutral_curve(const FlagParameters& flag, const FlowParameters& flow,
                           const Settings& settings, const EigenSolver& solve) {
  return Curve(flag, flow, settings, solve).run();
}

nlohmann::ordered_json to_json(const NeutralCurve& curve) {
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const CurvePoint& point : curve.points) {
    const BranchPoint& critical = point.modes.front();
    nlohmann::ordered_json& json = points.emplace_back(nlohmann::ordered_json{
        {name(curve.parameter), point.value},
        {"mu_cr", critical.mode.mu},
        {"omega", critical.mode.omega},
        {"branch", critical.branch},
        {"residual", critical.residual},
        {"fit_error",
         point.fit_error > 0 ? nlohmann::ordered_json(point.fit_error) : nlohmann::ordered_json()},
        {"largest_growth", value_or_null(point.largest_growth)},
        {"distance", value_or_null(point.distance)},
        {"evaluations", point.evaluations},
        {"wall_s", point.seconds}});
    for (const BranchPoint& at : point.modes)
      json["modes"].push_back({{"branch", at.branch},
                               {"mu", at.mode.mu},
                               {"omega", at.mode.omega},
                               {"growth_by_mu", at.mode.by_mu.real()},
                               {"residual", at.residual}});
  }
  return {{"neutral", points},
          {"neutral_over", name(curve.parameter)},
          {"neutral_missing", curve.missing}};
}

}  // namespace pennon::modes::global
