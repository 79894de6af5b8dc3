/// What runs found, for summary.json, tables, files and the reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/io/output_folder.hpp"
#include "dns/run/flag_convergence.hpp"
#include "dns/run/flag_run.hpp"
#include "dns/run/fluid_run.hpp"

namespace pennon::dns {

/// The value of "dns" in summary.json.
nlohmann::ordered_json to_json(const FlagRunResult&);
nlohmann::ordered_json to_json(const FluidRunResult&);
/// The value of "convergence" beside it.
nlohmann::ordered_json to_json(const Convergence&);

/// Indented lines.
std::string text_of(const FlagRunResult&);
/// `wall_spacing`: dns.wall_spacing of the case.
std::string text_of(const FluidRunResult&, double wall_spacing);
std::string text_of(const Convergence&);
/// What was refined: "a vibration with several time steps" or "equilibria on several grids".
std::string title_of(const Convergence&);

/// Writes convergence.csv and convergence.h5 (kind = "flag_convergence"). Throws FileError.
void write(const Convergence&, const OutputFolder&);

}  // namespace pennon::dns
