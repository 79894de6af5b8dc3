/// Grids for tests: flags in their places, images of the grid at rest, grids refined by halves.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/o_grid.hpp"

namespace pennon::test {

using namespace pennon::dns;

inline Extent extent_of(const OGrid& grid) {
  return {1, grid.n_rho(), grid.n_theta()};
}

/// The displacement of the flag's corners.
struct Wall {
  std::vector<double> y, z;
};

/// shape(y) is where the flag's point y goes, as y + i z.
template <class Shape>
Wall wall_of(const OGrid& grid, const Shape& shape) {
  Wall wall;
  for (int i = 0; i < grid.n_theta(); ++i) {
    const double y = OGrid::place(0, grid.theta(i)).real();
    const std::complex<double> moved = shape(y);
    wall.y.push_back(moved.real() - y);
    wall.z.push_back(moved.imag());
  }
  return wall;
}

/// image(y + i z) is where each corner goes.
template <class Image>
Displacement<double> image_of(const OGrid& grid, const Image& image) {
  Displacement<double> displacement(extent_of(grid));
  for (int j = 0; j <= grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const std::complex<double> rest = OGrid::place(grid.rho(j), grid.theta(i));
      const std::complex<double> moved = image(rest) - rest;
      displacement.y.row(0, j)[i] = moved.real();
      displacement.z.row(0, j)[i] = moved.imag();
    }
  displacement.y.wrap_theta(0, 0, grid.n_rho() + 1);
  displacement.z.wrap_theta(0, 0, grid.n_rho() + 1);
  return displacement;
}

/// Twice as many cells: every second corner is one of the grid's.
inline OGrid refined(const OGrid& grid) {
  OGridSettings settings = grid.settings();
  settings.wall_spacing /= 1 + std::sqrt(grid.growth());
  settings.n_rho *= 2;
  settings.n_theta *= 2;
  return OGrid(settings);
}

}  // namespace pennon::test
