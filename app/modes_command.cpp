#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "app/global_pictures.hpp"
#include "app/global_process.hpp"
#include "app/pictures.hpp"
#include "modes/global/study/coupled_problem.hpp"
#include "modes/global/study/modes_report.hpp"
#include "modes/normal/report.hpp"

namespace pennon::app {
namespace {

Answer normal_modes(const Case& the_case, const OutputFolder& folder, Record& record) {
  const modes::Result result = [&] {
    const auto timer = record.time("modes");
    return modes::run(the_case.modes, the_case.flag, the_case.flow);
  }();
  const auto timer = record.time("output");
  write_tables(result, folder);
  draw_pictures([&] { analysis::plot(folder / "modes.h5"); });
  Answer answer{{{"normal", to_json(result)}},
                fmt::format("{}: normal modes, {}\n{}", the_case.name, name_of(result.modes.family),
                            text_of(result))};
  if (result.decomposition) answer.json["decomposition"] = to_json(*result.decomposition);
  return answer;
}

// The value of "global".
Answer global_modes(const Case& the_case, const OutputFolder& folder, bool shows_progress) {
  const modes::global::Problem problem(the_case.flag, the_case.flow, the_case.global_modes);
  const modes::global::Findings found = solve_global_modes(problem, folder, shows_progress);
  if (!found.spectrum.modes.empty()) {
    write_tables(found.spectrum, folder);
    draw_pictures([&] { analysis::plot(folder / "global_modes.h5"); });
  }
  Answer answer{to_json(found.spectrum), text_of(found.spectrum)};
  if (found.neutral) {
    write_tables(*found.neutral, folder);
    if (!found.neutral->points.empty()) {
      const std::filesystem::path picture = folder / "global_neutral.h5";
      write_hdf5(*found.neutral, neutral_picture(the_case, *found.neutral), picture);
      draw_pictures([&] { analysis::plot(picture); });
    }
    answer.json.update(to_json(*found.neutral));
    answer.text += text_of(*found.neutral);
  }
  if (found.map) {
    write_tables(*found.map, folder);
    const std::filesystem::path picture = folder / "global_map.h5";
    write_hdf5(*found.map, map_picture(the_case), picture);
    draw_pictures([&] { analysis::plot(picture); });
    answer.json["map"] = to_json(*found.map);
    answer.text += text_of(*found.map, the_case.global_modes.map.lambda_tolerance);
  }
  return answer;
}

}  // namespace

void run_modes(const Options& options) {
  const auto expect = [](const Case& the_case) {
    if (the_case.global_modes.is_given) (void)modes::global::grid_of(the_case.global_modes);
    if (the_case.global_modes.is_given)
      expect_one_rank_for_global_modes();
    else
      expect_one_rank("pennon modes");
  };
  const auto work = [&](const Case& the_case, const OutputFolder& folder, Record& record) {
    Answer answer = normal_modes(the_case, folder, record);
    if (the_case.global_modes.is_given) {
      const auto timer = record.time("global modes");
      const Answer global = global_modes(the_case, folder, !options.quiet);
      answer.json["global"] = global.json;
      answer.text += global.text;
    }
    return answer;
  };
  run({.name = "modes",
       .files = {"modes", "decomposition", "global"},
       .asked = {.modes = true},
       .expect = expect,
       .work = work},
      options);
}

}  // namespace pennon::app
