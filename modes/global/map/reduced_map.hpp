/// Columns of a map of growth rates that share the fluid's response, solved in a basis of a few
/// shapes of the flag (flag_basis.hpp) with rational fits of the response (sampled_fit.hpp).
///
/// Basis and fits are made for the map. They begin with the shapes and the response along the axis
/// of the angular frequency; then lambda is checked at points spread over the map. Where it is
/// wrong by more than a tolerance, the basis gets the mode of the whole flag there
/// (basis_enrichment.hpp), or the fit gets a sample of the response at this lambda, away from the
/// axis (fit_refinement.hpp).
#pragma once

#include <vector>

#include "modes/global/map/map_column.hpp"
#include "modes/global/map/map_heuristics.hpp"
#include "modes/global/map/sampled_fit.hpp"

namespace pennon::modes::global {

struct ReducedMapSettings {
  std::vector<Interval> windows;  ///< of the angular frequency
  Interval mu_of_modes;           ///< where neutral modes are sought
  double fit_tolerance;           ///< relative, of F
  double lambda_tolerance;
  /// Evaluations of F in each window that must find no error in succession; on all columns half as
  /// many again.
  std::size_t checks;
  double basis_tolerance = 1e-4;  ///< of the first shapes, see FlagBasis
  bool is_improved = true;        ///< false: errors are found and reported, but not mended
  MapHeuristics heuristics = {};
};

struct ReducedMap {
  std::vector<MapColumn> columns;  ///< the shapes of their modes are in the basis
  Eigen::Index basis_size = 0;
  double fit_error = 0;     ///< relative, of F: the largest of the windows (SampledFit::error)
  double basis_error = 0;   ///< of lambda: the largest against the whole flag
  double lambda_error = 0;  ///< of lambda: the largest against the response itself
  std::size_t checked_basis = 0;     ///< points at which basis_error was looked for
  std::size_t checked = 0;           ///< points at which lambda_error was looked for
  std::size_t samples = 0;           ///< evaluations of the response, those of checks among them
  std::size_t samples_off_axis = 0;  ///< those that became part of the fits away from the axis
  double sample_seconds = 0;         ///< spent on the response
  double seconds = 0;                ///< spent on all else
};

/// `response` evaluates F itself; `flags` holds the flag of each column, with mu = 1. The columns
/// are shared by threads and are the same for any number of them. Throws SolverError where a fit
/// fails.
ReducedMap reduced_map(const SampleOf& response, const std::vector<FlagOperator>& flags,
                       const std::vector<double>& mu, const ReducedMapSettings&);

}  // namespace pennon::modes::global
