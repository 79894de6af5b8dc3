/// Columns of a map of growth rates that share the fluid's response, solved in a basis of a few
/// shapes of the flag (flag_basis.hpp) with rational fits of the response (sampled_fit.hpp).
///
/// Basis and fits are made for the map. They begin with the shapes and the response along the axis
/// of the angular frequency; then lambda is checked at points of the map, spread over it, and where
/// it is wrong by more than a tolerance the basis gets the mode of the whole flag there, or the fit
/// a sample of the response at this lambda, away from the axis.
#pragma once

#include <vector>

#include "modes/global/map/map_column.hpp"
#include "modes/global/map/sampled_fit.hpp"

namespace pennon::modes::global {

struct ReducedMapSettings {
  std::vector<Interval> windows;  ///< of the angular frequency
  Interval mu_of_modes;           ///< where neutral modes are sought
  double fit_tolerance;           ///< relative, of F
  double lambda_tolerance;
  std::size_t checks;             ///< of F itself, in turn, for each window
  double basis_tolerance = 1e-4;  ///< of the first shapes, see FlagBasis
  bool is_improved = true;        ///< by what the checks find
};

struct ReducedMap {
  std::vector<MapColumn> columns;  ///< their shapes are in the basis
  Eigen::Index basis_size = 0;
  double fit_error = 0;     ///< the largest of the fits' along the axis
  double basis_error = 0;   ///< of lambda: the largest where the whole flag was asked
  double lambda_error = 0;  ///< the largest |correction| where the response itself was asked
  std::size_t checked_basis = 0, checked = 0;  ///< at so many points
  std::size_t samples = 0;                     ///< of the response, with those of checks
  std::size_t samples_off_axis = 0;            ///< that were added to the fits
  double sample_seconds = 0, seconds = 0;      ///< of the response; of all else
};

/// `response`: F itself. `flags`: one for each column, with mu = 1. The columns are shared by
/// threads, and the same for any number of them. Throws SolverError where a fit fails.
ReducedMap reduced_map(const SampleOf& response, const std::vector<FlagOperator>& flags,
                       const std::vector<double>& mu, const ReducedMapSettings&);

}  // namespace pennon::modes::global
