#include <fmt/format.h>

#include "analysis/plot.hpp"
#include "app/commands.hpp"
#include "common/errors.hpp"
#include "dns/flag_convergence.hpp"
#include "dns/flag_run.hpp"
#include "modes/initial_shape.hpp"

namespace pennon::app {
namespace {

std::optional<dns::Displacement> displacement_of(const Case& the_case) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  if (initial.A.empty() && initial.B.empty()) return std::nullopt;
  return modes::InitialShape(initial.A, initial.B, the_case.flag.gamma);
}

std::string text_of(const dns::RunResult& result) {
  const auto last = [&](std::size_t column) { return result.last[column]; };
  std::string text = fmt::format(
      "  {}: {} nodes, {} steps to t = {:.6g} in {:.3g} s, Newton iterations {:.2f} "
      "on average, {} at most\n",
      result.status, result.nodes, result.steps, result.t_end, result.wall_seconds,
      result.iterations_mean, result.iterations_max);
  if (result.halved_steps > 0)
    text += fmt::format("  {} steps had to be halved\n", result.halved_steps);
  text += fmt::format("  probe at ({:.6g}, {:.6g}, {:.6g}); strains {:.3g} to {:.3g}\n", last(1),
                      last(2), last(3), last(12), last(13));
  return text;
}

Answer run_convergence(const Case& the_case, const OutputFolder& folder, Record& record,
                       const Options& options) {
  const auto timer = record.time("dns");
  const dns::Convergence found =
      dns::run_convergence(the_case.dns, the_case.flag, folder, !options.quiet);
  analysis::plot(folder / "convergence.h5");
  const bool is_step = found.refinement == dns::Refinement::step;
  std::string text =
      fmt::format("{}: {}\n  {:>7} {:>14}\n", the_case.name,
                  is_step ? "a vibration with several time steps" : "equilibria on several grids",
                  dns::size_name(found.refinement), dns::value_name(found.refinement));
  for (std::size_t k = 0; k < found.sizes.size(); ++k)
    text += fmt::format("  {:7} {:14.8g}\n", found.sizes[k], found.values[k]);
  text += fmt::format("  {} {:.8g}; the error falls with the power {:.2f} of the {}\n",
                      found.is_limit_given ? "reference" : "extrapolated", found.limit, found.order,
                      is_step ? "time step" : "spacing");
  return {{{"convergence", to_json(found)}}, text};
}

}  // namespace

void run_dns(const Options& options, const std::string& restart) {
  const auto prepare = [&](Case& the_case) {
    if (the_case.has_flow)
      throw InputError(
          options.case_file,
          "has [flow], but only a flag by itself can be simulated so far; leave [flow] out");
    the_case.dns.is_given = true;
  };
  const auto work = [&](const Case& the_case, const OutputFolder& folder,
                        Record& record) -> Answer {
    if (the_case.dns.convergence.is_given)
      return run_convergence(the_case, folder, record, options);
    std::optional<std::filesystem::path> checkpoint;
    if (!restart.empty()) checkpoint = restart;
    const dns::RunResult result = [&] {
      const auto timer = record.time("dns");
      return dns::run(the_case.dns, the_case.flag, displacement_of(the_case), checkpoint, folder,
                      !options.quiet);
    }();
    const auto timer = record.time("pictures");
    if (!the_case.dns.flag.equilibrium) analysis::plot(folder / "history.h5");
    if (std::filesystem::exists(folder / "shapes.h5")) analysis::plot(folder / "shapes.h5");
    return Answer{{{"dns", to_json(result)}},
                  fmt::format("{}: the flag by itself\n{}", the_case.name, text_of(result))};
  };
  run({false, prepare, work}, options);
}

}  // namespace pennon::app
