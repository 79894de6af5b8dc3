/// What a case asks of the normal modes: the tables [modes.normal] and [modes.decompose].
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "modes/normal/in_vacuo.hpp"
#include "modes/normal/normal_modes.hpp"

namespace pennon::modes {

/// A displacement to decompose: samples, or the amplitudes of initial_shape.hpp.
struct DecomposeSettings {
  bool is_given = false;
  std::string samples;
  std::vector<double> A, B;
};

struct Settings {
  bool is_given = false;
  Family family = Family::bessel;
  std::vector<std::int64_t> n;  ///< empty: see mode_range()
  std::int64_t m = 3;
  TensionProfile tension = TensionProfile::blasius;
  std::int64_t elements = 200;
  std::int64_t shape_points = 201;
  DecomposeSettings decompose;
};

/// The family as a case file names it.
const std::string& name_of(Family);

void declare(Schema&, Settings&);

/// The faults between keys: modes that the family, the flag or the resolution does not have, a
/// decomposition of nothing or of two things. `is_asked_for`: whether the modes are to be found
/// even if the case has no [modes.normal].
void check(const Settings&, const FlagParameters&, const FlowParameters&, bool is_asked_for,
           Faults&);
/// The faults of asking the family for the modes with the numbers 1 to m along the chord, as the
/// key m of another table does.
void check_family(const Settings&, std::int64_t m, const std::string& table, const FlagParameters&,
                  const FlowParameters&, Faults&);

/// The n of the case in increasing order, each once. Where the case names none they are 0, 1 and 2,
/// in two dimensions 0 alone.
ModeRange mode_range(const Settings&, const FlagParameters&);

}  // namespace pennon::modes
