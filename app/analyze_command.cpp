#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "analysis/figures/of_run.hpp"
#include "analysis/signal/run_report.hpp"
#include "app/commands.hpp"
#include "app/run_of_case.hpp"
#include "common/io/atomic_file.hpp"

namespace pennon::app {
namespace {

analysis::Settings settings_of(const Case& the_case, const AnalyzeOptions& options) {
  analysis::Settings settings = the_case.analysis;
  if (options.from) settings.from = options.from;
  if (options.to) settings.to = options.to;
  return settings;
}

void print(const analysis::RunAnalysis& found, const AnalyzeOptions& options,
           const OutputFolder& folder) {
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"analyze", to_json(found)}}.dump());
    return;
  }
  if (options.quiet) return;
  fmt::print("{}\n{}", options.run, analysis::text_of(found));
  for (const std::string& note : found.notes()) fmt::print("  {}\n", note);
  fmt::print("  results in {}\n", folder.path().string());
}

}  // namespace

void run_analyze(const AnalyzeOptions& options) {
  Record record(options.command_line);
  const std::filesystem::path run = options.run;
  analysis::require_run_folder(run);
  const Case the_case(run / "case.resolved.toml", {}, {});
  const analysis::RunAnalysis found = [&] {
    const auto timer = record.time("analyze");
    return analysis::analyze_run(run, settings_of(the_case, options), context_of(the_case));
  }();
  const OutputFolder folder(options.output.empty() ? run / "analysis"
                                                   : std::filesystem::path(options.output));
  analysis::write_tables(found, folder);
  write_file(folder / "summary.json",
             nlohmann::ordered_json{{"analyze", to_json(found)}}.dump(2) + "\n");
  {
    const auto timer = record.time("pictures");
    analysis::draw_run(found, folder.path());
  }
  record.write(folder / "record.json", 1);
  print(found, options, folder);
}

}  // namespace pennon::app
