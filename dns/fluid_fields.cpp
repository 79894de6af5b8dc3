#include "dns/fluid_fields.hpp"

#include "common/hdf5.hpp"
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
  const auto planes = static_cast<hsize_t>(extent.planes),
             n_rho = static_cast<hsize_t>(extent.n_rho),
             n_theta = static_cast<hsize_t>(extent.n_theta);
  const bool has_span = fluid.span().has_span();
  hdf5::Writer file(path);
  file.attributes({{"kind", "fluid_fields"},
                   {"t", state.t},
                   {"Re", fluid.parameters().Re},
                   {"U", fluid.parameters().U},
                   {"span", has_span ? fluid.span().length() : 0.0}});
  // Corners: planes stand at the middle of their cells along x.
  const hsize_t corner_planes = has_span ? planes + 1 : 1;
  const std::size_t corners = static_cast<std::size_t>((n_rho + 1) * (n_theta + 1));
  std::vector<double> x, y(corner_planes * corners), z(corner_planes * corners);
  for (hsize_t m = 0; m < corner_planes; ++m) {
    corners_of(fluid.grid(), static_cast<int>(m % planes), state.grid[0], y.data() + m * corners,
               z.data() + m * corners);
    x.insert(x.end(), corners,
             has_span ? fluid.span().length() * static_cast<double>(m) / static_cast<double>(planes)
                      : 0.0);
  }
  const hdf5::Shape corner_shape = {corner_planes, n_rho + 1, n_theta + 1};
  file.write("/x", corner_shape, x, {{"meaning", "corners of the grid, in L"}});
  file.write("/y", corner_shape, y, {{"meaning", "corners of the grid, in L"}});
  file.write("/z", corner_shape, z, {{"meaning", "corners of the grid, in L"}});
  const hdf5::Shape shape = {planes, n_rho, n_theta};
  const auto write = [&](const char* name, const Field<double>& f, const char* meaning) {
    if (!f.empty()) file.write(name, shape, cells_of(f), {{"meaning", meaning}});
  };
  write("/v", state.u[0], "velocity along y, in V");
  write("/w", state.u[1], "velocity along z, in V");
  if (state.u.size() > 2) write("/u", state.u[2], "velocity along x, in V");
  write("/p", state.p, "pressure, in rho_f V^2");
  const Vorticity omega = vorticity(fluid, state);
  write("/omega_x", omega.x, "vorticity along x, in V/L");
  write("/omega_y", omega.y, "vorticity along y, in V/L");
  write("/omega_z", omega.z, "vorticity along z, in V/L");
  write("/omega_s", omega.in_plane, "size of (omega_y, omega_z), in V/L");
  file.finish();
}

std::uintmax_t size_of_fields(const Fluid& fluid) {
  constexpr std::uintmax_t most_fields = 11;
  return most_fields * sizeof(double) * fluid.extent().cells();
}

}  // namespace pennon::dns
