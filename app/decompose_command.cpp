#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/decomposition/foreign_file.hpp"
#include "analysis/decomposition/report.hpp"
#include "analysis/decomposition/run_source.hpp"
#include "analysis/decomposition/study.hpp"
#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "app/pictures.hpp"
#include "app/result_folder.hpp"
#include "app/run_of_case.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "modes/normal/study.hpp"

namespace pennon::app {
namespace {

namespace fs = std::filesystem;
using decomposition::Of;

// A case's [decompose] without the rest of a case, for the data of other codes.
struct TableAlone {
  decomposition::Settings settings;
  Schema schema;

  TableAlone(const std::string& source, const std::vector<std::string>& overrides) {
    declare(schema, settings);
    Faults faults = read_case_text("[decompose]\n", source, overrides, schema);
    check(settings, faults);
    faults.raise();
    settings.is_given = true;
  }
};

std::unique_ptr<decomposition::Snapshots> open_file(const fs::path& path,
                                                    const decomposition::Settings& settings) {
  if (path.extension() == ".csv")
    return decomposition::open_signals(path, settings.window_of_time());
  return decomposition::open_foreign_file(
      path, settings.of == Of::flag ? decomposition::Foreign::flag : decomposition::Foreign::field,
      settings.window_of_time());
}

std::unique_ptr<decomposition::Snapshots> open_run(const fs::path& run, double mu,
                                                   const decomposition::Settings& settings) {
  return settings.of == Of::flag ? decomposition::open_run_flag(run, mu, settings.window_of_time())
                                 : decomposition::open_run_fluid(run, settings.window_of_time());
}

// Those of [decompose] alone; a path given on the command line counts from where that is typed.
std::vector<std::string> checked(std::vector<std::string> overrides) {
  constexpr std::string_view path_key = "decompose.global_modes=";
  for (std::string& assignment : overrides) {
    if (!assignment.starts_with("decompose."))
      throw InputError("--set " + assignment,
                       "is no setting of pennon decompose, which takes decompose.key=value");
    if (!assignment.starts_with(path_key)) continue;
    const std::string path = assignment.substr(path_key.size());
    if (!path.starts_with('"'))
      assignment = fmt::format("{}{}", path_key, fs::absolute(path).string());
  }
  return overrides;
}

// results/<name of the file>/decompose, or beside the results of a run.
fs::path usual_folder(const fs::path& source, bool is_run) {
  if (!is_run) return fs::path("results") / source.stem() / "decompose";
  const bool is_command_folder = fs::absolute(source).lexically_normal().filename() == "dns";
  return (is_command_folder ? source / ".." : source) / "decompose";
}

// What a projection projects on. `beside`: the folder of the results of a run's case.
std::vector<decomposition::GivenMode> given_modes(const decomposition::Settings& settings,
                                                  const Case* the_case, const fs::path& beside) {
  using decomposition::Method;
  if (settings.method == Method::normal_modes) {
    if (the_case == nullptr)
      throw InputError("[decompose]",
                       "decompose.method = \"normal_modes\" is of a run, whose case says "
                       "what the flag is");
    return decomposition::given_modes(
        modes::run(the_case->modes, the_case->flag, the_case->flow).modes);
  }
  if (settings.method != Method::global_modes) return {};
  if (settings.global_modes.empty() && the_case == nullptr)
    throw InputError("[decompose]",
                     "decompose.global_modes is missing: the file in which pennon "
                     "modes left them");
  return decomposition::given_global_modes(settings.global_modes.empty()
                                               ? beside / "modes" / "global_modes.h5"
                                               : fs::path(settings.global_modes),
                                           settings.n_modes);
}

void work(const DecomposeOptions& options, const fs::path& source, bool is_run,
          const Schema& schema, const decomposition::Settings& settings,
          std::unique_ptr<decomposition::Snapshots> snapshots,
          std::vector<decomposition::GivenMode> given, Record& record) {
  ResultFolder results(
      (options.output.empty() ? usual_folder(source, is_run) : fs::path(options.output))
          .lexically_normal(),
      {.command = "decompose",
       .the_case = resolved_text(schema),
       .title = fmt::format("{} as it was decomposed", source.string()),
       .files = {"decomposition"},
       .is_forced = options.force,
       .follows_run = true});
  const decomposition::Decomposition found = [&] {
    const auto timer = record.time("decompose");
    try {
      return decomposition::decompose(std::move(snapshots), settings, results.output(),
                                      std::move(given));
    } catch (...) {  // before anything was written
      results.withdraw();
      throw;
    }
  }();
  if (!ranks::is_leading()) return;
  decomposition::write_table(found, results.output());
  {
    const auto timer = record.time("pictures");
    draw_pictures([&] { analysis::plot(results.output() / "decomposition.h5"); });
  }
  std::string text = decomposition::text_of(found);
  for (const std::string& note : found.notes) text += fmt::format("  note: {}\n", note);
  finish(results, record, {{{"decompose", to_json(found)}}, text}, options.json, options.quiet);
}

}  // namespace

void run_decompose(const DecomposeOptions& options) {
  Record record(options.command_line);
  const std::vector<std::string> overrides = checked(options.overrides);
  const fs::path given = options.source;
  if (!fs::exists(given))
    throw InputError(given.string(),
                     "there is no such file or folder; pennon decompose takes the folder of "
                     "a run of pennon dns, an HDF5 file or a CSV file");
  if (fs::is_directory(given)) {
    const fs::path run = folder_of_run(given);
    const fs::path the_case_file = run / "case.resolved.toml";
    if (!fs::exists(the_case_file))
      throw InputError(given.string(),
                       "has no case.resolved.toml; pennon decompose takes the folder of a run "
                       "of pennon dns, or of its case");
    const bool is_on_normal_modes =
        Case(the_case_file, overrides, {}).decompose.method == decomposition::Method::normal_modes;
    // Then they are checked too.
    const Case the_case(the_case_file, overrides, {.modes = is_on_normal_modes});
    try {
      work(options, run, true, the_case.schema, the_case.decompose,
           open_run(run, the_case.flag.mu, the_case.decompose),
           given_modes(the_case.decompose, &the_case, usual_folder(run, true).parent_path()),
           record);
    } catch (const InputError& fault) {
      throw the_case.located(fault);
    }
    return;
  }
  const TableAlone asked("--set", overrides);
  work(options, given, false, asked.schema, asked.settings, open_file(given, asked.settings),
       given_modes(asked.settings, nullptr, {}), record);
}

}  // namespace pennon::app
