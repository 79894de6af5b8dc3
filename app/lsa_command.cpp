#include <fmt/format.h>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "app/pictures.hpp"
#include "lsa/report.hpp"

namespace pennon::app {

void run_lsa(const Options& options) {
  const auto work = [&](const Case& the_case, const OutputFolder& folder, Record& record) {
    const lsa::Result result = [&] {
      const auto timer = record.time("lsa");
      lsa::Result found =
          lsa::run(the_case.lsa, the_case.flag, the_case.flow, folder, !options.quiet);
      write_tables(found, folder);
      return found;
    }();
    const auto timer = record.time("pictures");
    draw_pictures([&] {
      if (result.curve) analysis::plot(folder / "curve.h5");
      if (result.map) analysis::plot(folder / "map.h5");
      if (result.verdicts) analysis::plot(folder / "verdicts.h5");
    });
    return Answer{{{"lsa", to_json(result)}},
                  fmt::format("{}: local stability\n{}", the_case.name, text_of(result))};
  };
  run({.name = "lsa",
       .files = {"curve", "map", "neutral", "verdicts"},
       .asked = {.flow = true, .lsa = true},
       .expect = [](const Case&) { expect_one_rank("pennon lsa"); },
       .work = work},
      options);
}

}  // namespace pennon::app
