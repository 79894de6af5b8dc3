/// The growth of a simulation that starts as a small global mode.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "dns/coupling/mode_start.hpp"
#include "tests/support/global_mode.hpp"

namespace pennon::test {

/// lambda of z = Re(a exp(lambda t)), from z every h: Prony's recursion z_{n+1} = 2 r cos z_n - r^2
/// z_{n-1}, in least squares.
inline std::complex<double> exponent_of(const std::vector<double>& z, double h, std::size_t apart) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (std::size_t n = apart; n + apart < z.size(); ++n) {
    const double a = z[n], b = z[n - apart], c = z[n + apart];
    aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
  }
  const double determinant = aa * bb - ab * ab;
  const double p = (ac * bb - bc * ab) / determinant, q = (bc * aa - ac * ab) / determinant;
  const std::complex<double> root = p / 2 + std::sqrt(std::complex<double>(p * p / 4 + q));
  return std::log(root) / (h * static_cast<double>(apart));
}

/// lambda of the simulation with steps of dt over a time, from an amplitude of 1e-6 L.
template <int dim>
std::complex<double> simulated(const CoupledCase& settings, const dns::FlowMode& mode, double dt,
                               double duration) {
  constexpr double amplitude = 1e-6;
  dns::Fluid fluid(dns::OGrid(settings.grid), dns::Span(settings.planes, settings.span),
                   settings.fluid, settings.tolerances);
  const dns::Flag<dim> flag(coupled_mesh(settings, fluid.grid()), settings.flag);
  dns::Coupling<dim> coupling(fluid, flag, Eigen::Matrix<double, dim, 1>::Zero(),
                              settings.coupling);
  dns::CoupledState<dim> state = start_in_mode(coupling, fluid, flag, mode, amplitude, dt);
  std::vector<double> z;
  const auto steps = std::lround(duration / dt);
  for (long n = 0; n < steps; ++n) {
    coupling.advance(state, dt);
    z.push_back(state.flag.x(dim - 1, flag.mesh().chord_nodes() - 1));
  }
  const double eighth = std::numbers::pi / (4 * std::abs(mode.lambda.imag()));
  return exponent_of(z, dt, static_cast<std::size_t>(std::lround(eighth / dt)));
}

}  // namespace pennon::test
