#include "dns/run/flag_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "dns/flag/statics.hpp"
#include "dns/flag/stepper.hpp"
#include "dns/run/initial_shape.hpp"
#include "dns/run/schedule.hpp"

namespace pennon::dns {
namespace {

namespace fs = std::filesystem;

template <int dim>
Eigen::Matrix<double, dim, 1> components(const std::array<double, 3>& vector) {
  return Eigen::Map<const Eigen::Vector3d>(vector.data()).template tail<dim>();
}

int nearest_node(const FlagMesh& mesh, double x, double y) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      if (const double distance = std::hypot(mesh.x(i) - x, mesh.y(j) - y); distance < least) {
        least = distance;
        best = mesh.index(i, j);
      }
  return best;
}

// Adds the forces per area of a table to the nodes nearest to its places. Throws InputError
// (file:line).
template <int dim>
void add_traction(const std::filesystem::path& file, const Flag<dim>& flag,
                  NodeVectors<dim>& forces) {
  const CsvTable table(file);
  const auto number = [&](std::size_t row, const char* column) {
    const auto value = table.number(row, table.column(column));
    if (!value) throw InputError(table.place(row), fmt::format("{} is missing", column));
    return *value;
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double x = dim == 3 ? number(row, "x") : 0.0;
    const int node = nearest_node(flag.mesh(), x, number(row, "y"));
    Eigen::Matrix<double, dim, 1> per_area;
    if constexpr (dim == 3) per_area[0] = number(row, "f_x");
    per_area[dim - 2] = number(row, "f_y");
    per_area[dim - 1] = number(row, "f_z");
    forces.col(node) += flag.mass()[node] / flag.material().mu * per_area;
  }
}

template <int dim>
FlagLoads<dim> loads_of(const Settings& settings, const FlagParameters& parameters,
                        const Flag<dim>& flag) {
  const FlagMesh& mesh = flag.mesh();
  FlagLoads<dim> loads;
  loads.gravity = components<dim>(parameters.gravity);
  if (settings.loads.pressure != 0)
    loads.pressure = Eigen::VectorXd::Constant(flag.elements(), settings.loads.pressure);
  const Eigen::Matrix<double, dim, 1> per_area = components<dim>(settings.loads.load);
  const Eigen::Matrix<double, dim, 1> per_span = components<dim>(settings.loads.edge_load);
  if (per_area.isZero(0) && per_span.isZero(0) && settings.loads.traction.empty()) return loads;
  loads.node_forces.setZero(dim, mesh.nodes());
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j) {
      loads.node_forces.col(mesh.index(i, j)) += mesh.area(i, j) * per_area;
      if (j + 1 == mesh.chord_nodes())
        loads.node_forces.col(mesh.index(i, j)) += mesh.span_share(i) * per_span;
    }
  if (!settings.loads.traction.empty())
    add_traction(settings.loads.traction, flag, loads.node_forces);
  return loads;
}

template <int dim>
class FlagRun {
 public:
  FlagRun(const Settings& settings, const FlagParameters& parameters,
          const std::optional<ShapeFunction>& zeta, const OutputFolder& folder)
      : settings_(settings),
        folder_(folder),
        flag_(mesh_of(settings, parameters), material_of(parameters)),
        loads_(loads_of(settings, parameters, flag_)),
        probe_(nearest_node(flag_.mesh(), settings.output.probe_x, settings.output.probe_y)),
        stepper_(flag_, settings.flag.scheme,
                 {.tolerance = settings.flag.tolerance, .contraction = usual_contraction<dim>}),
        state_(stepper_.start(initial_shape<dim>(settings.initial, zeta, flag_.mesh()))) {
    result_.nodes = flag_.mesh().nodes();
  }

  RunResult find_rest() {
    const EquilibriumSummary found = find_equilibrium(flag_, loads_, state_.x);
    result_.iterations_mean = result_.iterations_max = found.iterations;
    keep_row(0);
    keep_shape();
    return finish("equilibrium");
  }

  RunResult advance(const std::optional<fs::path>& restart, bool shows_progress) {
    if (restart)
      read_checkpoint(*restart);
    else {
      keep_row(0);
      keep_shape();
    }
    const auto steps = static_cast<std::int64_t>(std::ceil(settings_.t_end / settings_.dt - 1e-9));
    Progress progress("flag", steps, shows_progress);
    while (step_ < steps) {
      const double target =
          std::min(settings_.t_end, static_cast<double>(step_ + 1) * settings_.dt);
      advance_to(target);
      progress.advance_to(step_);
      if (is_due(settings_.output.checkpoint_interval, false)) write_checkpoint();
      if (is_interrupted()) {
        write_checkpoint();
        stop_if_interrupted(("go on with --restart " + checkpoint_.string()).c_str());
      }
    }
    write_checkpoint();
    return finish("done");
  }

 private:
  // Whether a multiple of the interval lies in the last step; interval 0: `always`.
  bool is_due(double interval, bool always) const {
    if (interval <= 0) return always;
    return passes_multiple(interval, static_cast<double>(step_ - 1) * settings_.dt, state_.t);
  }

  void advance_to(double target) {
    StepSummary summary;
    try {
      summary = stepper_.advance(
          state_, [this](double) { return loads_; }, target - state_.t);
    } catch (const SolverError& fault) {
      write_results();
      const std::string saved = checkpoint_.empty()
                                    ? "no checkpoint was written before"
                                    : "the last checkpoint is " + checkpoint_.string();
      throw SolverError(fmt::format("{}; {}", fault.what(), saved));
    }
    state_.t = target;
    ++step_;
    ++result_.steps;
    result_.halved_steps += summary.parts > 1 ? 1 : 0;
    iterations_ += summary.iterations;
    result_.iterations_max = std::max(result_.iterations_max, summary.iterations);
    if (is_due(settings_.output.history_interval, true)) keep_row(summary.iterations);
    if (is_due(settings_.output.shape_interval, false)) keep_shape();
  }

  void keep_row(int iterations) {
    history_.rows.push_back(history_row(flag_, loads_, state_.t, state_.x, state_.v,
                                        state_.dissipated, state_.work, probe_, iterations));
  }

  void keep_shape() {
    if (settings_.output.shape_interval <= 0 && !settings_.flag.equilibrium) return;
    add_shape(flag_, state_.t, state_.x, state_.v, history_.shapes);
  }

  void write_checkpoint() {
    checkpoint_ = folder_ / "checkpoint.h5";
    hdf5::Writer file(checkpoint_);
    file.attributes({{"kind", "flag_checkpoint"},
                     {"t", state_.t},
                     {"step", step_},
                     {"previous_dt", state_.previous_dt},
                     {"dissipated", state_.dissipated},
                     {"work", state_.work}});
    const auto write = [&](const char* name, const NodeVectors<dim>& vectors) {
      file.write(name, {static_cast<hsize_t>(vectors.cols()), dim},
                 {vectors.data(), static_cast<std::size_t>(vectors.size())});
    };
    write("/x", state_.x);
    write("/v", state_.v);
    if (state_.previous_dt > 0) {
      write("/previous_x", state_.previous_x);
      write("/previous_v", state_.previous_v);
    }
    write_history(history_, file);
    file.finish();
    stepper_.forget_tangent();  // as a restarted run does, so that both go on with the same bits
  }

  void read_checkpoint(const fs::path& path) {
    const hdf5::Reader file(path);
    if (file.text("/", "kind") != "flag_checkpoint")
      throw InputError(path.string(), "is not a checkpoint of a flag");
    const auto read = [&](const char* name) {
      const hdf5::Array array = file.read(name);
      const hdf5::Shape expected = {static_cast<hsize_t>(flag_.mesh().nodes()), dim};
      if (array.shape != expected)
        throw InputError(path.string(),
                         fmt::format("holds {} nodes in {} dimensions, the case's flag has {} "
                                     "in {}; restart with the case that wrote it",
                                     array.shape[0], array.shape[1], expected[0], dim));
      return NodeVectors<dim>(
          Eigen::Map<const NodeVectors<dim>>(array.values.data(), dim, flag_.mesh().nodes()));
    };
    state_.x = read("/x");
    state_.v = read("/v");
    state_.t = file.number("/", "t", 0);
    state_.previous_dt = file.number("/", "previous_dt", 0);
    state_.dissipated = file.number("/", "dissipated", 0);
    state_.work = file.number("/", "work", 0);
    if (state_.previous_dt > 0) {
      state_.previous_x = read("/previous_x");
      state_.previous_v = read("/previous_v");
    }
    step_ = static_cast<std::int64_t>(file.number("/", "step", 0));
    history_ = read_history(file);
    checkpoint_ = path;
  }

  void write_results() const {
    write_history(history_, settings_.output.contour_times, folder_.path());
  }

  RunResult finish(const std::string& status) {
    write_results();
    result_.status = status;
    result_.t_end = state_.t;
    result_.last = history_.rows.back();
    result_.checkpoint = checkpoint_.string();
    if (result_.steps > 0)
      result_.iterations_mean =
          static_cast<double>(iterations_) / static_cast<double>(result_.steps);
    return result_;
  }

  const Settings& settings_;
  const OutputFolder& folder_;
  Flag<dim> flag_;
  FlagLoads<dim> loads_;
  int probe_;
  FlagStepper<dim> stepper_;
  FlagState<dim> state_;
  std::int64_t step_ = 0;
  std::int64_t iterations_ = 0;
  FlagHistory history_;
  fs::path checkpoint_;
  RunResult result_;
};

template <int dim>
RunResult run_in(const Settings& settings, const FlagParameters& parameters,
                 const std::optional<ShapeFunction>& zeta, const std::optional<fs::path>& restart,
                 const OutputFolder& folder, bool shows_progress) {
  const StopWatch watch;
  FlagRun<dim> flag_run(settings, parameters, zeta, folder);
  RunResult result =
      settings.flag.equilibrium ? flag_run.find_rest() : flag_run.advance(restart, shows_progress);
  result.wall_seconds = watch.seconds();
  return result;
}

}  // namespace

RunResult run(const Settings& settings, const FlagParameters& parameters,
              const std::optional<ShapeFunction>& zeta, const std::optional<fs::path>& restart,
              const OutputFolder& folder, bool shows_progress) {
  if (parameters.gamma)
    return run_in<3>(settings, parameters, zeta, restart, folder, shows_progress);
  return run_in<2>(settings, parameters, zeta, restart, folder, shows_progress);
}

nlohmann::ordered_json to_json(const RunResult& result) {
  nlohmann::ordered_json json = {{"status", result.status},
                                 {"t_end", result.t_end},
                                 {"steps", result.steps},
                                 {"wall_s", result.wall_seconds},
                                 {"cells", 0},
                                 {"ns_per_cell_step", nullptr},
                                 {"coupling_iterations", nullptr},
                                 {"checkpoint", nullptr}};
  if (!result.checkpoint.empty()) json["checkpoint"] = result.checkpoint;
  json["nodes"] = result.nodes;
  json["newton_iterations"] = {{"mean", result.iterations_mean}, {"max", result.iterations_max}};
  json["halved_steps"] = result.halved_steps;
  for (std::size_t c = 0; c < history_columns; ++c)
    json["last"][columns_of_history()[c].name] = result.last[c];
  return json;
}

}  // namespace pennon::dns
