#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/run/flag_convergence.hpp"
#include "dns/run/flag_run.hpp"
#include "dns/run/fluid_run.hpp"
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

// Where the flag starts, unless straight.
std::optional<dns::ShapeFunction> displacement_of(const Case& the_case) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  if (!initial.global_modes.empty()) return std::nullopt;
  if (const double amplitude = initial.mode_amplitude; amplitude != 0)
    return [amplitude, mode = mode_of(the_case, initial.n, initial.m)](double x, double y) {
      return amplitude * mode(x, y);
    };
  if (initial.A.empty() && initial.B.empty()) return std::nullopt;
  return modes::InitialShape(initial.A, initial.B, the_case.flag.gamma);
}

// What the flow's run needs of the flag's shape.
std::optional<dns::ShapeFunction> shape_in_flow(const Case& the_case) {
  const dns::MotionSettings& motion = the_case.dns.motion;
  if (!motion.is_given) return displacement_of(the_case);
  if (motion.kind != dns::MotionKind::mode) return std::nullopt;
  return mode_of(the_case, motion.n, motion.m);
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

std::string text_of(const dns::FluidRunResult& result, double wall_spacing) {
  const auto last = [&](const char* name) {
    const auto& columns = dns::columns_of_fluid_history();
    const auto* found = std::ranges::find_if(columns, [&](const dns::HistoryColumn& column) {
      return column.name == std::string(name);
    });
    return result.last[static_cast<std::size_t>(found - columns.begin())];
  };
  std::string text = fmt::format(
      "  {}: {} cells, {} steps to t = {:.6g} in {:.3g} s, {:.3g} ns per cell and step\n"
      "  pressure iterations {:.2f} on average, {} at most; least area of a cell {:.3f} of that at "
      "rest\n"
      "  C_D = {:.6g}, C_L = {:.6g}, energy defect {:.3g}\n",
      result.status, result.cells, result.steps, result.t_end, result.wall_seconds,
      1e9 * result.step_seconds / static_cast<double>(std::max<std::int64_t>(result.steps, 1)) /
          static_cast<double>(result.cells),
      result.pressure_iterations_mean, result.pressure_iterations_max, result.least_area,
      last("C_D"), last("C_L"), last("energy_defect"));
  constexpr double much_thicker = 3;
  if (result.largest_wall_area > much_thicker)
    text += fmt::format(
        "  cells at the flag grew to {:.1f} times their thickness at rest, so the flow there is "
        "resolved as with dns.wall_spacing = {:.3g}; a smaller dns.wall_spacing shows whether that "
        "matters\n",
        result.largest_wall_area, result.largest_wall_area * wall_spacing);
  if (result.is_coupled)
    text += fmt::format(
        "  z of the trailing edge {:.6g}; coupling passes {:.2f} on average, {} at most\n",
        last("z_trailing_edge"), result.passes_mean, result.passes_max);
  return text;
}

Answer run_fluid(const Case& the_case, const std::optional<std::filesystem::path>& checkpoint,
                 const OutputFolder& folder, Record& record, const Options& options) {
  const dns::FluidRunResult result = [&] {
    const auto timer = record.time("dns");
    return dns::run_fluid(the_case.dns, the_case.flag, the_case.flow, shape_in_flow(the_case),
                          checkpoint, folder, !options.quiet && ranks::is_leading());
  }();
  const auto timer = record.time("pictures");
  if (ranks::is_leading()) analysis::plot(folder / "history.h5");
  if (ranks::is_leading() && std::filesystem::exists(folder / "shapes.h5"))
    analysis::plot(folder / "shapes.h5");
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
    if (!the_case.has_flow && ranks::count() > 1)
      throw InputError("mpiexec", fmt::format("started {} ranks, but a flag by itself runs on one",
                                              ranks::count()));
    the_case.dns.is_given = true;
  };
  const auto work = [&](const Case& the_case, const OutputFolder& folder,
                        Record& record) -> Answer {
    if (the_case.dns.convergence.is_given)
      return run_convergence(the_case, folder, record, options);
    std::optional<std::filesystem::path> checkpoint;
    if (!restart.empty()) checkpoint = restart;
    if (the_case.has_flow) return run_fluid(the_case, checkpoint, folder, record, options);
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
