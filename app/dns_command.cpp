#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "app/pictures.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/run/flag_convergence.hpp"
#include "dns/run/flag_run.hpp"
#include "dns/run/fluid_run.hpp"
#include "dns/run/preflight.hpp"
#include "dns/run/run_report.hpp"
#include "modes/normal/initial_shape.hpp"
#include "modes/normal/study.hpp"

namespace pennon::app {
namespace {

// A normal mode of the family of [modes.normal], of largest displacement 1.
dns::ShapeFunction mode_of(const Case& the_case, std::int64_t n, std::int64_t m) {
  modes::Settings settings = the_case.modes;
  settings.n = {n};
  settings.m = m;
  const modes::NormalModes found = modes::run(settings, the_case.flag, the_case.flow).modes;
  const modes::NormalMode mode = found.modes.back();
  constexpr int points = 200;
  double largest = 0;
  for (int k = 0; k <= points; ++k)
    largest = std::max(largest, std::abs(mode.shape(static_cast<double>(k) / points)));
  return [mode, largest](double x, double y) {
    return mode.shape(y) / largest * std::cos(mode.k_x * x);
  };
}

// z of the flag at its start, or of its prescribed mode; none where it is straight, or starts as a
// global mode.
std::optional<dns::ShapeFunction> shape_of(const Case& the_case) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  const bool is_prescribed = the_case.has_flow && the_case.dns.motion.is_given;
  if (const auto use = normal_mode_of(the_case.dns, the_case.has_flow)) {
    const double amplitude = is_prescribed ? 1 : initial.mode_amplitude;
    return [amplitude, mode = mode_of(the_case, use->n, use->m)](double x, double y) {
      return amplitude * mode(x, y);
    };
  }
  if (is_prescribed || !initial.global_modes.empty()) return std::nullopt;
  if (initial.A.empty() && initial.B.empty()) return std::nullopt;
  return modes::InitialShape(initial.A, initial.B, the_case.flag.gamma);
}

Answer run_fluid(const Case& the_case, const dns::Beginning& beginning, const OutputFolder& folder,
                 Record& record, const Options& options) {
  const dns::FluidRunResult result = [&] {
    const auto timer = record.time("dns");
    return dns::run_fluid(the_case.dns, the_case.flag, the_case.flow, shape_of(the_case), beginning,
                          folder, !options.quiet && ranks::is_leading());
  }();
  const auto timer = record.time("pictures");
  if (ranks::is_leading())
    draw_pictures([&] {
      analysis::plot(folder / "history.h5");
      if (std::filesystem::exists(folder / "shapes.h5")) analysis::plot(folder / "shapes.h5");
    });
  return {{{"dns", to_json(result)}},
          fmt::format("{}: {}\n{}", the_case.name,
                      result.is_coupled ? "flag and flow together"
                                        : "the fluid about a flag that moves as prescribed",
                      text_of(result, the_case.dns.fluid.wall_spacing))};
}

Answer run_convergence(const Case& the_case, const OutputFolder& folder, Record& record,
                       const Options& options) {
  const auto timer = record.time("dns");
  const dns::Convergence found =
      dns::run_convergence(the_case.dns, the_case.flag, folder, !options.quiet);
  dns::write(found, folder);
  draw_pictures([&] { analysis::plot(folder / "convergence.h5"); });
  return {{{"convergence", to_json(found)}},
          fmt::format("{}: {}\n{}", the_case.name, title_of(found), text_of(found))};
}

// From t = 0, or from the checkpoint that was given.
dns::Beginning beginning_of(const Case& the_case, const RestartOptions& restart) {
  const std::string text = resolved_text(the_case.schema);
  if (!restart.checkpoint) {
    if (restart.change)
      throw InputError("--change", "is of a restart: it goes with --restart CHECKPOINT");
    return {{text, {}}, {}};
  }
  if (restart.checkpoint->empty())
    throw InputError("--restart", fmt::format("is empty; it names a checkpoint, for example "
                                              "results/{}/dns/checkpoint.h5",
                                              the_case.name));
  if (the_case.dns.convergence.is_given || (!the_case.has_flow && the_case.dns.flag.equilibrium))
    throw InputError("--restart",
                     "is of a run through time; a convergence study and an equilibrium have no "
                     "checkpoints");
  return dns::beginning_at(*restart.checkpoint, text, the_case.dns.t_end, restart.change);
}

}  // namespace

void run_dns(const Options& options, const RestartOptions& restart) {
  dns::Beginning beginning;
  const auto expect = [&](const Case& the_case) {
    if (!the_case.has_flow && ranks::count() > 1)
      throw InputError("mpiexec", fmt::format("started {} ranks, but a flag by itself runs on one",
                                              ranks::count()));
    if (!the_case.dns.convergence.is_given)
      dns::expect_start(the_case.dns, the_case.flag, the_case.has_flow, shape_of(the_case));
    beginning = beginning_of(the_case, restart);
  };
  const auto work = [&](const Case& the_case, const OutputFolder& folder,
                        Record& record) -> Answer {
    if (the_case.dns.convergence.is_given)
      return run_convergence(the_case, folder, record, options);
    for (const dns::CaseChange& change : beginning.the_case.changes)
      record.add_change(change.t, change.key, change.before, change.after);
    if (the_case.has_flow) return run_fluid(the_case, beginning, folder, record, options);
    const dns::FlagRunResult result = [&] {
      const auto timer = record.time("dns");
      return dns::run_flag(the_case.dns, the_case.flag, shape_of(the_case), beginning, folder,
                           !options.quiet);
    }();
    const auto timer = record.time("pictures");
    draw_pictures([&] {
      if (!the_case.dns.flag.equilibrium) analysis::plot(folder / "history.h5");
      if (std::filesystem::exists(folder / "shapes.h5")) analysis::plot(folder / "shapes.h5");
    });
    return Answer{{{"dns", to_json(result)}},
                  fmt::format("{}: the flag by itself\n{}", the_case.name, text_of(result))};
  };
  run({.name = "dns",
       .files = {"history", "shapes", "fields", "checkpoint", "convergence"},
       .asked = {.dns = true},
       .expect = expect,
       .work = work,
       .checkpoint = [&] { return beginning.checkpoint; }},
      options);
}

}  // namespace pennon::app
