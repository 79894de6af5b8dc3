/// The local stability analysis of a case: what `pennon lsa` computes.
#pragma once

#include <optional>
#include <vector>

#include "common/case/parameters.hpp"
#include "common/io/output_folder.hpp"
#include "lsa/curve.hpp"
#include "lsa/map.hpp"
#include "lsa/most_unstable.hpp"
#include "lsa/outcomes.hpp"
#include "lsa/settings.hpp"
#include "lsa/verdicts.hpp"

namespace pennon::lsa {

struct Result {
  Point point;
  Stability stability;
  bool has_cross_flow = false;      ///< of the model
  std::vector<Outcome> marks = {};  ///< known outcomes, for the pictures
  std::optional<Curve> curve = {};
  std::optional<MapSummary> map = {};
  std::optional<Axis> sought = {};  ///< the wavenumber that was maximised over
  std::optional<MostUnstable> most_unstable = {};
  std::optional<Verdicts> verdicts = {};
  std::optional<Curve> critical_mass_ratios = {};  ///< beside the verdicts, over the searched k_y
};

/// Computes what the settings ask for. The map may be larger than the memory and is therefore
/// written as it is computed: map.h5 and neutral.csv, in the folder. `settings` as check() accepts
/// them. Throws InputError (a table of outcomes), SolverError, FileError, Interrupted.
Result run(const Settings&, const FlagParameters&, const FlowParameters&, const OutputFolder&,
           bool shows_progress);

}  // namespace pennon::lsa
