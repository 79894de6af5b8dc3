#include "dns/run/fluid_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/hdf5.hpp"
#include "common/parallel/ranks.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "dns/run/flow_body.hpp"
#include "dns/run/fluid_fields.hpp"
#include "dns/run/schedule.hpp"

namespace pennon::dns {
namespace {

namespace fs = std::filesystem;

// Steps change no faster, so that backward differences stay stable.
constexpr double most_growth = 1.2, most_shrinkage = 0.6;

// A displaced flag in a stream started at once is at its fastest at first.
constexpr double share_of_first_step = 0.05;

constexpr double slack = 1e-9;  // of a step, for times that are multiples of it but for rounding

Span span_of(const Settings& settings, const FlagParameters& flag) {
  return flag.gamma ? Span(static_cast<int>(settings.n_x), *flag.gamma) : Span(1, 1.0);
}

std::unique_ptr<FlowBody> body_of(Fluid& fluid, const Settings& settings,
                                  const FlagParameters& flag,
                                  const std::optional<ShapeFunction>& shape) {
  if (!settings.motion.is_given) return coupled_body(fluid, settings, flag, shape);
  return prescribed_body(fluid, prescribed_motion(settings.motion, fluid.grid(), fluid.span(),
                                                  shape.value_or(ShapeFunction())));
}

class FluidRun {
 public:
  FluidRun(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
           const std::optional<ShapeFunction>& shape, const OutputFolder& folder)
      : settings_(settings),
        folder_(folder),
        fluid_(fluid_of(settings, flag, flow)),
        body_(body_of(fluid_, settings, flag, shape)) {
    result_.cells =
        static_cast<std::int64_t>(fluid_.extent().cells_of_plane()) * fluid_.span().planes();
    if (settings.output.field_interval > 0)
      folder.require_space(
          size_of_fields(fluid_) *
              static_cast<std::uintmax_t>(1 + settings.t_end / settings.output.field_interval),
          "the fields of the whole run");
  }

  FluidRunResult advance(const std::optional<fs::path>& restart, bool shows_progress) {
    if (restart) {
      read_checkpoint(*restart);
    } else {
      const bool is_smooth = settings_.motion.is_given || !settings_.initial.global_modes.empty();
      dt_ = settings_.fluid.first_dt.value_or((is_smooth ? 1 : share_of_first_step) * settings_.dt);
      body_->start(dt_);
      if (settings_.output.field_interval > 0) keep_fields();
      if (settings_.output.shape_interval > 0) body_->add_shape(history_);
    }
    constexpr std::int64_t ticks = 1'000'000;
    const auto ticks_at = [&](double t) {
      return static_cast<std::int64_t>(ticks * t / settings_.t_end);
    };
    Progress progress("direct simulation", ticks, shows_progress);
    progress.begin_at(ticks_at(state().t));
    while (state().t < settings_.t_end - slack * dt_) {
      if (ranks::any(is_interrupted())) {
        write_checkpoint();
        write_results();
        throw Interrupted("interrupted; go on with --restart " + checkpoint_.string());
      }
      advance_by(step_toward(settings_.t_end));
      progress.advance_to(ticks_at(state().t), [this] { return words_of_step(); });
    }
    write_checkpoint();
    write_results();
    result_.status = "done";
    result_.t_end = state().t;
    if (!history_.rows.empty()) result_.last = history_.rows.back();
    result_.checkpoint = checkpoint_.string();
    if (!history_.flag.empty()) result_.last_of_flag = history_.flag.back();
    result_.is_coupled = !settings_.motion.is_given;
    if (result_.steps > 0) {
      const auto steps = static_cast<double>(result_.steps);
      result_.passes_mean = static_cast<double>(passes_) / steps;
      result_.pressure_iterations_mean = static_cast<double>(pressure_iterations_) / steps;
    }
    return result_;
  }

 private:
  // The last steps share what is left, so that none of them is much shorter than the one before:
  // the pressure answers a sudden change of the step.
  double step_toward(double target) const {
    constexpr double steps_that_share = 50;
    const double left = target - state().t, count = std::ceil(left / dt_ - slack);
    const double share = left / std::max(count, 1.0);
    return count > steps_that_share || std::abs(share - dt_) < slack * dt_ ? dt_ : share;
  }

  void advance_by(double dt) {
    const double before = state().t;
    const StopWatch watch;
    CoupledStepSummary& summary = last_step_;
    try {
      summary = body_->advance(dt);
    } catch (const SolverError& fault) {
      if (!history_.rows.empty()) write_results();
      throw SolverError(fmt::format("{}; {}", fault.what(),
                                    checkpoint_.empty()
                                        ? "no checkpoint was written before"
                                        : "the last checkpoint is " + checkpoint_.string()));
    }
    result_.step_seconds += watch.seconds();
    ++result_.steps;
    ++step_;
    passes_ += summary.passes;
    result_.passes_max = std::max(result_.passes_max, summary.passes);
    pressure_iterations_ += summary.fluid.pressure_iterations;
    result_.pressure_iterations_max =
        std::max(result_.pressure_iterations_max, summary.fluid.pressure_iterations);
    result_.least_area = std::min(result_.least_area, summary.fluid.least_area);
    result_.largest_wall_area =
        std::max(result_.largest_wall_area, summary.fluid.largest_wall_area);
    choose_step(dt, summary.fluid.CFL);
    const OutputSettings& output = settings_.output;
    if (output.history_interval == 0 || passes_multiple(output.history_interval, before, state().t))
      keep_row(summary);
    if (passes_multiple(output.shape_interval, before, state().t)) body_->add_shape(history_);
    if (passes_multiple(output.field_interval, before, state().t)) keep_fields();
    if (passes_multiple(output.checkpoint_interval, before, state().t)) write_checkpoint();
  }

  // The next step, from the one taken and its Courant number.
  void choose_step(double taken, double CFL) {
    double most = settings_.dt;
    if (settings_.fluid.cfl && CFL > 0)
      most = std::min(most, taken * std::max(*settings_.fluid.cfl / CFL, most_shrinkage));
    dt_ = std::min(most, most_growth * std::max(taken, dt_));
  }

  std::string words_of_step() const {
    std::string words =
        fmt::format("step {} at t = {:.4g}, CFL {:.2f}, {} pressure iterations", step_, state().t,
                    last_step_.fluid.CFL, last_step_.fluid.pressure_iterations);
    if (last_step_.passes > 0) words += fmt::format(", {} coupling passes", last_step_.passes);
    return words;
  }

  FluidState& state() { return body_->fluid(); }
  const FluidState& state() const { return body_->fluid(); }

  void keep_row(const CoupledStepSummary& summary) {
    add_row(fluid_, state(), summary.fluid, settings_.probes, history_);
    body_->complete_row(summary, history_);
  }

  void write_results() const { write_history(history_, fluid_.span(), settings_, folder_.path()); }

  void keep_fields() {
    const auto name = [](std::size_t k) { return fmt::format("fields_{:05}.h5", k); };
    write_fields(fluid_, state(), folder_ / name(field_times_.size()));
    field_times_.push_back(state().t);
    if (!ranks::is_leading()) return;
    std::vector<xdmf::Grid> series;
    for (std::size_t k = 0; k < field_times_.size(); ++k)
      series.push_back(described_fields(fluid_, field_times_[k], name(k)));
    xdmf::write(folder_ / "fields.xdmf", "fluid", series);
  }

  void write_checkpoint() {
    checkpoint_ = folder_ / "checkpoint.h5";
    body_->forget();
    std::optional<hdf5::Writer> file;  // of the leading rank
    if (ranks::is_leading()) {
      file.emplace(checkpoint_);
      file->attributes({{"kind", "fluid_checkpoint"},
                        {"t", state().t},
                        {"previous_dt", state().previous_dt},
                        {"dt", dt_},
                        {"step", step_}});
      if (!field_times_.empty()) file->write("/field_times", {field_times_.size()}, field_times_);
    }
    const Extent& extent = fluid_.extent();
    const auto planes = static_cast<hsize_t>(fluid_.span().planes());
    for_each_field([&](const std::string& name, const Field<double>& f, int rows) {
      std::vector<double> values;
      for (int plane = 0; plane < extent.planes; ++plane)
        for (int j = 0; j < rows; ++j)
          values.insert(values.end(), f.row(plane, j), f.row(plane, j) + extent.n_theta);
      values = ranks::gather(values);
      if (file)
        file->write(name,
                    {planes, static_cast<hsize_t>(rows), static_cast<hsize_t>(extent.n_theta)},
                    values);
    });
    const std::vector<double> is_inflow =
        ranks::gather(std::vector<double>(state().is_inflow.begin(), state().is_inflow.end()));
    if (!file) return;
    file->write("/is_inflow", {is_inflow.size()}, is_inflow);
    body_->write(*file);
    if (!history_.rows.empty())
      write_history(history_, fluid_.span().planes(), settings_.probes.y.size(), *file);
    write_shapes(history_.shapes, *file);
    file->finish();
  }

  // All fields of the state, with the rows that they have.
  template <class Function>
  void for_each_field(const Function& function) {
    const int cells = fluid_.extent().n_rho, corners = cells + 1;
    for (std::size_t c = 0; c < state().u.size(); ++c) {
      function(fmt::format("/u_{}", c), state().u[c], cells);
      function(fmt::format("/u_last_{}", c), state().u_last[c], cells);
      function(fmt::format("/u_change_{}", c), state().u_change[c], cells);
    }
    function("/p", state().p, cells);
    function("/p_last", state().p_last, cells);
    for (std::size_t k = 0; k < 2; ++k) {
      function(fmt::format("/grid_{}_y", k), state().grid[k].y, corners);
      function(fmt::format("/grid_{}_z", k), state().grid[k].z, corners);
    }
  }

  void read_checkpoint(const fs::path& path) {
    const hdf5::Reader file(path);
    if (file.text("/", "kind") != "fluid_checkpoint")
      throw InputError(path.string(), "is not a checkpoint of the fluid");
    const Extent& extent = fluid_.extent();
    state().u.assign(static_cast<std::size_t>(fluid_.components()), Field<double>(extent));
    state().u_last = state().u_change = state().u;
    state().p = state().p_last = Field<double>(extent);
    state().grid.assign(3, Displacement<double>(extent));
    const auto read = [&](const std::string& name, Field<double>& f, int rows) {
      const hdf5::Array array = file.read(name);
      const hdf5::Shape expected = {static_cast<hsize_t>(fluid_.span().planes()),
                                    static_cast<hsize_t>(rows),
                                    static_cast<hsize_t>(extent.n_theta)};
      if (array.shape != expected)
        throw InputError(path.string(),
                         fmt::format("holds another grid than the case's {} x {} x {} cells; "
                                     "restart with the case that wrote it",
                                     fluid_.span().planes(), extent.n_rho, extent.n_theta));
      const double* value =
          array.values.data() +
          static_cast<std::ptrdiff_t>(fluid_.span().first_plane()) * rows * extent.n_theta;
      for (int plane = 0; plane < extent.planes; ++plane) {
        for (int j = 0; j < rows; ++j, value += extent.n_theta)
          std::copy_n(value, extent.n_theta, f.row(plane, j));
        f.wrap_theta(plane, 0, rows);
      }
    };
    for_each_field(read);
    const std::vector<double> is_inflow = file.read("/is_inflow").values;
    const std::ptrdiff_t first = fluid_.span().first_plane() * std::ptrdiff_t(extent.n_theta);
    for (std::ptrdiff_t k = 0; k < extent.planes * std::ptrdiff_t(extent.n_theta); ++k)
      state().is_inflow.push_back(is_inflow[static_cast<std::size_t>(first + k)] != 0);
    state().t = file.number("/", "t", 0);
    state().previous_dt = file.number("/", "previous_dt", 0);
    dt_ = file.number("/", "dt", settings_.dt);
    step_ = static_cast<std::int64_t>(file.number("/", "step", 0));
    if (file.contains("/field_times")) field_times_ = file.read("/field_times").values;
    body_->read(file);
    if (file.contains("/history")) history_ = read_fluid_history(file);
    checkpoint_ = path;
  }

  const Settings& settings_;
  const OutputFolder& folder_;
  Fluid fluid_;
  std::unique_ptr<FlowBody> body_;
  double dt_ = 0;
  std::int64_t step_ = 0, pressure_iterations_ = 0, passes_ = 0;
  std::vector<double> field_times_;
  CoupledStepSummary last_step_;
  FluidHistory history_;
  fs::path checkpoint_;
  FluidRunResult result_;
};

}  // namespace

Fluid fluid_of(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow) {
  const FluidSettings& fluid = settings.fluid;
  const OGridSettings grid{static_cast<int>(fluid.n_rho), static_cast<int>(fluid.n_theta), fluid.R,
                           fluid.wall_spacing, fluid.wake_clustering};
  return {OGrid(grid),
          span_of(settings, flag),
          {flow.Re, flow.U, settings.initial.ramp},
          fluid.tolerances,
          upwinding_of(fluid.convection)};
}

FluidRunResult run_fluid(const Settings& settings, const FlagParameters& flag,
                         const FlowParameters& flow, const std::optional<ShapeFunction>& shape,
                         const std::optional<fs::path>& restart, const OutputFolder& folder,
                         bool shows_progress) {
  const StopWatch watch;
  FluidRun fluid_run(settings, flag, flow, shape, folder);
  FluidRunResult result = fluid_run.advance(restart, shows_progress);
  result.wall_seconds = watch.seconds();
  return result;
}

nlohmann::ordered_json to_json(const FluidRunResult& result) {
  constexpr double nanoseconds = 1e9;
  nlohmann::ordered_json json = {
      {"status", result.status},
      {"t_end", result.t_end},
      {"steps", result.steps},
      {"wall_s", result.wall_seconds},
      {"cells", result.cells},
      {"ns_per_cell_step", nanoseconds * result.step_seconds /
                               static_cast<double>(std::max<std::int64_t>(result.steps, 1)) /
                               static_cast<double>(result.cells)},
      {"coupling_iterations", nullptr},
      {"checkpoint", result.checkpoint},
      {"pressure_iterations",
       {{"mean", result.pressure_iterations_mean}, {"max", result.pressure_iterations_max}}},
      {"least_area", result.least_area},
      {"largest_wall_area", result.largest_wall_area}};
  if (result.is_coupled)
    json["coupling_iterations"] = {{"mean", result.passes_mean}, {"max", result.passes_max}};
  for (std::size_t c = 0; c < coupled_columns && result.last_of_flag; ++c)
    json["last"][columns_of_coupled_flag()[c].name] = (*result.last_of_flag)[c];
  for (std::size_t c = 0; c < fluid_columns; ++c)
    json["last"][columns_of_fluid_history()[c].name] = result.last[c];
  return json;
}

}  // namespace pennon::dns
