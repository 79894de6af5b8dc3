#include "dns/grid/grid_point.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace pennon::dns {
namespace {

using Complex = std::complex<double>;

// The index k with nodes(k) <= value < nodes(k + 1), within 0 .. n - 1.
template <class Nodes>
int interval(const Nodes& nodes, int n, double value) {
  int low = 0, high = n;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (nodes(middle) <= value ? low : high) = middle;
  }
  return low;
}

// The displacement between the corners, linear in rho and theta, and its derivatives.
struct Moved {
  Complex place, by_rho, by_theta;
};

Moved moved(const OGrid& grid, const Displacement<double>& displacement, int plane, double rho,
            double theta) {
  const int j = interval([&](int k) { return grid.rho(k); }, grid.n_rho(), rho);
  const int i = interval([&](int k) { return grid.theta(k); }, grid.n_theta(), theta);
  const double s = (rho - grid.rho(j)) / grid.rho_step(j);
  const double t = (theta - grid.theta(i)) / grid.theta_step(i);
  const auto corner = [&](int row, int column) {
    return Complex(displacement.y.row(plane, row)[column], displacement.z.row(plane, row)[column]);
  };
  const Complex d00 = corner(j, i), d01 = corner(j, i + 1), d10 = corner(j + 1, i),
                d11 = corner(j + 1, i + 1);
  const Complex slope = OGrid::slope(rho, theta);
  constexpr Complex I(0, 1);
  return {OGrid::place(rho, theta) + (1 - s) * ((1 - t) * d00 + t * d01) +
              s * ((1 - t) * d10 + t * d11),
          slope + ((1 - t) * (d10 - d00) + t * (d11 - d01)) / grid.rho_step(j),
          I * slope + ((1 - s) * (d01 - d00) + s * (d11 - d10)) / grid.theta_step(i)};
}

double wrapped(double theta) {
  constexpr double turn = 2 * std::numbers::pi;
  return theta - turn * std::floor(theta / turn);
}

}  // namespace

double GridPoint::value(const Field<double>& f, int plane) const {
  const int n_theta = f.extent().n_theta;
  const int before = (i + n_theta) % n_theta, behind = (i + 1) % n_theta;
  const double *below = f.row(plane, j), *above = f.row(plane, j + 1);
  return (1 - s) * ((1 - t) * below[before] + t * below[behind]) +
         s * ((1 - t) * above[before] + t * above[behind]);
}

std::optional<GridPoint> find_point(const OGrid& grid, const Displacement<double>& displacement,
                                    int plane, double y, double z) {
  const Complex target(y, z);
  const double rho_max = grid.rho(grid.n_rho());
  // Newton's method from the place on the grid at rest, with steps that stay on the grid.
  const Complex start = std::acosh(2.0 * target - 1.0);
  double rho = std::min(std::abs(start.real()), rho_max);
  double theta = wrapped(start.real() < 0 ? -start.imag() : start.imag());
  constexpr int most_iterations = 100;
  constexpr double tolerance = 1e-10;
  double distance = std::abs(moved(grid, displacement, plane, rho, theta).place - target);
  for (int k = 0; k < most_iterations && distance > tolerance; ++k) {
    const Moved at = moved(grid, displacement, plane, rho, theta);
    const Complex left = target - at.place;
    const double J = at.by_rho.real() * at.by_theta.imag() - at.by_rho.imag() * at.by_theta.real();
    const double d_rho = (left.real() * at.by_theta.imag() - left.imag() * at.by_theta.real()) / J;
    const double d_theta = (at.by_rho.real() * left.imag() - at.by_rho.imag() * left.real()) / J;
    bool is_nearer = false;
    for (double share = 1; share > 1e-3 && !is_nearer; share /= 2) {
      // Through the flag lies its other side: (-rho, theta) is (rho, -theta) there.
      const double through = rho + share * d_rho;
      const double next_rho = std::min(std::abs(through), rho_max);
      const double next_theta = wrapped((through < 0 ? -1 : 1) * (theta + share * d_theta));
      const double next =
          std::abs(moved(grid, displacement, plane, next_rho, next_theta).place - target);
      if (next >= distance) continue;
      rho = next_rho;
      theta = next_theta;
      distance = next;
      is_nearer = true;
    }
    if (!is_nearer) break;
  }
  constexpr double close = 1e-6;
  if (distance > close) return std::nullopt;
  GridPoint point;
  const int n_rho = grid.n_rho(), n_theta = grid.n_theta();
  point.j = interval([&](int k) { return grid.rho_centre(k); }, n_rho - 1, rho);
  point.s = std::clamp(
      (rho - grid.rho_centre(point.j)) / (grid.rho_centre(point.j + 1) - grid.rho_centre(point.j)),
      0.0, 1.0);
  const double first = grid.theta_centre(0), last = grid.theta_centre(n_theta - 1);
  if (theta < first || theta >= last) {  // about theta = 0
    point.i = n_theta - 1;
    const double step = grid.theta_face_step(0);
    point.t = theta < first ? 1 - (first - theta) / step : (theta - last) / step;
  } else {
    point.i = interval([&](int k) { return grid.theta_centre(k); }, n_theta - 1, theta);
    point.t = (theta - grid.theta_centre(point.i)) /
              (grid.theta_centre(point.i + 1) - grid.theta_centre(point.i));
  }
  return point;
}

}  // namespace pennon::dns
