#include "dns/fluid_fields.hpp"

#include <optional>

#include "common/hdf5.hpp"
#include "common/ranks.hpp"
#include "dns/vorticity.hpp"

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

}  // namespace

void write_fields(const Fluid& fluid, const FluidState& state, const std::filesystem::path& path) {
  const Extent& extent = fluid.extent();
  const bool has_span = fluid.span().has_span();
  const auto planes = static_cast<hsize_t>(fluid.span().planes());
  const auto n_rho = static_cast<hsize_t>(extent.n_rho);
  const auto n_theta = static_cast<hsize_t>(extent.n_theta);
  std::optional<hdf5::Writer> file;  // of the leading rank
  if (ranks::is_leading()) {
    file.emplace(path);
    file->attributes({{"kind", "fluid_fields"},
                      {"t", state.t},
                      {"Re", fluid.parameters().Re},
                      {"U", fluid.parameters().U},
                      {"span", has_span ? fluid.span().length() : 0.0}});
  }
  const auto write = [&](const char* name, const hdf5::Shape& shape,
                         const std::vector<double>& values, const char* meaning) {
    if (file) file->write(name, shape, values, {{"meaning", meaning}});
  };

  const auto local_planes = static_cast<std::size_t>(extent.planes);
  const std::size_t corners = static_cast<std::size_t>((n_rho + 1) * (n_theta + 1));
  std::vector<double> x, y(local_planes * corners), z(local_planes * corners);
  for (std::size_t m = 0; m < local_planes; ++m) {
    corners_of(fluid.grid(), static_cast<int>(m), state.grid[0], y.data() + m * corners,
               z.data() + m * corners);
    x.insert(x.end(), corners, has_span ? fluid.span().x(static_cast<int>(m)) : 0.0);
  }
  const hdf5::Shape corner_shape = {has_span ? planes + 1 : 1, n_rho + 1, n_theta + 1};
  // The first plane again at x = gamma.
  const auto closed = [&](const std::vector<double>& mine, double shift) {
    std::vector<double> all = ranks::gather(mine);
    if (has_span && ranks::is_leading())
      for (std::size_t k = 0; k < corners; ++k) all.push_back(all[k] + shift);
    return all;
  };
  write("/x", corner_shape, closed(x, fluid.span().length()), "corners of the grid, in L");
  write("/y", corner_shape, closed(y, 0), "corners of the grid, in L");
  write("/z", corner_shape, closed(z, 0), "corners of the grid, in L");

  const auto write_field = [&](const char* name, const Field<double>& f, const char* meaning) {
    if (!f.empty()) write(name, {planes, n_rho, n_theta}, ranks::gather(cells_of(f)), meaning);
  };
  write_field("/v", state.u[0], "velocity along y, in V");
  write_field("/w", state.u[1], "velocity along z, in V");
  if (state.u.size() > 2) write_field("/u", state.u[2], "velocity along x, in V");
  write_field("/p", state.p, "pressure, in rho_f V^2");
  const Vorticity omega = vorticity(fluid, state);
  write_field("/omega_x", omega.x, "vorticity along x, in V/L");
  write_field("/omega_y", omega.y, "vorticity along y, in V/L");
  write_field("/omega_z", omega.z, "vorticity along z, in V/L");
  write_field("/omega_s", omega.in_plane, "size of (omega_y, omega_z), in V/L");
  if (file) file->finish();
}

std::uintmax_t size_of_fields(const Fluid& fluid) {
  constexpr std::uintmax_t most_fields = 11;
  return most_fields * sizeof(double) * fluid.extent().cells_of_plane() *
         static_cast<std::uintmax_t>(fluid.span().planes());
}

}  // namespace pennon::dns
