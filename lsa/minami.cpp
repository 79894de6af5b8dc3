#include "lsa/minami.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "common/errors.hpp"
#include "lsa/plate_pressure.hpp"

namespace pennon::lsa {
namespace {

constexpr double tolerance = 1e-11;
constexpr std::size_t intervals = 4000;

// The integral over [a, b] by GSL's doubly adaptive rule; `absolute` is what counts as zero.
double integrate(const std::function<double(double)>& f, double a, double b, double absolute) {
  gsl_set_error_handler_off();
  const std::unique_ptr<gsl_integration_cquad_workspace, void (*)(gsl_integration_cquad_workspace*)>
      workspace(gsl_integration_cquad_workspace_alloc(intervals),
                gsl_integration_cquad_workspace_free);
  gsl_function function;
  function.function = [](double t, void* p) {
    return (*static_cast<const std::function<double(double)>*>(p))(t);
  };
  function.params = const_cast<std::function<double(double)>*>(&f);
  double value = 0;
  double error = 0;
  std::size_t evaluations = 0;
  const int status = gsl_integration_cquad(&function, a, b, absolute, tolerance, workspace.get(),
                                           &value, &error, &evaluations);
  if (status != GSL_SUCCESS || !std::isfinite(value))
    throw SolverError(fmt::format("the added mass (B 4): {} after {} evaluations, error {:.2e}",
                                  gsl_strerror(status), evaluations, error));
  return value;
}

std::function<double(double)> shape(MinamiMode mode, double k_y) {
  switch (mode) {
    case MinamiMode::plunge:
      return [](double) { return 1.0; };
    case MinamiMode::pitch:
      return [](double y) { return y; };
    case MinamiMode::sine:
      return [k_y](double y) { return std::sin(k_y * y); };
    case MinamiMode::hanging_chain:
      break;
  }
  return [alpha = gsl_sf_bessel_zero_J0(1)](double y) {
    return gsl_sf_bessel_J0(alpha * std::sqrt(1 - y));
  };
}

// Enough sines for the shape and for the edge layers, whose width in theta is about k_x^-1/2.
int sines_for(double k_x, double k_y) {
  return 64 + static_cast<int>(k_y) + static_cast<int>(8 * std::sqrt(std::abs(k_x)));
}

// int Y p dy / int Y^2 dy, with y = (1 + cos theta)/2.
double plate_added_mass(const std::function<double(double)>& Y, double k_x, double k_y) {
  const Eigen::VectorXd f = PlatePressure(k_x, sines_for(k_x, k_y)).opposing(Y);
  const auto pressure = [&f](double theta) {
    double sum = 0;
    for (Eigen::Index n = f.size(); n > 0; --n)
      sum += f[n - 1] * std::sin(static_cast<double>(n) * theta);
    return sum;
  };
  const auto over_chord = [&](auto&& integrand) {
    return integrate(
        [&](double theta) {
          return integrand(theta, Y((1 + std::cos(theta)) / 2)) * std::sin(theta) / 2;
        },
        0, std::numbers::pi, 0);
  };
  const double work =
      over_chord([&](double theta, double Y_here) { return Y_here * pressure(theta); });
  const double inertia = over_chord([](double, double Y_here) { return Y_here * Y_here; });
  return work / inertia;
}

}  // namespace

double minami(const MinamiSettings& settings, double k_x, double k_y) {
  if (settings.pressure == MinamiPressure::sheet) return 2 / std::sqrt(k_x * k_x + k_y * k_y);
  if (!(k_y <= PlatePressure::largest_wavenumber))
    throw SolverError(fmt::format(
        "the added mass minami with the pressure of a plate is computed for k_y up to {}, not {}; "
        "take the added mass lamb",
        PlatePressure::largest_wavenumber, k_y));
  return plate_added_mass(shape(settings.mode, k_y), k_x, k_y);
}

double minami(const FieldOnFlag& h_t, const FieldOnFlag& h_tt, const FieldOnFlag& pressure_jump,
              double S) {
  const auto over_flag = [S](const FieldOnFlag& field, double absolute) {
    return integrate(
        [&](double x) { return integrate([&](double y) { return field(x, y); }, 0, 1, absolute); },
        0, S, absolute);
  };
  // The sizes of the integrands, to tell a vanishing integral from a small one.
  const auto magnitude = [&](const FieldOnFlag& a, const FieldOnFlag& b) {
    return over_flag([&](double x, double y) { return std::abs(a(x, y) * b(x, y)); }, 1e-6);
  };
  const double scale = magnitude(h_tt, h_t);
  const double inertia =
      over_flag([&](double x, double y) { return h_tt(x, y) * h_t(x, y); }, tolerance * scale);
  if (!(std::abs(inertia) > 1e3 * tolerance * scale))
    throw SolverError(
        "the added mass (B 4) is 0/0: over this span, chord and time the flag does no work on its "
        "own inertia; take another phase of the motion");
  const double force_scale = magnitude(pressure_jump, h_t);
  const double work = over_flag([&](double x, double y) { return h_t(x, y) * pressure_jump(x, y); },
                                tolerance * force_scale);
  return -work / inertia;
}

}  // namespace pennon::lsa
