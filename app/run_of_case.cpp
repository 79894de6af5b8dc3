#include "app/run_of_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/signal/run_history.hpp"
#include "app/result_folder.hpp"
#include "common/case/case_difference.hpp"
#include "common/errors.hpp"

namespace pennon::app {
namespace {

bool is_physics(const std::string& key) {
  return key.starts_with("flag.") || key.starts_with("flow.");
}

// NaN where the run has not come to its end, or its summary is not one of pennon's.
double wall_seconds(const std::filesystem::path& folder) {
  const auto summary = nlohmann::json::parse(text_of_file(folder / "summary.json"), nullptr, false);
  const auto seconds = nlohmann::json::json_pointer("/dns/wall_s");
  if (!summary.is_object() || !summary.contains(seconds) || !summary[seconds].is_number())
    return NAN;
  return summary[seconds].get<double>();
}

}  // namespace

analysis::RunContext context_of(const Case& the_case) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  return {.mu = the_case.flag.mu,
          .U = the_case.flow.U,
          .ramp = initial.ramp,
          .release = initial.release,
          .kick_end = initial.kick == 0 ? 0 : initial.release + initial.kick_duration};
}

std::filesystem::path folder_of_run(const std::filesystem::path& given) {
  const char* name = "history.h5";
  if (!std::filesystem::exists(given / name) && std::filesystem::exists(given / "dns" / name))
    return given / "dns";
  return given;
}

std::optional<RunOfCase> find_run(const Case& the_case, const std::string& asked,
                                  const std::filesystem::path& usual) {
  const std::filesystem::path folder =
      folder_of_run(asked.empty() ? usual : std::filesystem::path(asked));
  if (asked.empty() && !std::filesystem::exists(folder / "history.h5")) return std::nullopt;
  analysis::require_run_folder(folder);
  RunOfCase run{folder,
                std::make_unique<Case>(folder / "case.resolved.toml",
                                       std::span<const std::string>{}, Asked{}),
                wall_seconds(folder)};
  const auto differences = case_differences(resolved_text(run.the_case->schema), folder.string(),
                                            resolved_text(the_case.schema), is_physics);
  if (!differences.empty())
    throw InputError("--run", fmt::format("the run in {} is of another flag or stream: {}",
                                          folder.string(), text_of(differences)));
  return run;
}

}  // namespace pennon::app
