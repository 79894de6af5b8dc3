#include "modes/global/neutral/neutral.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/interrupt.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Index = Eigen::Index;

constexpr double neutral_to = 1e-6;  // |Im mu| over |mu|: its square is the error of mu
constexpr int most_evaluations = 12;
constexpr double longest_step = 1;       // in omega; a longer one leads to another mode
constexpr double scan_spacing = 0.1;     // in omega, of the cells that are searched for zeros
constexpr double reach = 1;              // spacings beyond a cell within which a zero is sought
constexpr double same_frequency = 1e-4;  // two modes this close, in omega and mu, are one
constexpr double same_start = 0.02;      // a start this close to a known mode leads to that mode
constexpr double nearby = 1;             // in omega; see ShapesNearby

// Mass ratio and slope of one mode at a frequency.
struct Branch {
  Complex mu, slope;
  Eigen::VectorXcd zeta, psi;
};

// (omega^2 m)^-1 (K - F), whose eigenvalues are the mass ratios.
Eigen::MatrixXcd over_inertia(const Eigen::MatrixXcd& F, const FlagOperator& flag, double omega) {
  const Eigen::VectorXcd scale = (omega * omega * flag.mass).cast<Complex>().cwiseInverse();
  return scale.asDiagonal() * (flag.stiffness - F);
}

// All the mass ratios at a frequency, with their modes.
class MassRatios {
 public:
  MassRatios(const Response& response, const FlagOperator& flag, double omega)
      : response_(response), flag_(flag), omega_(omega) {
    solver_.compute(over_inertia(response.F, flag, omega));
    vectors_.compute(solver_.eigenvectors());
  }

  Index count() const { return solver_.eigenvalues().size(); }
  Complex mu(Index k) const { return solver_.eigenvalues()[k]; }
  Index nearest(Complex to) const {
    Index k = 0;
    (solver_.eigenvalues().array() - to).abs().minCoeff(&k);
    return k;
  }

  Branch branch(Index k) const {
    Branch found{mu(k), 0, solver_.eigenvectors().col(k), {}};
    // The rows of the inverse are the left eigenvectors of m^-1 (K - F).
    const Eigen::VectorXcd mass = flag_.mass.cast<Complex>(),
                           row = Eigen::VectorXcd::Unit(count(), k);
    found.psi = Eigen::VectorXcd(vectors_.adjoint().solve(row)).cwiseQuotient(mass);
    const Eigen::VectorXcd inertia = mass.cwiseProduct(found.zeta);
    found.slope = found.psi.dot(Complex(0, -1) * response_.derivative(found.zeta) -
                                2 * omega_ * found.mu * inertia) /
                  (omega_ * omega_ * found.psi.dot(inertia));
    return found;
  }

 private:
  const Response& response_;
  const FlagOperator& flag_;
  double omega_;
  Eigen::ComplexEigenSolver<Eigen::MatrixXcd> solver_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> vectors_;
};

// The neutral mode after Newton's last step. Along the branch lambda = i omega, so that by
// continuation d lambda/d mu = i / (d mu/d omega).
NeutralMode mode_of(const Branch& branch, double omega, double step, int evaluations) {
  return {omega + step, (branch.mu + branch.slope * step).real(), Complex(0, 1) / branch.slope,
          branch.zeta.normalized(), evaluations};
}

bool is_in_reach(Complex ratio, const Interval& mu) {
  return mu.low / 2 <= ratio.real() && ratio.real() <= 2 * mu.high;
}

// A frequency at which a mass ratio may be real, as a share of a cell from its beginning.
struct Zero {
  double share, mu;
};

// Zeros of Im mu on the straight line from each mass ratio at the cell's beginning to the nearest
// one at its end, within the cell or some way beyond it.
std::vector<Zero> zeros_nearby(const Eigen::VectorXcd& here, const Eigen::VectorXcd& there,
                               const Interval& mu) {
  std::vector<Zero> found;
  for (const Complex ratio : here) {
    if (!is_in_reach(ratio, mu)) continue;
    Index nearest = 0;
    (there.array() - ratio).abs().minCoeff(&nearest);
    const Complex change = there[nearest] - ratio;
    const double share = -ratio.imag() / change.imag();
    if (-reach < share && share < 1 + reach)
      found.push_back({share, (ratio + change * share).real()});
  }
  return found;
}

}  // namespace

std::vector<Interval> frequency_windows(const Interval& size, bool is_symmetric) {
  if (is_symmetric) return {size};
  return {size, {-size.high, -size.low}};
}

Eigen::VectorXcd mass_ratios(const Eigen::MatrixXcd& F, const FlagOperator& flag, double omega) {
  constexpr bool with_vectors = false;
  return Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(over_inertia(F, flag, omega), with_vectors)
      .eigenvalues();
}

ShapesNearby shapes_nearby(const Response& response, const FlagOperator& flag, double omega,
                           const Interval& mu) {
  const MassRatios ratios(response, flag, omega);
  ShapesNearby found;
  for (Index k = 0; k < ratios.count(); ++k) {
    if (!is_in_reach(ratios.mu(k), mu)) continue;
    const Branch branch = ratios.branch(k);
    const double step = -branch.mu.imag() / branch.slope.imag();
    if (std::abs(step) > nearby || !is_in_reach(branch.mu + branch.slope * step, mu)) continue;
    found.mu.push_back(branch.mu);
    found.shapes.push_back(branch.zeta);
    found.shapes.push_back(branch.psi);
  }
  return found;
}

std::optional<NeutralMode> neutral_mode(const Aerodynamics& F, const FlagOperator& flag,
                                        double omega, double mu) {
  const double sign = std::copysign(1, omega);
  Complex near = mu;
  for (int evaluation = 1; evaluation <= most_evaluations; ++evaluation) {
    stop_if_interrupted("no neutral curve was written");
    const Response response = F(Complex(0, omega));
    const MassRatios ratios(response, flag, omega);
    const Branch branch = ratios.branch(ratios.nearest(near));
    const double step = -branch.mu.imag() / branch.slope.imag();
    if (!std::isfinite(step) || std::abs(step) > longest_step) return std::nullopt;
    if (std::abs(branch.mu.imag()) < neutral_to * std::abs(branch.mu)) {
      const NeutralMode found = mode_of(branch, omega, step, evaluation);
      if (found.mu > 0) return found;
      return std::nullopt;
    }
    omega += step;
    if (!(sign * omega > 0)) return std::nullopt;
    near = branch.mu + branch.slope * step;
  }
  return std::nullopt;
}

std::vector<NeutralMode> neutral_modes(const Aerodynamics& F, const FlagOperator& flag,
                                       const Interval& omega, const Interval& mu) {
  const int cells = std::max(1, static_cast<int>((omega.high - omega.low) / scan_spacing));
  const double spacing = (omega.high - omega.low) / cells;
  std::vector<NeutralMode> found;
  const auto is_known = [&](double its_omega, double its_mu, double same) {
    return std::ranges::any_of(found, [&](const NeutralMode& known) {
      return std::abs(known.omega - its_omega) < same &&
             std::abs(known.mu - its_mu) < same * its_mu;
    });
  };
  const auto ratios_at = [&](int point) {
    const double at = omega.low + point * spacing;
    return mass_ratios(F(Complex(0, at)).F, flag, at);
  };
  Eigen::VectorXcd next = ratios_at(0);
  for (int cell = 0; cell < cells; ++cell) {
    const Eigen::VectorXcd here = std::exchange(next, ratios_at(cell + 1));
    for (const Zero& start : zeros_nearby(here, next, mu)) {
      const double at = omega.low + (cell + start.share) * spacing;
      if (is_known(at, start.mu, same_start)) continue;
      const auto mode = neutral_mode(F, flag, at, start.mu);
      if (mode && omega.contains(mode->omega) && mu.contains(mode->mu) &&
          !is_known(mode->omega, mode->mu, same_frequency))
        found.push_back(*mode);
    }
  }
  std::ranges::sort(found, {}, &NeutralMode::mu);
  return found;
}

}  // namespace pennon::modes::global
