/// The local stability analysis of a case: what `pennon lsa` computes and writes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "common/case/parameters.hpp"
#include "common/io/output_folder.hpp"
#include "lsa/curve.hpp"
#include "lsa/map.hpp"
#include "lsa/most_unstable.hpp"
#include "lsa/settings.hpp"
#include "lsa/verdicts.hpp"

namespace pennon::lsa {

struct Result {
  Point point;
  Stability stability;
  std::optional<Curve> curve;
  std::optional<MapSummary> map;
  std::optional<Axis> sought;  ///< the wavenumber that was maximised over
  std::optional<MostUnstable> most_unstable;
  std::optional<Verdicts> verdicts;
};

/// Computes what the settings ask for and writes curve.csv, curve.h5, map.h5, neutral.csv,
/// verdicts.csv and verdicts.h5 to the folder. `settings` as check() accepts them. Throws
/// InputError (a table of outcomes), SolverError, FileError, Interrupted.
Result run(const Settings&, const FlagParameters&, const FlowParameters&, const OutputFolder&,
           bool shows_progress);

/// The value of "lsa" in summary.json: k_x, k_y, c_m, P, omega [[re, im], [re, im]], growth,
/// frequency, mu_cr (null if none), unstable; and curve, map, most_unstable, verdicts where asked.
nlohmann::ordered_json to_json(const Result&);

}  // namespace pennon::lsa
