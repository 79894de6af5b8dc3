/// A window of a plane x = const, from values at the cells of the curvilinear grid around the flag,
/// on a rectangular grid that a figure can draw.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// The part of the plane that is shown, in L.
struct PlaneWindow {
  double y_low, y_high, z_low, z_high;
};

/// The values at the window's nodes, linear between the corners of the cells, where they are the
/// mean of the cells about them; NaN outside the grid. `points`: (y, z) of the corners, or (x, y,
/// z), in the first plane of ... [n_rho + 1][n_theta + 1]; `values`: at the cells of the first
/// plane of ... [n_rho][n_theta], around the whole flag.
FigureField plane_section(const hdf5::Array& points, const hdf5::Array& values, const PlaneWindow&);

/// Clips the values to the size that this share of them does not exceed. Without it the colours
/// would show nothing but the wall, where values are far larger than in the wake.
void clip_to_most(FigureField&, double share = 0.98);

/// The figure of a field: its window, and the flag as a line along the wall's upper side.
Figure figure_of_section(FigureField field, const hdf5::Array& points, std::size_t n_theta,
                         const PlaneWindow&);

}  // namespace pennon::analysis
