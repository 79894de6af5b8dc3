/// Growth rates over the mass ratio and one of Re, k_x, K_B, nu_s, by the flag's equations alone
/// (flag_mode.hpp) in a basis of few shapes, with a rational fit for F (reduced_map.hpp): one basis
/// and one fit for all K_B and nu_s, one for each Re and k_x.
#pragma once

#include <vector>

#include "modes/global/solve/sparse_factors.hpp"
#include "modes/global/study/keeper.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

struct GrowthMap {
  CurveParameter parameter = CurveParameter::k_x;
  std::vector<double> x, mu;
  /// [mu][x]: of the mode that grows most, among those that are neutral for some mass ratio in
  /// mu_of_modes; NaN where there is none.
  std::vector<std::vector<double>> growth, omega;
  std::vector<std::vector<double>> neutral;  ///< for each x, the mass ratios of neutral modes
  Eigen::Index basis_size = 0;               ///< the largest
  double fit_error = 0;                      ///< the largest of the fits', along the axis
  /// Of lambda: the largest where the whole flag was asked, and where the response itself was; at
  /// so many points.
  double basis_error = 0, lambda_error = 0;
  std::size_t checked_basis = 0, checked = 0;
  /// Of the response, with those of the checks; that were added to the fits off the axis.
  std::size_t samples = 0, samples_off_axis = 0;
  double sample_seconds = 0, map_seconds = 0;
};

/// A map and the column that is next.
struct MapProgress {
  GrowthMap map;
  std::size_t next = 0;
};

/// Preconditions: the settings are resolved and have [modes.global.map]. Throws SolverError where a
/// steady flow or a fit fails. `keeper`: keeps the columns that share a flow. Throws Interrupted
/// between them.
GrowthMap growth_map(const FlagParameters&, const FlowParameters&, const Settings&,
                     const std::shared_ptr<SparseFactors>&, const Keeper<MapProgress>& keeper = {});

}  // namespace pennon::modes::global
