#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "analysis/signal/run_study.hpp"
#include "app/commands.hpp"
#include "app/compare_report.hpp"
#include "app/global_process.hpp"
#include "app/kept_modes.hpp"
#include "app/run_of_case.hpp"
#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "lsa/settings.hpp"

namespace pennon::app {
namespace {

double k_x_of(std::int64_t waves, const FlagParameters& flag) {
  return flag.gamma ? 2 * std::numbers::pi * static_cast<double>(waves) / *flag.gamma : 0;
}

ComparedModel local_row(const Case& the_case, std::int64_t waves) {
  const StopWatch watch;
  lsa::Point point = lsa::point_of(the_case.flag, the_case.flow, the_case.lsa);
  point.k_x = k_x_of(waves, the_case.flag);
  const lsa::Stability found = lsa::solve(point, the_case.lsa.theory);
  ComparedModel row{"local", waves, found.growth, found.frequency, found.is_unstable(), 0};
  row.wall_seconds = watch.seconds();
  return row;
}

// Where global modes may lie, and whether they are to be looked for.
struct ModesPlaces {
  const OutputFolder& own;            // with a folder for each number of waves
  std::filesystem::path of_the_case;  // of `pennon modes`
  bool are_looked_for;
};

// Those that an earlier command left for this problem, with a note that says so, or found now.
modes::global::FoundModes global_modes(const modes::global::Problem& problem, std::int64_t waves,
                                       const ModesPlaces& places, std::vector<std::string>& notes) {
  const OutputFolder its_own(places.own / fmt::format("global_{}", waves));
  if (places.are_looked_for)
    for (const std::filesystem::path& folder :
         {its_own.path(), places.of_the_case, places.own.path().parent_path() / "modes"})
      if (auto kept = kept_global_modes(problem, folder)) {
        notes.push_back(fmt::format(
            "the global modes with {} waves along the span are those in {}, of the same problem; "
            "--force finds them anew",
            waves, folder.string()));
        return std::move(kept->spectrum);
      }
  try {
    return solve_global_modes(problem, its_own, false).spectrum;
  } catch (const Interrupted&) {
    stop_if_interrupted(
        "the global modes found before are kept; the same command goes on with them");
    throw;
  }
}

// The mode of flag or wake that grows most, of either direction along the span, of a flag with as
// many spanwise nodes as the simulation's.
ComparedModel global_row(const Case& the_case, std::int64_t waves, const ModesPlaces& places,
                         std::vector<std::string>& notes) {
  modes::global::Settings settings = the_case.global_modes;
  settings.k_x = k_x_of(waves, the_case.flag);
  settings.n_modes = std::max<std::int64_t>(settings.n_modes, 1);
  settings.neutral.is_given = settings.map.is_given = false;
  settings.frames = 0;
  constexpr std::int64_t fewest_nodes = 3;
  if (waves > 0) settings.n_x = std::max(fewest_nodes, the_case.dns.n_x / waves);
  const modes::global::Problem problem(the_case.flag, the_case.flow, settings);
  const modes::global::FoundModes found = global_modes(problem, waves, places, notes);
  ComparedModel row{
      .model = "global",
      .waves = waves,
      .wall_seconds = found.base_seconds + found.operator_seconds + found.eigen_seconds};
  const auto first = std::ranges::find_if(found.modes, [](const modes::global::GlobalMode& mode) {
    return mode.kind != modes::global::ModeKind::box;
  });
  if (first == found.modes.end()) {
    notes.push_back(fmt::format(
        "all global modes found with {} waves along the span belong to the box in which the flow "
        "is computed; a larger modes.global.R, or modes.global.target, may find the flag's",
        waves));
    return row;
  }
  const std::complex<double> lambda = first->lambda;
  const double frequency = lambda.imag() / (2 * std::numbers::pi);
  row.growth = lambda.real();
  row.frequency = std::abs(frequency);
  row.is_unstable = *row.growth > 0;
  // exp(i (k_x x + 2 pi f t)): with f < 0 towards positive x.
  if (waves > 0 && the_case.flow.U != 0) row.travels_with_U = frequency * the_case.flow.U < 0;
  return row;
}

// The linear phase of a run; whether it ended flapping.
ComparedModel dns_row(const RunOfCase& run, std::vector<std::string>& notes) {
  const analysis::RunAnalysis found =
      analysis::analyze_run(run.folder, run.the_case->analysis, context_of(*run.the_case));
  ComparedModel row{.model = "dns", .wall_seconds = run.wall_seconds};
  if (const auto& growth = found.linear.growth) {
    row.waves = static_cast<double>(found.linear.wave);
    row.growth = growth->sigma;
    row.frequency = growth->omega / (2 * std::numbers::pi);
    row.is_unstable = growth->sigma > 0;
  }
  if (found.limit_cycle.cycle) row.is_unstable = true;
  for (const std::string& note : found.notes()) notes.push_back(note);
  return row;
}

}  // namespace

void run_compare(const Options& options, const std::string& run_folder) {
  const std::string name = std::filesystem::path(options.case_file).stem().string();
  const std::filesystem::path usual = std::filesystem::path("results") / name;
  std::optional<RunOfCase> run_found;
  const auto expect = [&](const Case& the_case) {
    expect_one_rank_for_global_modes();
    run_found = find_run(the_case, run_folder, usual);
  };
  const auto work = [&](const Case& the_case, const OutputFolder& folder, Record& record) {
    std::vector<ComparedModel> rows;
    std::vector<std::string> notes;
    const std::vector<std::int64_t> all_waves = waves_of(the_case.compare, the_case.flag);
    rows.reserve(2 * all_waves.size() + 1);
    for (const std::int64_t waves : all_waves) rows.push_back(local_row(the_case, waves));
    Progress progress("global modes", static_cast<std::int64_t>(all_waves.size()), !options.quiet);
    const ModesPlaces places{folder, usual / "modes", !options.force};
    for (const std::int64_t waves : all_waves) {
      const auto timer = record.time("global modes");
      rows.push_back(global_row(the_case, waves, places, notes));
      progress.advance_to(static_cast<std::int64_t>(rows.size()) -
                          static_cast<std::int64_t>(all_waves.size()));
    }
    const auto timer = record.time("analyze");
    if (run_found)
      rows.push_back(dns_row(*run_found, notes));
    else
      notes.push_back(fmt::format("no simulation to compare with in {}; pennon dns {} makes one",
                                  usual.string(), options.case_file));
    write_table(rows, folder);
    std::string text = fmt::format("{}: side by side\n{}", the_case.name, text_of(rows));
    for (const std::string& note : notes) text += "  " + note + "\n";
    return Answer{{{"compare", to_json(rows)}}, text};
  };
  const Asked asked{.flow = true, .lsa = true, .global_modes = true, .compare = true};
  run({.name = "compare", .files = {"compare"}, .asked = asked, .expect = expect, .work = work},
      options);
}

}  // namespace pennon::app
