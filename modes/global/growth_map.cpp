#include "modes/global/growth_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/interrupt.hpp"
#include "common/stop_watch.hpp"
#include "modes/global/sampled_fit.hpp"
#include "modes/global/station.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Index = Eigen::Index;

constexpr std::size_t most_samples = 80;
constexpr double least_mu_of_modes = 1e-4;
constexpr double greatest_over_map = 20;  // neutral modes are sought up to so many times its mu

// S and its derivatives at a mode, with the border: [S, dS/dlambda zeta; zeta_0^H, 0].
class Bordered {
 public:
  Bordered(const Aerodynamics& F, const FlagOperator& flag, double mu, Complex lambda,
           const Eigen::VectorXcd& zeta, const Eigen::VectorXcd& border) {
    const Index n = zeta.size();
    const Response response = F(lambda);
    inertia_ = lambda * lambda * flag.mass.cwiseProduct(zeta);
    residual_ = mu * inertia_ + flag.stiffness * zeta - response.F * zeta;
    Eigen::MatrixXcd matrix(n + 1, n + 1);
    matrix.topLeftCorner(n, n) = flag.stiffness - response.F;
    matrix.topLeftCorner(n, n).diagonal() += mu * lambda * lambda * flag.mass;
    matrix.topRightCorner(n, 1) =
        2.0 * lambda * mu * flag.mass.cwiseProduct(zeta) - response.derivative(zeta);
    matrix.bottomLeftCorner(1, n) = border.adjoint();
    matrix(n, n) = 0;
    factors_.compute(matrix);
  }

  /// Changes of zeta and, last, lambda: of Newton's step, and with mu.
  Eigen::VectorXcd step() const { return solve(-residual_); }
  Eigen::VectorXcd by_mu() const { return solve(-inertia_); }

 private:
  Eigen::VectorXcd solve(const Eigen::VectorXcd& right) const {
    Eigen::VectorXcd whole(right.size() + 1);
    whole << right, 0.0;
    return factors_.solve(whole);
  }

  Eigen::VectorXcd inertia_, residual_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> factors_;
};

// Follows a mode from a mass ratio to another, by shorter steps where it is lost.
std::optional<FlagMode> follow(const Aerodynamics& F, const FlagOperator& flag, double from,
                               double to, const FlagMode& mode, int halvings = 6) {
  constexpr double longest_jump = 0.1;  // of lambda, from where the last mode points
  const Complex expected = mode.lambda + mode.by_mu * (to - from);
  auto next = flag_mode(F, flag, to, expected, mode.zeta);
  if (next && std::abs(next->lambda - expected) < longest_jump) return next;
  if (halvings == 0) return std::nullopt;
  const double middle = std::sqrt(from * to);
  const auto half = follow(F, flag, from, middle, mode, halvings - 1);
  if (!half) return std::nullopt;
  return follow(F, flag, middle, to, *half, halvings - 1);
}

class Map {
 public:
  Map(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
      std::shared_ptr<SparseFactors> factors)
      : wanted_(settings.map),
        stations_(flag, flow, settings, parameter(wanted_), std::move(factors)) {
    map_.parameter = parameter(wanted_);
    map_.x = sweep(wanted_).values();
    map_.mu = wanted_.mu->values();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    map_.growth.assign(map_.mu.size(), std::vector<double>(map_.x.size(), none));
    map_.omega = map_.growth;
    map_.neutral.resize(map_.x.size());
    most_.resize(map_.mu.size());
  }

  GrowthMap run() {
    for (std::size_t i = 0; i < map_.x.size(); ++i) {
      stop_if_interrupted("no map was written");
      const bool is_checked = stations_.fluid_varies() || i == 0 || i + 1 == map_.x.size();
      std::optional<Station> station;
      if (is_checked) station.emplace(stations_.at(map_.x[i]));
      if (!fit_ || stations_.fluid_varies()) sample(*station);
      const StopWatch watch;
      find_column(i, station ? station->flag : stations_.flag_at(map_.x[i]));
      map_.map_seconds += watch.seconds();
      if (is_checked) check_column(*station);
    }
    return std::move(map_);
  }

 private:
  void sample(Station& station) {
    const StopWatch watch;
    fit_ = sampled_fit([&](Complex lambda) { return station.F.at(lambda); },
                       {wanted_.omega[0], wanted_.omega[1]}, wanted_.fit_tolerance, most_samples);
    map_.samples += fit_->samples;
    map_.fit_error = std::max(map_.fit_error, fit_->error);
    map_.sample_seconds += watch.seconds();
  }

  void find_column(std::size_t i, const FlagOperator& flag) {
    const Aerodynamics F = fit_->aerodynamics();
    // All anew: those of the column before may have vanished, and others come.
    const std::vector<NeutralMode> neutral =
        neutral_modes(F, flag, {wanted_.omega[0], wanted_.omega[1]},
                      {least_mu_of_modes, greatest_over_map * map_.mu.back()});
    std::ranges::fill(most_, std::nullopt);
    for (const NeutralMode& mode : neutral) {
      map_.neutral[i].push_back(mode.mu);
      trace(F, flag, mode);
    }
    std::ranges::sort(map_.neutral[i]);
    for (std::size_t m = 0; m < most_.size(); ++m)
      if (most_[m]) {
        map_.growth[m][i] = most_[m]->lambda.real();
        map_.omega[m][i] = most_[m]->lambda.imag();
      }
  }

  // Up and down the column from where the mode is neutral.
  void trace(const Aerodynamics& F, const FlagOperator& flag, const NeutralMode& neutral) {
    const FlagMode start{Complex(0, neutral.omega), neutral.zeta, neutral.by_mu};
    const auto above =
        static_cast<std::size_t>(std::ranges::lower_bound(map_.mu, neutral.mu) - map_.mu.begin());
    double from = neutral.mu;
    std::optional<FlagMode> mode = start;
    for (std::size_t m = above; m < map_.mu.size() && mode; ++m) {
      mode = follow(F, flag, from, map_.mu[m], *mode);
      from = map_.mu[m];
      if (mode) keep(m, *mode);
    }
    from = neutral.mu;
    mode = start;
    for (std::size_t m = above; m-- > 0 && mode;) {
      mode = follow(F, flag, from, map_.mu[m], *mode);
      from = map_.mu[m];
      if (mode) keep(m, *mode);
    }
  }

  void keep(std::size_t m, const FlagMode& mode) {
    if (!most_[m] || mode.lambda.real() > most_[m]->lambda.real()) most_[m] = mode;
  }

  // Where the mode grows most and where it grows least.
  void check_column(Station& station) {
    std::optional<std::size_t> least, most;
    for (std::size_t m = 0; m < most_.size(); ++m) {
      if (!most_[m]) continue;
      const double growth = most_[m]->lambda.real();
      if (!least || growth < most_[*least]->lambda.real()) least = m;
      if (!most || growth > most_[*most]->lambda.real()) most = m;
    }
    for (const auto& at : {least, most}) {
      if (!at) continue;
      const Complex change =
          correction(station.aerodynamics(), station.flag, map_.mu[*at], *most_[*at]);
      map_.lambda_error = std::max(map_.lambda_error, std::abs(change));
      ++map_.checked;
    }
  }

  const MapSettings& wanted_;
  Stations stations_;
  GrowthMap map_;
  std::optional<SampledFit> fit_;
  std::vector<std::optional<FlagMode>> most_;  // of the column
};

}  // namespace

std::optional<FlagMode> flag_mode(const Aerodynamics& F, const FlagOperator& flag, double mu,
                                  Complex lambda_0, const Eigen::VectorXcd& zeta_0) {
  constexpr int most_iterations = 12;
  constexpr double last_step = 1e-7;  // of lambda: the error left is of its square
  const Eigen::VectorXcd border = zeta_0.normalized();
  Complex lambda = lambda_0;
  Eigen::VectorXcd zeta = border;
  const Index n = zeta.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Bordered bordered(F, flag, mu, lambda, zeta, border);
    const Eigen::VectorXcd step = bordered.step();
    zeta += step.head(n);
    lambda += step[n];
    if (!std::isfinite(std::abs(lambda))) return std::nullopt;
    if (std::abs(step[n]) < last_step) {
      const Complex by_mu = bordered.by_mu()[n];
      return FlagMode{lambda, zeta.normalized(), by_mu};
    }
  }
  return std::nullopt;
}

Complex correction(const Aerodynamics& F, const FlagOperator& flag, double mu,
                   const FlagMode& mode) {
  return Bordered(F, flag, mu, mode.lambda, mode.zeta, mode.zeta).step()[mode.zeta.size()];
}

GrowthMap growth_map(const FlagParameters& flag, const FlowParameters& flow,
                     const Settings& settings, const std::shared_ptr<SparseFactors>& factors) {
  return Map(flag, flow, settings, factors).run();
}

nlohmann::ordered_json to_json(const GrowthMap& map) {
  return {{"over", name(map.parameter)},
          {"x", map.x},
          {"mu", map.mu},
          {"growth", map.growth},
          {"omega", map.omega},
          {"neutral", map.neutral},
          {"fit_error", map.fit_error},
          {"lambda_error", map.lambda_error},
          {"checked", map.checked},
          {"samples", map.samples},
          {"sample_s", map.sample_seconds},
          {"map_s", map.map_seconds}};
}

}  // namespace pennon::modes::global
