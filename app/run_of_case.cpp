#include "app/run_of_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/signal/run_history.hpp"
#include "common/errors.hpp"

namespace pennon::app {
namespace {

// The lines of the flag and the stream in a resolved case.
std::vector<std::string> physics_of(const Case& the_case) {
  std::istringstream text(resolved_text(the_case.schema));
  std::vector<std::string> lines;
  bool is_physics = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("[")) is_physics = line == "[flag]" || line == "[flow]";
    if (is_physics) lines.push_back(line);
  }
  return lines;
}

// The first line in which the run differs, for a sentence; empty: none does.
std::string difference(const Case& there, const Case& here) {
  const std::vector<std::string> its = physics_of(there), ours = physics_of(here);
  for (std::size_t k = 0; k < std::max(its.size(), ours.size()); ++k) {
    const auto line = [&](const std::vector<std::string>& lines) {
      return k < lines.size() ? lines[k] : std::string("nothing");
    };
    if (line(its) != line(ours)) return fmt::format("{} there, {} here", line(its), line(ours));
  }
  return {};
}

double wall_seconds(const std::filesystem::path& folder) {
  std::ifstream file(folder / "summary.json");
  const auto summary = nlohmann::json::parse(file, nullptr, false);
  if (!summary.is_object() || !summary.contains("dns")) return NAN;
  return summary["dns"].value("wall_s", NAN);
}

}  // namespace

analysis::RunContext context_of(const Case& the_case) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  return {.U = the_case.flow.U,
          .ramp = initial.ramp,
          .release = initial.release,
          .kick_end = initial.kick == 0 ? 0 : initial.release + initial.kick_duration};
}

std::optional<RunOfCase> find_run(const Case& the_case, const std::string& asked,
                                  const std::filesystem::path& usual) {
  const std::filesystem::path folder = asked.empty() ? usual : std::filesystem::path(asked);
  if (asked.empty() && !std::filesystem::exists(folder / "history.h5")) return std::nullopt;
  analysis::require_run_folder(folder);
  RunOfCase run{folder,
                std::make_unique<Case>(folder / "case.resolved.toml",
                                       std::span<const std::string>{}, Asked{}),
                wall_seconds(folder)};
  if (const std::string what = difference(*run.the_case, the_case); !what.empty())
    throw InputError("--run", fmt::format("the run in {} is of another flag or stream: {}",
                                          folder.string(), what));
  return run;
}

}  // namespace pennon::app
