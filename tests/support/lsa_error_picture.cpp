/// Draws the pictures of docs/accuracy.md: the worst error of the roots of (4.6) against 50 digits,
/// over the two numbers that decide everything, R = K/(c_m kappa^2) and m = mu/c_m, for pennon's
/// formulas and for (4.7) as it stands in the paper.
///
///   lsa_error_picture FOLDER
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <random>

#include "analysis/drawing/figure.hpp"
#include "lsa/evaluate.hpp"
#include "tests/support/lsa_oracle.hpp"

namespace {

using namespace pennon;
using lsa::oracle::Real;

constexpr std::size_t cells = 120;  // along each axis
constexpr std::size_t samples_a_cell = 20;
constexpr double decades = 8;  // either way from 1
constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Roots {
  std::complex<double> plus, minus;
};

Roots pennon_roots(const lsa::Point& p, const lsa::Theory& theory) {
  const lsa::Stability s = solve(p, theory);
  return {s.omega_plus(), s.omega_minus()};
}

// (4.7) with its P, operation by operation.
Roots printed_roots(const lsa::Point& p, double c_m) {
  const double tension = 1.3 / std::sqrt(p.Re);
  const double A = p.nu_s * tension * p.k_x * p.k_x;
  const double B = tension * p.k_y * p.k_y;
  const double P =
      (-p.mu * c_m * p.k_y * p.k_y + (p.mu + c_m) * (A + B)) / std::pow(c_m * p.k_y, 2);
  const std::complex<double> root = std::sqrt(std::complex<double>(P));
  const double factor = c_m * p.k_y / (p.mu + c_m);
  return {factor * (1.0 + root), factor * (1.0 - root)};
}

// A random flag with these two numbers: k_y, nu_s and k_x at will, Re and mu from R and m.
lsa::Point point_with(double R, double m, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  lsa::Point p;
  p.k_y = std::pow(10.0, 4 * uniform(random) - 2);
  p.k_x = p.k_y * uniform(random);
  p.nu_s = 0.5 * uniform(random);
  const double slope = p.k_x / p.k_y;
  const double c_m = 2 / std::hypot(p.k_x, p.k_y);
  p.Re = std::pow(1.3 * (1 + p.nu_s * slope * slope) / (R * c_m), 2);
  p.mu = m * c_m;
  return p;
}

double error_in_ulps(const Roots& found, const lsa::oracle::Exact& e) {
  double worst = 0;
  for (const int sign : {1, -1}) {
    const std::complex<double> root = sign > 0 ? found.plus : found.minus;
    const Real re = e.omega_r(sign);
    const Real im = e.omega_i(sign);
    const Real error =
        sqrt((root.real() - re) * (root.real() - re) + (root.imag() - im) * (root.imag() - im));
    worst = std::max(worst, static_cast<double>(error / sqrt(re * re + im * im)) / epsilon);
  }
  return worst;
}

std::vector<double> axis() {
  std::vector<double> values;
  for (std::size_t i = 0; i < cells; ++i)
    values.push_back(std::pow(10.0, decades * (2.0 * static_cast<double>(i) / (cells - 1) - 1)));
  return values;
}

analysis::Figure figure(const std::string& title, std::vector<double> values) {
  analysis::Figure figure;
  figure.title = title;
  figure.x = {"{/:Italic R} = {/:Italic K}/({/:Italic c_m κ}^2)", true, {}, {}};
  figure.y = {"{/:Italic m} = {/:Italic μ}/{/:Italic c_m}", true, {}, {}};
  figure.field =
      analysis::FigureField{axis(), axis(), std::move(values),
                            "log_{10} of the worst relative error of the roots, in ulps", false};
  return figure;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: lsa_error_picture FOLDER\n");
    return 2;
  }
  std::mt19937_64 random(1);
  lsa::Theory theory;
  theory.model.added_mass = lsa::AddedMass::lamb;
  std::uniform_real_distribution<double> within(-0.5, 0.5);
  const double width = 2 * decades / (cells - 1);
  std::vector<double> ours, printed;
  for (const double m : axis())
    for (const double R : axis()) {
      double worst_ours = 0;
      double worst_printed = 0;
      for (std::size_t i = 0; i < samples_a_cell; ++i) {
        const lsa::Point p = point_with(R * std::pow(10, width * within(random)),
                                        m * std::pow(10, width * within(random)), random);
        const lsa::oracle::Exact e = lsa::oracle::solve({p, {}}, theory.model);
        const double c_m = coefficients(p, theory).c_m;
        worst_ours = std::max(worst_ours, error_in_ulps(pennon_roots(p, theory), e));
        worst_printed = std::max(worst_printed, error_in_ulps(printed_roots(p, c_m), e));
      }
      ours.push_back(std::log10(worst_ours));
      printed.push_back(std::log10(worst_printed));
    }
  fmt::print(
      "worst: pennon 10^{:.2f}, as printed 10^{:.2f} ulps; medians 10^{:.2f}, 10^{:.2f}\n",
      *std::ranges::max_element(ours), *std::ranges::max_element(printed),
      [](std::vector<double> v) {
        std::ranges::nth_element(v, v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2));
        return v[v.size() / 2];
      }(ours),
      [](std::vector<double> v) {
        std::ranges::nth_element(v, v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2));
        return v[v.size() / 2];
      }(printed));
  const std::filesystem::path folder = argv[1];
  draw(figure("Error of pennon's roots", ours), folder / "lsa-error-pennon");
  draw(figure("Error of the roots of (4.7) as printed", printed), folder / "lsa-error-printed");
  return 0;
}
