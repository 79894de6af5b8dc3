#include "dns/run/fluid_fields.hpp"

#include <optional>

#include "common/io/hdf5.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/fluid/vorticity.hpp"

namespace pennon::dns {
namespace {

std::vector<double> cells_of(const Field<double>& f) {
  std::vector<double> values;
  values.reserve(f.extent().cells());
  for (int plane = 0; plane < f.extent().planes; ++plane)
    for (int j = 0; j < f.extent().n_rho; ++j)
      values.insert(values.end(), f.row(plane, j), f.row(plane, j) + f.extent().n_theta);
  return values;
}

struct FieldQuantity {
  const char* name;
  const char* meaning;
  bool needs_three_components, needs_span;
  const Field<double>* (*of)(const FluidState&, const Vorticity&);  // null where there is none
};

const Field<double>* unless_empty(const Field<double>& field) {
  return field.empty() ? nullptr : &field;
}

constexpr FieldQuantity quantities[] = {
    {"v", "velocity along y, in V", false, false,
     [](const FluidState& state, const Vorticity&) { return &state.u[along_y]; }},
    {"w", "velocity along z, in V", false, false,
     [](const FluidState& state, const Vorticity&) { return &state.u[along_z]; }},
    {"u", "velocity along x, in V", true, false,
     [](const FluidState& state, const Vorticity&) {
       return state.u.size() > along_x ? &state.u[along_x] : nullptr;
     }},
    {"p", "pressure, in rho_f V^2", false, false,
     [](const FluidState& state, const Vorticity&) { return &state.p; }},
    {"omega_x", "vorticity along x, in V/L", false, false,
     [](const FluidState&, const Vorticity& omega) { return &omega.x; }},
    {"omega_y", "vorticity along y, in V/L", false, true,
     [](const FluidState&, const Vorticity& omega) { return unless_empty(omega.y); }},
    {"omega_z", "vorticity along z, in V/L", false, true,
     [](const FluidState&, const Vorticity& omega) { return unless_empty(omega.z); }},
    {"omega_s", "size of (omega_y, omega_z), in V/L", false, true,
     [](const FluidState&, const Vorticity& omega) { return unless_empty(omega.in_plane); }}};

std::string array_name(const FieldQuantity& quantity) {
  return std::string("/") + quantity.name;
}

struct Shapes {
  hdf5::Shape nodes, points, cells;

  explicit Shapes(const Fluid& fluid)
      : cells{static_cast<hsize_t>(fluid.extent().n_rho),
              static_cast<hsize_t>(fluid.extent().n_theta)} {
    const bool has_span = fluid.span().has_span();
    if (has_span) cells.insert(cells.begin(), static_cast<hsize_t>(fluid.span().planes()));
    for (const hsize_t count : cells) nodes.push_back(count + 1);
    points = nodes;
    points.push_back(3);
  }
};

// x, y and z of the corners, on the leading rank; x is 0 in two dimensions.
std::vector<double> points_of(const Fluid& fluid, const FluidState& state) {
  const bool has_span = fluid.span().has_span();
  const std::size_t corners = static_cast<std::size_t>(fluid.extent().n_rho + 1) *
                              static_cast<std::size_t>(fluid.extent().n_theta + 1);
  std::vector<double> y(corners), z(corners), points;
  for (int plane = 0; plane < fluid.extent().planes; ++plane) {
    corners_of(fluid.grid(), plane, state.grid[0], y.data(), z.data());
    for (std::size_t k = 0; k < corners; ++k) {
      const double x = has_span ? fluid.span().x(plane) : 0;
      points.insert(points.end(), {x, y[k], z[k]});
    }
  }
  points = ranks::gather(points);
  if (has_span && ranks::is_leading())  // the first plane again at x = gamma
    for (std::size_t k = 0; k < corners; ++k) {
      const double next_y = points[3 * k + 1], next_z = points[3 * k + 2];
      points.insert(points.end(), {fluid.span().length(), next_y, next_z});
    }
  return points;
}

}  // namespace

void write_fields(const Fluid& fluid, const FluidState& state, const std::filesystem::path& path) {
  std::optional<hdf5::Writer> file;  // of the leading rank
  if (ranks::is_leading()) {
    file.emplace(path);
    file->attributes({{"kind", "fluid_fields"},
                      {"t", state.t},
                      {"Re", fluid.parameters().Re},
                      {"U", fluid.parameters().U},
                      {"span", fluid.span().has_span() ? fluid.span().length() : 0.0}});
  }
  const Shapes shapes(fluid);
  const std::vector<double> points = points_of(fluid, state);
  if (file)
    file->write("/points", shapes.points, points, {{"meaning", "x, y, z of the corners, in L"}});

  const Vorticity omega = vorticity(fluid, state);
  for (const FieldQuantity& quantity : quantities) {
    const Field<double>* field = quantity.of(state, omega);
    if (!field) continue;
    const std::vector<double> values = ranks::gather(cells_of(*field));
    if (file)
      file->write(array_name(quantity), shapes.cells, values, {{"meaning", quantity.meaning}});
  }
  if (file) file->finish();
}

xdmf::Grid described_fields(const Fluid& fluid, double t, const std::string& file) {
  const Shapes shapes(fluid);
  xdmf::Grid grid{t, shapes.nodes, {file, "/points", shapes.points}, {}};
  const bool has_span = fluid.span().has_span();
  for (const FieldQuantity& quantity : quantities) {
    if (quantity.needs_span && !has_span) continue;
    if (quantity.needs_three_components && fluid.components() < 3) continue;
    grid.attributes.push_back(
        {quantity.name, xdmf::Center::cell, {file, array_name(quantity), shapes.cells}});
  }
  return grid;
}

std::uintmax_t size_of_fields(const Fluid& fluid) {
  constexpr std::uintmax_t most_fields = 11;  // three of them the corners'
  return most_fields * sizeof(double) * fluid.extent().cells_of_plane() *
         static_cast<std::uintmax_t>(fluid.span().planes());
}

}  // namespace pennon::dns
