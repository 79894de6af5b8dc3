#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/figures/of_run.hpp"
#include "analysis/signal/run_report.hpp"
#include "app/commands.hpp"
#include "app/pictures.hpp"
#include "app/result_folder.hpp"
#include "app/run_of_case.hpp"

namespace pennon::app {
namespace {

analysis::Settings settings_of(const Case& the_case, const AnalyzeOptions& options) {
  analysis::Settings settings = the_case.analysis;
  if (options.from) settings.from = options.from;
  if (options.to) settings.to = options.to;
  return settings;
}

// Of a run in a case's folder beside it, else in it.
std::filesystem::path folder_for(const std::filesystem::path& run) {
  const bool is_command_folder =
      std::filesystem::absolute(run).lexically_normal().filename() == "dns";
  return (is_command_folder ? run / ".." : run) / "analysis";
}

std::string text_of(const analysis::RunAnalysis& found, const std::filesystem::path& run) {
  std::string text = fmt::format("{}\n{}", run.string(), analysis::text_of(found));
  for (const std::string& note : found.notes()) text += fmt::format("  {}\n", note);
  return text;
}

}  // namespace

void run_analyze(const AnalyzeOptions& options) {
  expect_one_rank("pennon analyze");
  Record record(options.command_line);
  const std::filesystem::path run = folder_of_run(options.run);
  analysis::require_run_folder(run);
  Case the_case(run / "case.resolved.toml", {}, {});
  the_case.analysis = settings_of(the_case, options);
  const analysis::RunAnalysis found = [&] {
    const auto timer = record.time("analyze");
    return analysis::analyze_run(run, the_case.analysis, context_of(the_case));
  }();
  const ResultFolder results(
      (options.output.empty() ? folder_for(run) : std::filesystem::path(options.output))
          .lexically_normal(),
      {.command = "analyze",
       .the_case = resolved_text(the_case.schema),
       .title = fmt::format("the run in {} with its case", run.string()),
       .files = {"trailing_edge", "growth", "spanwise_amplitudes", "waterfall", "space_and_time",
                 "forces", "flag_energy", "energy", "energy_budget", "limit_cycle"},
       .is_forced = options.force,
       .follows_run = true});
  const OutputFolder& folder = results.output();
  analysis::write_tables(found, folder);
  {
    const auto timer = record.time("pictures");
    draw_pictures([&] { analysis::draw_run(found, folder.path()); });
  }
  finish(results, record, {{{"analyze", to_json(found)}}, text_of(found, run)}, options.json,
         options.quiet);
}

}  // namespace pennon::app
