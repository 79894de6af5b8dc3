#include "modes/global/study/fields_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "common/io/xdmf.hpp"
#include "common/shape_phases.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr const char* file_name = "global_modes.h5";
constexpr const char* velocity_names[] = {"v", "w", "u"};

std::string name_of_field(const PlaneFlow<Complex>& q, int f) {
  return f < q.components() ? velocity_names[f] : "p";
}

std::string group_of(std::size_t mode) {
  return fmt::format("/mode_{}", mode + 1);
}

template <class Scalar, class Part>
std::vector<double> values_of(const Field<Scalar>& f, int rows, int columns, const Part& part) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) values.push_back(part(f.row(0, j)[i]));
  return values;
}

template <class Part>
std::vector<double> parts_of(const std::vector<Complex>& numbers, const Part& part) {
  std::vector<double> values;
  values.reserve(numbers.size());
  for (const Complex& number : numbers) values.push_back(part(number));
  return values;
}

constexpr auto real_part = [](const Complex& value) { return value.real(); };
constexpr auto imaginary_part = [](const Complex& value) { return value.imag(); };

hdf5::Attributes about(const std::string& meaning) {
  return {{"meaning", meaning}};
}

class FieldsFile {
 public:
  FieldsFile(const Result& result, const std::filesystem::path& folder)
      : result_(result),
        rows_(result.base.q.p.extent().n_rho),
        columns_(result.base.q.p.extent().n_theta),
        cells_{static_cast<hsize_t>(rows_), static_cast<hsize_t>(columns_)},
        corners_{cells_[0] + 1, cells_[1] + 1},
        writer_(folder / file_name) {
    const PlaneParameters& flow = result.base.parameters;
    writer_.attributes({{"kind", "global_modes"},
                        {"mu", result.flag.mu},
                        {"K_B", result.flag.K_B},
                        {"K_S", result.flag.K_S},
                        {"nu_s", result.flag.nu_s},
                        {"Re", flow.Re},
                        {"U", flow.U},
                        {"k_x", result.k_x},
                        {"n_x", static_cast<double>(result.n_x)},
                        {"tau", flow.dt_of_pressure}});
    write_grid();
    write_spectrum();
    write_base();
    for (std::size_t mode = 0; mode < result.fields.modes.size(); ++mode) {
      grids_.push_back(
          {static_cast<double>(mode + 1), corners_, {file_name, "/points", points_}, {}});
      for (const xdmf::Attribute& attribute : of_base_)
        grids_.back().attributes.push_back(attribute);
      write_mode(group_of(mode), result.fields.modes[mode]);
    }
    writer_.finish();
    xdmf::write(folder / "global_modes.xdmf", "global modes", grids_);
  }

 private:
  void write_grid() {
    points_ = {corners_[0], corners_[1], 3};
    const std::vector<double>& y_z = result_.fields.points;
    std::vector<double> points;
    points.reserve(y_z.size() / 2 * 3);
    for (std::size_t k = 0; k < y_z.size(); k += 2)
      points.insert(points.end(), {0, y_z[k], y_z[k + 1]});
    writer_.write("/points", points_, points, about("x, y, z of the grid's corners at rest, in L"));
    writer_.write("/y", {result_.found.chord.size()}, result_.found.chord,
                  about("the flag's nodes, in L"));
    std::vector<double> nodes;
    nodes.reserve(2 * result_.nodes.size());
    for (const auto& [x, y] : result_.nodes) nodes.insert(nodes.end(), {x, y});
    writer_.write("/flag", {result_.nodes.size(), 2}, nodes,
                  about("x less that of the station and y of the flag's nodes in the steady flow"));
    writer_.write("/tension", {result_.base.tension.size()}, result_.base.tension,
                  about("of the flag in the steady flow, in rho_f V^2 L"));
  }

  void write_spectrum() {
    const auto write = [&](const char* name, const char* meaning, auto value) {
      std::vector<double> values;
      values.reserve(result_.found.modes.size());
      for (const GlobalMode& mode : result_.found.modes) values.push_back(value(mode));
      writer_.write(name, {values.size()}, values, about(meaning));
    };
    write("/growth", "growth rate, in V/L",
          [](const GlobalMode& mode) { return mode.lambda.real(); });
    write("/omega", "angular frequency, in V/L",
          [](const GlobalMode& mode) { return mode.lambda.imag(); });
    write("/is_box", "1 where the mode belongs to the box in which the flow is computed",
          [](const GlobalMode& mode) { return mode.kind == ModeKind::box ? 1.0 : 0.0; });
    write("/residual", "of the eigenpair", [](const GlobalMode& mode) { return mode.residual; });
  }

  void write_base() {
    const PlaneFlow<double>& q = result_.base.q;
    const auto write = [&](const std::string& name, const Field<double>& f,
                           const std::string& meaning) {
      const std::string array = "/base/" + name;
      writer_.write(array, cells_,
                    values_of(f, rows_, columns_, [](double value) { return value; }),
                    about(meaning));
      of_base_.push_back({"base_" + name, xdmf::Center::cell, {file_name, array, cells_}});
    };
    for (int f = 0; f < q.components(); ++f)
      write(velocity_names[f], q.field(f), "velocity of the steady flow, in V");
    write("p", q.p, "pressure of the steady flow, in rho_f V^2");
    const std::vector<double> is_inflow(result_.base.is_inflow.begin(),
                                        result_.base.is_inflow.end());
    writer_.write("/base/is_inflow", {is_inflow.size()}, is_inflow,
                  about("1 where fluid enters through a face of the outer boundary"));
    write("omega_x", result_.fields.base_vorticity, "vorticity of the steady flow along x, in V/L");
  }

  // The two parts of a field, and what the XDMF says of them.
  void write_complex(const std::string& group, const std::string& name, const Field<Complex>& f,
                     const std::string& meaning, xdmf::Center center = xdmf::Center::cell) {
    const bool is_of_cells = center == xdmf::Center::cell;
    const int rows = is_of_cells ? rows_ : rows_ + 1,
              columns = is_of_cells ? columns_ : columns_ + 1;
    const hdf5::Shape& shape = is_of_cells ? cells_ : corners_;
    const auto write = [&](const char* ending, const auto& part) {
      const std::string array = group + "/" + name + ending;
      writer_.write(array, shape, values_of(f, rows, columns, part), about(meaning));
      grids_.back().attributes.push_back({name + ending, center, {file_name, array, shape}});
    };
    write("_real", real_part);
    write("_imag", imaginary_part);
  }

  void write_flow(const std::string& group, const std::string& prefix, const PlaneFlow<Complex>& q,
                  const std::string& where) {
    for (int f = 0; f < q.fields(); ++f) {
      const std::string name = name_of_field(q, f);
      write_complex(group, prefix + name, q.field(f),
                    (f < q.components() ? "velocity" : "pressure") + where);
    }
  }

  void write_mode(const std::string& group, const ModeFields& mode) {
    const std::string moving = " of the mode, at points that move with the grid",
                      fixed = " of the mode, at fixed points";
    write_flow(group, "", mode.moving, moving);
    write_complex(group, "omega_x", mode.moving_vorticity, "vorticity along x" + moving);
    write_flow(group, "fixed_", mode.fixed, fixed);
    write_complex(group, "fixed_omega_x", mode.fixed_vorticity, "vorticity along x" + fixed);
    for (const auto& [name, d] : {std::pair("displacement_y", &mode.displacement.y),
                                  std::pair("displacement_z", &mode.displacement.z)})
      write_complex(group, name, *d, "displacement of the grid in the mode", xdmf::Center::node);
    write_shapes(group, mode.zeta);
    if (!mode.adjoint) return;
    write_flow(group, "adjoint_", mode.adjoint->p, " of the adjoint mode");
    const std::string array = group + "/wavemaker";
    writer_.write(
        array, cells_,
        values_of(mode.adjoint->wavemaker, rows_, columns_, [](double value) { return value; }),
        about("|p| |v'| of adjoint and mode, in 1/L^2"));
    grids_.back().attributes.push_back(
        {"wavemaker", xdmf::Center::cell, {file_name, array, cells_}});
    const std::vector<double>& on_flag = mode.adjoint->flag.wavemaker;
    writer_.write(group + "/flag_wavemaker", {on_flag.size()}, on_flag,
                  about("|p_f| |zeta_t| of adjoint and mode along the flag, in 1/L"));
  }

  void write_shapes(const std::string& group, const std::vector<Complex>& zeta) {
    const hsize_t nodes = zeta.size();
    const auto meaning = about("displacement of the flag, 1 where it is largest");
    writer_.write(group + "/zeta_real", {nodes}, parts_of(zeta, real_part), meaning);
    writer_.write(group + "/zeta_imag", {nodes}, parts_of(zeta, imaginary_part), meaning);
    std::vector<double> shapes;
    shapes.reserve(shape_phases.size() * nodes);
    for (const double phase : shape_phases)
      for (const Complex& value : zeta)
        shapes.push_back((value * std::polar(1.0, phase * std::numbers::pi / 180)).real());
    writer_.write(group + "/shapes", {shape_phases.size(), nodes}, shapes,
                  about(fmt::format("displacement of the flag at the phases {} degrees",
                                    fmt::join(shape_phases, ", "))));
  }

  const Result& result_;
  int rows_, columns_;
  hdf5::Shape cells_, corners_, points_;
  hdf5::Writer writer_;
  std::vector<xdmf::Attribute> of_base_;
  std::vector<xdmf::Grid> grids_;
};

// Along the chord, for each mode.
void write_flag_feedback(const Result& result, const std::filesystem::path& file) {
  CsvText table(
      "what a piece of the flag does to a mode (y in L): |p_f| |zeta_t| in 1/L; derivatives of "
      "lambda by mass (rho_f L), damping (rho_f V) and stiffness (rho_f V^2/L) added per area, for "
      "each L of chord",
      {"mode", "y", "wavemaker", "mass_real", "mass_imag", "damping_real", "damping_imag",
       "stiffness_real", "stiffness_imag"});
  for (std::size_t m = 0; m < result.fields.modes.size(); ++m) {
    const FlagFeedback& flag = result.fields.modes[m].adjoint->flag;
    for (std::size_t j = 0; j < result.found.chord.size(); ++j)
      table.row({static_cast<double>(m + 1), result.found.chord[j], flag.wavemaker[j],
                 flag.mass[j].real(), flag.mass[j].imag(), flag.damping[j].real(),
                 flag.damping[j].imag(), flag.stiffness[j].real(), flag.stiffness[j].imag()});
  }
  write_file(file, table.text());
}

}  // namespace

void write_fields(const Result& result, const std::filesystem::path& folder) {
  const FieldsFile written(result, folder);
  const std::vector<ModeFields>& modes = result.fields.modes;
  const std::filesystem::path feedback = folder / "global_flag_feedback.csv";
  if (std::ranges::all_of(modes, [](const ModeFields& mode) { return mode.adjoint.has_value(); }))
    write_flag_feedback(result, feedback);
  else
    std::filesystem::remove(feedback);  // of an earlier run
}

}  // namespace pennon::modes::global
