#include "modes/global/study/mode_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/io/hdf5.hpp"
#include "common/io/xdmf.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double amplitude = 0.1;  // of the flag, in L
constexpr double slab = 0.1;       // thickness in two dimensions, in L
constexpr std::size_t cells_of_wave = 12;

class Frames {
 public:
  Frames(const Result& result, std::size_t mode, const std::filesystem::path& folder)
      : result_(result),
        mode_(result.fields.modes[mode]),
        lambda_(result.found.modes[mode].lambda),
        folder_(folder),
        name_(fmt::format("global_mode_{}", mode + 1)),
        file_(name_ + ".h5"),
        rows_(result.base.q.p.extent().n_rho),
        columns_(result.base.q.p.extent().n_theta),
        cells_{has_wave() ? cells_of_wave : 1, static_cast<hsize_t>(rows_),
               static_cast<hsize_t>(columns_)},
        nodes_{cells_[0] + 1, cells_[1] + 1, cells_[2] + 1},
        writer_(folder / file_) {}

  void write(int frames) {
    writer_.attributes({{"kind", "global_mode_frames"},
                        {"growth", lambda_.real()},
                        {"omega", lambda_.imag()},
                        {"k_x", result_.k_x},
                        {"amplitude", amplitude}});
    std::vector<xdmf::Grid> fluid, flag;
    for (int frame = 0; frame < frames; ++frame) {
      phase_ = 2 * std::numbers::pi * frame / frames;
      group_ = fmt::format("/frame_{}", frame + 1);
      const double time = lambda_.imag() != 0 ? phase_ / std::abs(lambda_.imag()) : phase_;
      fluid.push_back({time, nodes_, points(), {velocity(), mode_velocity(), pressure(), omega()}});
      flag.push_back({time, {nodes_[0], result_.nodes.size()}, flag_nodes(), {}});
    }
    writer_.finish();
    xdmf::write(folder_ / (name_ + ".xdmf"), "fluid", fluid);
    xdmf::write(folder_ / (name_ + "_flag.xdmf"), "flag", flag);
  }

 private:
  bool has_wave() const { return result_.k_x != 0; }
  double length() const { return has_wave() ? 2 * std::numbers::pi / result_.k_x : slab; }
  double x_of_node(std::size_t plane) const {
    return length() * static_cast<double>(plane) / static_cast<double>(cells_[0]);
  }
  double x_of_cell(std::size_t plane) const {
    return length() * (static_cast<double>(plane) + 0.5) / static_cast<double>(cells_[0]);
  }
  // Re [value exp(i (k_x x + phase))].
  double at(double x, const Complex& value) const {
    return (value * std::polar(1.0, result_.k_x * x + phase_)).real();
  }

  xdmf::Source write(const std::string& name, const hdf5::Shape& shape,
                     const std::vector<double>& values, const std::string& meaning) {
    const std::string array = group_ + "/" + name;
    writer_.write(array, shape, values, {{"meaning", meaning}});
    return {file_, array, shape};
  }

  xdmf::Source points() {
    std::vector<double> values;
    const std::vector<double>& rest = result_.fields.points;
    values.reserve(nodes_[0] * rest.size() / 2 * 3);
    for (std::size_t plane = 0; plane < nodes_[0]; ++plane) {
      const double x = x_of_node(plane);
      std::size_t k = 0;
      for (int j = 0; j <= rows_; ++j)
        for (int i = 0; i <= columns_; ++i, k += 2)
          values.insert(values.end(),
                        {x, rest[k] + amplitude * at(x, mode_.displacement.y.row(0, j)[i]),
                         rest[k + 1] + amplitude * at(x, mode_.displacement.z.row(0, j)[i])});
    }
    return write("points", {nodes_[0], nodes_[1], nodes_[2], 3}, values,
                 "x, y, z of the corners, in L");
  }

  // steady + factor times the mode at each cell, plane by plane.
  template <class OfCell>
  std::vector<double> at_cells(const OfCell& of_cell) const {
    std::vector<double> values;
    for (std::size_t plane = 0; plane < cells_[0]; ++plane)
      for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) of_cell(x_of_cell(plane), j, i, values);
    return values;
  }

  xdmf::Attribute scalar(const std::string& name, const Field<double>& steady,
                         const Field<Complex>& mode, const std::string& meaning) {
    const auto of_cell = [&](double x, int j, int i, std::vector<double>& values) {
      values.push_back(steady.row(0, j)[i] + amplitude * at(x, mode.row(0, j)[i]));
    };
    return {name, xdmf::Center::cell, write(name, cells_, at_cells(of_cell), meaning)};
  }

  xdmf::Attribute vector(const std::string& name, double of_steady, double of_mode,
                         const std::string& meaning) {
    const PlaneFlow<double>& steady = result_.base.q;
    const bool has_u = steady.components() > 2;
    const auto of_cell = [&](double x, int j, int i, std::vector<double>& values) {
      const auto component = [&](int f) {
        return of_steady * steady.field(f).row(0, j)[i] +
               of_mode * at(x, mode_.moving.field(f).row(0, j)[i]);
      };
      constexpr int v = 0, w = 1, u = 2;
      values.insert(values.end(), {has_u ? component(u) : 0, component(v), component(w)});
    };
    hdf5::Shape shape = cells_;
    shape.push_back(3);
    return {name, xdmf::Center::cell, write(name, shape, at_cells(of_cell), meaning)};
  }

  xdmf::Attribute velocity() {
    return vector("velocity", 1, amplitude, "u, v, w of flow and mode, in V");
  }
  xdmf::Attribute mode_velocity() {
    return vector("mode_velocity", 0, 1, "u, v, w of the mode where the flag moves by 1, in V");
  }
  xdmf::Attribute pressure() {
    return scalar("p", result_.base.q.p, mode_.moving.p, "of flow and mode, in rho_f V^2");
  }
  xdmf::Attribute omega() {
    return scalar("omega_x", result_.fields.base_vorticity, mode_.moving_vorticity,
                  "vorticity along x of flow and mode, in V/L");
  }

  xdmf::Source flag_nodes() {
    std::vector<double> values;
    values.reserve(nodes_[0] * result_.nodes.size() * 3);
    for (std::size_t plane = 0; plane < nodes_[0]; ++plane)
      for (std::size_t node = 0; node < result_.nodes.size(); ++node) {
        const double x = x_of_node(plane);
        values.insert(values.end(), {x + result_.nodes[node][0], result_.nodes[node][1],
                                     amplitude * at(x, mode_.zeta[node])});
      }
    return write("flag", {nodes_[0], result_.nodes.size(), 3}, values,
                 "x, y, z of the flag's nodes, in L");
  }

  const Result& result_;
  const ModeFields& mode_;
  Complex lambda_;
  std::filesystem::path folder_;
  std::string name_, file_;
  int rows_, columns_;
  hdf5::Shape cells_, nodes_;
  hdf5::Writer writer_;
  double phase_ = 0;   // of the frame that is being written
  std::string group_;  // likewise
};

}  // namespace

void write_frames(const Result& result, int frames, const std::filesystem::path& folder) {
  if (frames == 0) return;
  for (std::size_t mode = 0; mode < result.found.modes.size(); ++mode)
    if (result.found.modes[mode].kind != ModeKind::box) Frames(result, mode, folder).write(frames);
}

}  // namespace pennon::modes::global
