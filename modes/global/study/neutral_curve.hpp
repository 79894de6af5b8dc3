/// The neutral curve mu_cr along Re, k_x, K_B or nu_s.
///
/// At the first point all neutral modes in a window are found with a rational fit of the fluid's
/// response (sampled_fit.hpp), and those of the smallest mass ratios solved with the response
/// itself. From a point to the next they are followed: steady flow by Newton's method from the one
/// before, then Newton's method on the frequency (neutral.hpp) from where the last two points
/// point. A mode followed that way says nothing of the others; so all are sought anew every few
/// points and at the last one, and where this finds a lower one that was not being followed, at the
/// points between too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modes/global/neutral/neutral.hpp"
#include "modes/global/solve/sparse_factors.hpp"
#include "modes/global/study/keeper.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

struct BranchPoint {
  int branch;  ///< counted as they are found; the same along the curve
  NeutralMode mode;
  double residual;  ///< of A q = i omega B q, as residual_of()
};

struct CurvePoint {
  double value = 0;                ///< of the parameter
  std::vector<BranchPoint> modes;  ///< mu_cr is the mu of the first; the others are above
  double fit_error = 0;            ///< of the response where all modes were sought; 0: followed
  int evaluations = 0;             ///< of the response, without those of the fit
  double seconds = 0;
  /// Of the full operator at mu_cr, where it was asked: the largest growth rate, and how far the
  /// eigenvalue next to i omega is from it.
  std::optional<double> largest_growth = {}, distance = {};
};

struct MissingPoint {
  double value;
  std::string fault;
};

/// What goes on where a curve was left: its points so far and what the next one depends on beside
/// them. The steady flow of the next point is found anew, so that it is the same to the tolerance
/// of Newton's method and not to the last bit.
struct CurveProgress {
  std::vector<CurvePoint> found;    ///< of all values
  std::vector<std::string> faults;  ///< why there are no modes
  std::size_t next = 0, last_scan = 0, scan_to = 0;
  int branches = 0;
};

struct NeutralCurve {
  CurveParameter parameter = CurveParameter::Re;
  std::vector<CurvePoint> points;     ///< with at least one mode
  std::vector<MissingPoint> missing;  ///< the values left out
};

/// Preconditions: the settings are resolved and have [modes.global.neutral]. A point at which the
/// steady flow, a fit or the modes fail is left out, and said so.
/// `keeper`: keeps each point. Throws Interrupted between two points.
NeutralCurve neutral_curve(const FlagParameters&, const FlowParameters&, const Settings&,
                           const EigenSolver&, const std::shared_ptr<SparseFactors>&,
                           const Keeper<CurveProgress>& keeper = {});

}  // namespace pennon::modes::global
