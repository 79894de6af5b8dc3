#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "analysis/plot.hpp"
#include "app/commands.hpp"
#include "modes/study.hpp"

namespace pennon::app {
namespace {

constexpr std::size_t most_modes_shown = 30;

std::string text_of(const modes::Result& result) {
  std::string text = "   n    m         k_x       alpha       omega   frequency\n";
  const auto& list = result.modes.modes;
  for (std::size_t i = 0; i < std::min(list.size(), most_modes_shown); ++i)
    text += fmt::format("{:4} {:4} {:11.6g} {:11.6g} {:11.6g} {:11.6g}\n", list[i].n, list[i].m,
                        list[i].k_x, list[i].alpha, list[i].omega,
                        list[i].omega / (2 * std::numbers::pi));
  if (list.size() > most_modes_shown)
    text += fmt::format("  and {} more in modes.csv\n", list.size() - most_modes_shown);
  return text;
}

nlohmann::ordered_json to_json(const modes::Decomposition& decomposition) {
  nlohmann::ordered_json json = {{"truncation_error", decomposition.truncation_error}};
  for (const modes::Amplitude& a : decomposition.amplitudes)
    json["amplitudes"].push_back({{"n", a.n}, {"m", a.m}, {"A", a.A}, {"B", a.B}});
  if (decomposition.fit) json["condition_number"] = decomposition.fit->condition_number;
  return json;
}

}  // namespace

void run_modes(const Options& options) {
  const auto prepare = [](Case& the_case) { the_case.modes.is_given = true; };
  const auto work = [](const Case& the_case, const OutputFolder& folder, Record& record) {
    const modes::Result result = [&] {
      const auto timer = record.time("modes");
      return modes::run(the_case.modes, the_case.flag, the_case.flow);
    }();
    const auto timer = record.time("output");
    write(result, folder);
    analysis::plot(folder / "modes.h5");
    nlohmann::ordered_json json = {{"normal", modes::to_json(result)}};
    std::string text = fmt::format("{}: normal modes, {}\n{}", the_case.name,
                                   name_of(result.modes.family), text_of(result));
    if (result.decomposition) {
      json["decomposition"] = to_json(*result.decomposition);
      text += fmt::format("  decomposition: truncation error {:.3g}\n",
                          result.decomposition->truncation_error);
    }
    return Answer{json, text};
  };
  run({false, prepare, work}, options);
}

}  // namespace pennon::app
