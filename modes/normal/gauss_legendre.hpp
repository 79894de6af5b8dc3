/// Quadrature over panels of the chord, exact where the integrand in a panel is a polynomial in
/// sqrt(y) of degree 38: that holds for the energies of splines of degree 8 under the Blasius
/// tension, which has a square root in it.
#pragma once

#include <span>
#include <vector>

namespace pennon::modes {

struct QuadraturePoint {
  double y;
  double weight;
};

/// The points of every panel [panels[i], panels[i+1]], in order: Gauss-Legendre in sqrt(y).
/// Precondition: 0 <= panels, increasing.
std::vector<QuadraturePoint> gauss_legendre(std::span<const double> panels);

}  // namespace pennon::modes
