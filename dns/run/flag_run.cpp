#include "dns/run/flag_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dns/flag/of_case.hpp"
#include "dns/flag/statics.hpp"
#include "dns/flag/stepper.hpp"
#include "dns/run/initial_shape.hpp"
#include "dns/run/state_file.hpp"
#include "dns/run/step_control.hpp"

namespace pennon::dns {
namespace {

template <int dim>
class FlagBody {
 public:
  FlagBody(const Settings& settings, const FlagParameters& parameters,
           const std::optional<ShapeFunction>& zeta, const OutputFolder& folder)
      : settings_(settings),
        folder_(folder),
        flag_(mesh_of(settings.flag, settings.n_x, parameters), material_of(parameters)),
        loads_(loads_of(settings.loads, parameters, flag_)),
        probe_(nearest_node(flag_.mesh(), settings.output.probe_x, settings.output.probe_y)),
        stepper_(flag_, settings.flag.scheme,
                 {.tolerance = settings.flag.tolerance, .contraction = usual_contraction<dim>}),
        state_(stepper_.start(initial_shape<dim>(settings.initial, zeta, flag_.mesh()))),
        steps_(settings.dt, settings.t_end) {}

  const char* name() const { return "flag"; }
  double time() const { return state_.t; }
  bool is_at_end() const { return steps_.are_done(); }
  void start() {
    keep_row();
    if (settings_.output.shape_interval > 0) keep_shape();
  }
  void step() {
    const double end = steps_.next_time();
    last_step_ = stepper_.advance(
        state_, [this](double) { return loads_; }, end - state_.t);
    state_.t = end;
    steps_.take();
    halved_steps_ += last_step_.parts > 1 ? 1 : 0;
    iterations_ += last_step_.iterations;
    most_iterations_ = std::max(most_iterations_, last_step_.iterations);
  }
  void keep_state() {
    kept_ = state_;
    kept_tangent_ = stepper_.kept_tangent();
  }
  void restore_state() {
    state_ = kept_;
    is_restored_ = true;
  }
  std::string words_of_step() const {
    return fmt::format("step {} at t = {:.4g}, {} Newton iterations", steps_.taken(), state_.t,
                       last_step_.iterations);
  }

  void keep_row() {
    history_.rows.push_back(history_row(flag_, loads_, state_.t, state_.x, state_.v,
                                        state_.dissipated, state_.work, probe_,
                                        last_step_.iterations));
  }
  void keep_shape() { add_shape(flag_, state_.t, state_.x, state_.v, history_.shapes); }
  void keep_fields() {}
  bool has_rows() const { return !history_.rows.empty(); }
  void write_results() const {
    write_history(history_, settings_.output.contour_times, folder_.path());
  }

  const char* checkpoint_kind() const { return "flag_checkpoint"; }
  const char* words_of_checkpoint() const { return "a checkpoint of a flag"; }
  void write(hdf5::Writer* file) const {
    file->attributes(
        {{"step", steps_.taken()}, {"step_origin", steps_.origin()}, {"dt", steps_.dt()}});
    write_state(state_, *file);
    write_tangent(is_restored_ ? kept_tangent_ : stepper_.kept_tangent(), *file);
  }
  HistoryCount history_count() const {
    return {history_.rows.size(), history_.shapes.times.size(), 0};
  }
  void add_records(const HistoryCount& first, RecordFile& file) const {
    add_rows(history_, first.rows, file);
    add_shapes(history_.shapes, first.shapes, file);
  }
  void read(const hdf5::Reader& file) {
    state_ = read_flag_state<dim>(file, flag_.mesh().nodes());
    keep_tangent_of(file, stepper_);
    if (file.number("/", "dt") == steps_.dt())
      steps_.go_on(file.number("/", "step_origin"), file.counted("/", "step"));
    else
      steps_.go_on(state_.t, 0);
    const auto take = [&](const auto& path, HistoryRecord kind, std::span<const double> record) {
      if (kind == row_record) take_row(path, record, state_.t, history_);
      if (kind == shape_record) take_shape(path, record, history_.shapes);
    };
    if (!read_history_records(file, take)) history_ = read_history(file, state_.t);
  }

  /// The shape at rest under the loads, as the history's only row.
  void find_rest() {
    iterations_ = most_iterations_ = find_equilibrium(flag_, loads_, state_.x).iterations;
    keep_row();
    keep_shape();
    write_results();
  }

  /// At the end, once.
  FlagRunResult result(const std::string& status, const LoopSummary& loop) {
    const auto solutions = static_cast<double>(std::max<std::int64_t>(loop.steps, 1));
    return {.status = status,
            .loop = loop,
            .halved_steps = halved_steps_,
            .nodes = flag_.mesh().nodes(),
            .iterations_mean = static_cast<double>(iterations_) / solutions,
            .iterations_max = most_iterations_,
            .rows = std::move(history_.rows)};
  }

 private:
  const Settings& settings_;
  const OutputFolder& folder_;
  Flag<dim> flag_;
  FlagLoads<dim> loads_;
  int probe_;
  FlagStepper<dim> stepper_;
  FlagState<dim> state_, kept_;
  std::optional<KeptTangent> kept_tangent_;  // with kept_
  bool is_restored_ = false;
  EqualSteps steps_;
  StepSummary last_step_;
  std::int64_t iterations_ = 0, halved_steps_ = 0;
  int most_iterations_ = 0;
  FlagHistory history_;
};

template <int dim>
FlagRunResult run_in(const Settings& settings, const FlagParameters& parameters,
                     const std::optional<ShapeFunction>& zeta, const Beginning& beginning,
                     const OutputFolder& folder, bool shows_progress) {
  const StopWatch watch;
  FlagBody<dim> body(settings, parameters, zeta, folder);
  FlagRunResult result;
  if (settings.flag.equilibrium) {
    body.find_rest();
    result = body.result("equilibrium", {});
  } else {
    TimeLoop loop(body, settings.output, settings.t_end, beginning, folder);
    result = body.result("done", loop.run(shows_progress));
  }
  result.wall_seconds = watch.seconds();
  return result;
}

}  // namespace

FlagRunResult run_flag(const Settings& settings, const FlagParameters& parameters,
                       const std::optional<ShapeFunction>& zeta, const Beginning& beginning,
                       const OutputFolder& folder, bool shows_progress) {
  if (parameters.gamma)
    return run_in<3>(settings, parameters, zeta, beginning, folder, shows_progress);
  return run_in<2>(settings, parameters, zeta, beginning, folder, shows_progress);
}

}  // namespace pennon::dns
