/// Checks of a map by the response itself, and the samples that they add to its fits.
#pragma once

#include <vector>

#include "modes/global/map/map_model.hpp"

namespace pennon::modes::global {

struct FitCheck {
  double lambda_error = 0;  ///< the largest |correction| at the points that were checked
  std::size_t checked = 0;  ///< points
  bool adds_samples = false;
};

/// Evaluates the response at lambda of points of the map, in each window until `checks` points in
/// succession have lambda to within the tolerance. Where a point does not and `may_add`, the
/// response there becomes a sample of the fit; the columns are then those of an older fit and must
/// be found again. Points that were checked before are judged again without another evaluation.
/// Precondition: the basis is right (check_basis), so that an error is the fit's.
FitCheck check_fits(const std::vector<std::size_t>& columns, std::size_t checks, bool may_add,
                    const SampleOf& response, MapModel&);

}  // namespace pennon::modes::global
