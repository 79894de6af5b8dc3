/// Growth rates over the mass ratio and one of Re, k_x, K_B, nu_s, by the flag's equations alone,
///
///   S(lambda; mu) zeta = [lambda^2 mu m + K - F(lambda)] zeta = 0,
///
/// with a rational fit for F (sampled_fit.hpp): one fit for all K_B and nu_s, one for each Re and
/// k_x. Every mode that grows in the window does so from some mass ratio on; it is followed over mu
/// from where it is neutral, up and down, by Newton's method on (zeta, lambda).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "modes/global/neutral.hpp"
#include "modes/global/sparse_factors.hpp"
#include "modes/global/study.hpp"

namespace pennon::modes::global {

struct FlagMode {
  std::complex<double> lambda;
  Eigen::VectorXcd zeta;       ///< of length 1
  std::complex<double> by_mu;  ///< d lambda/d mu
};

/// The mode next to a guess at a mass ratio, by Newton's method with a border: S zeta = 0 and
/// zeta_0^H zeta = 1. `flag` with mu = 1. None where it does not converge.
std::optional<FlagMode> flag_mode(const Aerodynamics&, const FlagOperator& flag, double mu,
                                  std::complex<double> lambda_0, const Eigen::VectorXcd& zeta_0);

/// What an error of F does to lambda, to first order: the step that Newton's method would take from
/// a mode of the fit with this F.
std::complex<double> correction(const Aerodynamics&, const FlagOperator& flag, double mu,
                                const FlagMode&);

struct GrowthMap {
  CurveParameter parameter = CurveParameter::k_x;
  std::vector<double> x, mu;
  /// [mu][x]: of the mode that grows most, among those that are neutral for some mass ratio in
  /// mu_of_modes; NaN where there is none.
  std::vector<std::vector<double>> growth, omega;
  std::vector<std::vector<double>> neutral;  ///< for each x, the mass ratios of neutral modes
  double fit_error = 0;                      ///< the largest of the fits'
  double lambda_error = 0;  ///< the largest |correction| where the full response was asked
  std::size_t checked = 0;  ///< at so many points
  std::size_t samples = 0;  ///< of the response
  double sample_seconds = 0, map_seconds = 0;
};

/// Preconditions: the settings are resolved and have [modes.global.map]. Throws SolverError where a
/// steady flow or a fit fails.
GrowthMap growth_map(const FlagParameters&, const FlowParameters&, const Settings&,
                     const std::shared_ptr<SparseFactors>&);

/// The arrays too.
nlohmann::ordered_json to_json(const GrowthMap&);

}  // namespace pennon::modes::global
