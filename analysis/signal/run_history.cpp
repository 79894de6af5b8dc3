#include "analysis/signal/run_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "common/errors.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {
namespace {

constexpr std::size_t components = 3, z_component = 2;
constexpr std::size_t probe_values = 4, v_value = 0, w_value = 1;

// What the analysis reads of /history.
constexpr const char* needed[] = {
    "t",           "C_D",        "C_L",         "C_S",           "kinetic",
    "dissipation", "wall_power", "outer_power", "energy_defect", "flag_kinetic",
    "bending",     "stretch_2d", "stretch_3d",  "gravity",       "damping_dissipated",
    "fluid_work",  "flag_defect"};

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> words;
  std::istringstream stream(names);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

class HistoryFile {
 public:
  explicit HistoryFile(const std::filesystem::path& path) : path_(path.string()), file_(path) {
    const std::string kind = file_.text("/", "kind");
    if (kind != "coupled_history")
      throw InputError(
          path_,
          fmt::format("holds {}, but pennon analyze needs the coupled_history of a flag that "
                      "the flow moves: a case with [flow] and without [dns.motion]",
                      kind.empty() ? "nothing that pennon wrote" : kind));
  }

  RunHistory read() const {
    RunHistory history;
    history.span = file_.number("/", "span", 1);
    read_columns(history);
    history.t = history.column("t");
    check_times(history.t);
    read_trailing_edge(history);
    read_probes(history);
    return history;
  }

 private:
  void read_columns(RunHistory& history) const {
    const hdf5::Array rows = file_.read("/history", {hdf5::any_or_none, hdf5::any});
    const std::vector<std::string> names = split(file_.text("/history", "columns"));
    if (names.size() != rows.shape[1])
      throw InputError(path_, fmt::format("has {} columns in /history, but its attribute `columns` "
                                          "names {}",
                                          rows.shape[1], names.size()));
    for (const char* name : needed) {
      const auto found = std::ranges::find(names, name);
      if (found == names.end())
        throw InputError(path_, fmt::format("has no column {} in /history", name));
      const auto index = static_cast<std::size_t>(found - names.begin());
      std::vector<double>& values = history.columns[name];
      for (std::size_t row = 0; row < rows.shape[0]; ++row)
        values.push_back(finite(rows.values[row * names.size() + index], name, row));
    }
    if (rows.shape[0] < fewest_rows)
      throw InputError(path_, fmt::format("has {} rows, but the analysis needs {} at least: run "
                                          "longer (dns.t_end) or keep more rows "
                                          "(dns.output.history_interval)",
                                          rows.shape[0], fewest_rows));
  }

  void check_times(const std::vector<double>& t) const {
    const auto back = std::ranges::adjacent_find(t, std::ranges::greater_equal());
    if (back != t.end())
      throw InputError(
          path_, fmt::format("has t = {} in row {} of /history, not above {} before it", back[1],
                             back - t.begin() + 1, back[0]));
  }

  void read_trailing_edge(RunHistory& history) const {
    const hdf5::Array edge =
        file_.read("/trailing_edge", {history.t.size(), hdf5::any, components});
    history.z.resize(edge.shape[1]);
    for (std::size_t row = 0; row < edge.shape[0]; ++row)
      for (std::size_t m = 0; m < edge.shape[1]; ++m)
        history.z[m].push_back(
            finite(edge.values[(row * edge.shape[1] + m) * components + z_component],
                   "/trailing_edge", row));
  }

  void read_probes(RunHistory& history) const {
    if (!file_.contains("/probes")) return;
    const std::vector<double> y = file_.list("/probe_y");
    const std::size_t probes = y.size(), planes = history.planes();
    const std::vector<double> z = file_.list("/probe_z", probes);
    const hdf5::Array all = file_.read("/probes", {history.t.size(), probes, planes, probe_values});
    for (std::size_t k = 0; k < probes; ++k) {
      ProbeHistory probe{y[k], z[k], {}, {}};
      probe.v.resize(planes);
      probe.w.resize(planes);
      bool is_inside = true;
      for (std::size_t row = 0; row < history.t.size(); ++row)
        for (std::size_t m = 0; m < planes; ++m) {
          const double* values =
              all.values.data() + ((row * probes + k) * planes + m) * probe_values;
          probe.v[m].push_back(values[v_value]);
          probe.w[m].push_back(values[w_value]);
          is_inside = is_inside && std::isfinite(values[v_value] + values[w_value]);
        }
      if (is_inside) history.probes.push_back(std::move(probe));
    }
  }

  double finite(double value, const char* name, std::size_t row) const {
    if (!std::isfinite(value))
      throw InputError(path_,
                       fmt::format("has {} for {} in row {}: the run blew up", value, name, row));
    return value;
  }

  std::string path_;
  hdf5::Reader file_;
};

}  // namespace

void require_run_folder(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(),
                     "there is no such folder; pennon analyze takes the output folder of a run of "
                     "pennon dns");
  if (!std::filesystem::is_regular_file(folder / "history.h5"))
    throw InputError(folder.string(),
                     "has no history.h5; pennon analyze takes the output folder of a run of pennon "
                     "dns");
}

RunHistory read_run_history(const std::filesystem::path& folder) {
  require_run_folder(folder);
  return HistoryFile(folder / "history.h5").read();
}

}  // namespace pennon::analysis
