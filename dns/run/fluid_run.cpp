#include "dns/run/fluid_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dns/run/flow_body.hpp"
#include "dns/run/fluid_fields.hpp"
#include "dns/run/prescribed_motion.hpp"
#include "dns/run/state_file.hpp"
#include "dns/run/step_control.hpp"

namespace pennon::dns {
namespace {

std::unique_ptr<FlowBody> body_of(Fluid& fluid, const Settings& settings,
                                  const FlagParameters& flag,
                                  const std::optional<ShapeFunction>& shape) {
  if (!settings.motion.is_given) return coupled_body(fluid, settings, flag, shape);
  return prescribed_body(fluid, prescribed_motion(settings.motion, fluid.grid(), fluid.span(),
                                                  shape.value_or(ShapeFunction())));
}

// A displaced flag in a stream started at once is at its fastest at first.
double first_step(const Settings& settings) {
  constexpr double share = 0.05;
  const bool is_smooth = settings.motion.is_given || !settings.initial.global_modes.empty();
  return settings.fluid.first_dt.value_or((is_smooth ? 1 : share) * settings.dt);
}

// Of a run: one at its start, and at most one a step. By the Courant number steps may be shorter
// than dt, and nobody knows how many.
std::uintmax_t most_fields(const Settings& settings) {
  const double intervals = settings.t_end / settings.output.field_interval;
  const double steps = settings.fluid.cfl ? intervals : settings.t_end / settings.dt;
  return 2 + static_cast<std::uintmax_t>(std::min(intervals, steps));
}

// The fluid with what it runs about.
class Flow {
 public:
  Flow(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
       const std::optional<ShapeFunction>& shape, const OutputFolder& folder)
      : settings_(settings),
        folder_(folder),
        fluid_(fluid_of(settings.fluid, settings.n_x, flag, flow, settings.initial.ramp)),
        body_(body_of(fluid_, settings, flag, shape)),
        steps_(settings.dt, settings.fluid.cfl, settings.t_end) {
    if (settings.output.field_interval > 0)
      folder.require_space(size_of_fields(fluid_) * most_fields(settings),
                           "the fields of the whole run");
  }

  const char* name() const { return "direct simulation"; }
  double time() const { return state().t; }
  bool is_at_end() const { return steps_.are_done(time()); }
  void start() {
    steps_.go_on_with(first_step(settings_));
    body_->start(steps_.dt());
    if (settings_.output.field_interval > 0) keep_fields();
    if (settings_.output.shape_interval > 0) keep_shape();
  }
  void step() {
    const double dt = steps_.next(time());
    last_step_ = body_->advance(dt);
    ++step_;
    const FluidStepSummary& fluid = last_step_.fluid;
    steps_.take(dt, fluid.CFL);
    passes_ += last_step_.passes;
    pressure_iterations_ += fluid.pressure_iterations;
    most_.passes_max = std::max(most_.passes_max, last_step_.passes);
    most_.pressure_iterations_max =
        std::max(most_.pressure_iterations_max, fluid.pressure_iterations);
    most_.least_area = std::min(most_.least_area, fluid.least_area);
    most_.largest_wall_area = std::max(most_.largest_wall_area, fluid.largest_wall_area);
  }
  void keep_state() { body_->keep_state(); }
  void restore_state() { body_->restore_state(); }
  std::string words_of_step() const {
    std::string words =
        fmt::format("step {} at t = {:.4g}, CFL {:.2f}, {} pressure iterations", step_, time(),
                    last_step_.fluid.CFL, last_step_.fluid.pressure_iterations);
    if (last_step_.passes > 0) words += fmt::format(", {} coupling passes", last_step_.passes);
    return words;
  }

  void keep_row() {
    add_row(fluid_, state(), last_step_.fluid, settings_.probes, history_);
    body_->complete_row(last_step_, history_);
  }
  void keep_shape() { body_->add_shape(history_); }
  void keep_fields() {
    write_fields(fluid_, state(), folder_ / fields_name(field_times_.size()));
    field_times_.push_back(time());
    if (!ranks::is_leading()) return;
    std::vector<xdmf::Grid> series;
    for (std::size_t k = 0; k < field_times_.size(); ++k)
      series.push_back(described_fields(fluid_, field_times_[k], fields_name(k)));
    xdmf::write(folder_ / "fields.xdmf", "fluid", series);
  }
  bool has_rows() const { return !history_.rows.empty(); }
  void write_results() const { write_history(history_, fluid_.span(), settings_, folder_.path()); }

  const char* checkpoint_kind() const { return "fluid_checkpoint"; }
  const char* words_of_checkpoint() const { return "a checkpoint of the fluid"; }
  void write(hdf5::Writer* file) const {
    write_state(state(), fluid_, file);
    if (!file) return;
    file->attributes({{"dt", steps_.dt()}, {"step", step_}});
    body_->write(*file);
  }
  HistoryCount history_count() const {
    return {history_.rows.size(), history_.shapes.times.size(), field_times_.size()};
  }
  void add_records(const HistoryCount& first, RecordFile& file) const {
    add_rows(history_, first.rows, file);
    add_shapes(history_.shapes, first.shapes, file);
    add_fields(field_times_, first.fields, file);
  }
  void read(const hdf5::Reader& file) {
    state() = read_fluid_state(file, fluid_);
    steps_.go_on_with(positive_number(file, "dt"));
    step_ = file.counted("/", "step");
    body_->read(file);
    read_history(file);
    remove_later_fields();
  }

  FluidRunResult result(const LoopSummary& loop) const {
    FluidRunResult result = most_;
    result.loop = loop;
    result.cells =
        static_cast<std::int64_t>(fluid_.extent().cells_of_plane()) * fluid_.span().planes();
    result.is_coupled = !settings_.motion.is_given;
    if (has_rows()) result.last = history_.rows.back();
    if (!history_.flag.empty()) result.last_of_flag = history_.flag.back();
    if (loop.steps > 0) {
      const auto steps = static_cast<double>(loop.steps);
      result.passes_mean = static_cast<double>(passes_) / steps;
      result.pressure_iterations_mean = static_cast<double>(pressure_iterations_) / steps;
    }
    return result;
  }

 private:
  void read_history(const hdf5::Reader& file) {
    const HistoryInCheckpoint expected{.t = time(),
                                       .planes = fluid_.span().planes(),
                                       .probes = settings_.probes.y.size(),
                                       .is_coupled = !settings_.motion.is_given};
    const auto take = [&](const auto& path, HistoryRecord kind, std::span<const double> record) {
      if (kind == row_record) take_row(path, record, expected, history_);
      if (kind == shape_record) take_shape(path, record, history_.shapes);
      if (kind == field_record) take_field(path, record, field_times_);
    };
    if (read_history_records(file, take)) return;
    if (file.contains("/field_times")) field_times_ = file.list("/field_times");
    history_ = read_fluid_history(file, expected);
  }

  static std::string fields_name(std::size_t k) { return fmt::format("fields_{:05}.h5", k); }

  // Those that the run wrote after the checkpoint from which it goes on: they may differ from what
  // it writes now.
  void remove_later_fields() const {
    if (!ranks::is_leading()) return;
    std::error_code ignored;
    for (std::size_t k = field_times_.size();
         std::filesystem::remove(folder_ / fields_name(k), ignored); ++k) {
    }
  }

  static double positive_number(const hdf5::Reader& file, const std::string& attribute) {
    const double value = file.number("/", attribute);
    if (value <= 0) file.fail(fmt::format("has {} = {}; it must be above 0", attribute, value));
    return value;
  }

  FluidState& state() { return body_->fluid(); }
  const FluidState& state() const { return body_->fluid(); }

  const Settings& settings_;
  const OutputFolder& folder_;
  Fluid fluid_;
  std::unique_ptr<FlowBody> body_;
  CourantSteps steps_;
  std::int64_t step_ = 0, pressure_iterations_ = 0, passes_ = 0;
  std::vector<double> field_times_;
  CoupledStepSummary last_step_;
  FluidHistory history_;
  FluidRunResult most_;  // the extremes of the steps so far
};

}  // namespace

FluidRunResult run_fluid(const Settings& settings, const FlagParameters& flag,
                         const FlowParameters& flow, const std::optional<ShapeFunction>& shape,
                         const Beginning& beginning, const OutputFolder& folder,
                         bool shows_progress) {
  const StopWatch watch;
  Flow body(settings, flag, flow, shape, folder);
  TimeLoop loop(body, settings.output, settings.t_end, beginning, folder);
  FluidRunResult result = body.result(loop.run(shows_progress));
  result.wall_seconds = watch.seconds();
  return result;
}

}  // namespace pennon::dns
