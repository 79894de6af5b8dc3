/// The crossing from pennon-global, which finds global modes, to pennon, which reports them: two
/// processes, and between them a file (global_modes.json) that only these functions write and read.
///
/// Every member of the structs crosses, and numbers read back to the same bits: NaN is null, the
/// infinities are "inf" and "-inf", what is absent has no key.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "modes/global/study/growth_map.hpp"
#include "modes/global/study/neutral_curve.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// What a case asked of the global modes.
struct Findings {
  FoundModes spectrum;
  std::optional<NeutralCurve> neutral = {};  ///< where [modes.global.neutral] is given
  std::optional<GrowthMap> map = {};         ///< where [modes.global.map] is given
};

nlohmann::ordered_json to_wire(const Findings&);
/// Throws nlohmann::json::exception where a member is missing or of another type.
Findings from_wire(const nlohmann::ordered_json&);

/// The same of what is kept on the way (kept_pieces.hpp).
nlohmann::ordered_json to_wire(const CurveProgress&);
nlohmann::ordered_json to_wire(const MapProgress&);
void from_wire(const nlohmann::ordered_json&, CurveProgress&);
void from_wire(const nlohmann::ordered_json&, MapProgress&);

/// Writes them to a file, whole or not at all. Throws FileError.
void write_findings(const Findings&, const std::filesystem::path&);
/// Throws FileError, which names the file, where it cannot be read or is not one of these.
Findings read_findings(const std::filesystem::path&);

}  // namespace pennon::modes::global
