#include "modes/global/neutral.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/interrupt.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Index = Eigen::Index;

constexpr double neutral_to = 1e-6;  // |Im mu| over |mu|: its square is the error of mu
constexpr int most_evaluations = 12;
constexpr double longest_step = 1;    // of omega
constexpr double scan_spacing = 0.1;  // of omega
constexpr double reach = 1.5;         // spacings within which a zero is sought
constexpr double same_frequency = 1e-4;

// Mass ratio and slope of one mode at a frequency.
struct Branch {
  Complex mu, slope;
  Eigen::VectorXcd zeta, psi;
};

// All the mass ratios at a frequency.
class MassRatios {
 public:
  MassRatios(const Response& response, const FlagOperator& flag, double omega)
      : response_(response), flag_(flag), omega_(omega) {
    const Eigen::VectorXcd scale = (omega * omega * flag.mass).cast<Complex>().cwiseInverse();
    solver_.compute(scale.asDiagonal() * (flag.stiffness - response.F));
    from_left_ = solver_.eigenvectors().partialPivLu().inverse();
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
    // The rows of the inverse are those from the left of m^-1 (K - F).
    const Eigen::VectorXcd mass = flag_.mass.cast<Complex>();
    found.psi = from_left_.row(k).adjoint().cwiseQuotient(mass);
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
  Eigen::MatrixXcd from_left_;
};

// With lambda = i omega along the branch, d lambda/d mu = i / (d mu/d omega), continued off the
// axis.
NeutralMode mode_of(const Branch& branch, double omega, double step, int evaluations) {
  return {omega + step, (branch.mu + branch.slope * step).real(), Complex(0, 1) / branch.slope,
          branch.zeta.normalized(), evaluations};
}

}  // namespace

std::optional<NeutralMode> neutral_mode(const Aerodynamics& F, const FlagOperator& flag,
                                        double omega, double mu) {
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
    if (!(omega > 0)) return std::nullopt;
    near = branch.mu + branch.slope * step;
  }
  return std::nullopt;
}

std::vector<NeutralMode> neutral_modes(const Aerodynamics& F, const FlagOperator& flag,
                                       const Interval& omega, const Interval& mu) {
  const int cells = std::max(1, static_cast<int>((omega.high - omega.low) / scan_spacing));
  const double spacing = (omega.high - omega.low) / cells;
  std::vector<NeutralMode> found;
  const auto add = [&](const NeutralMode& mode) {
    if (!omega.contains(mode.omega) || !mu.contains(mode.mu)) return;
    const bool is_known = std::ranges::any_of(found, [&](const NeutralMode& known) {
      return std::abs(known.omega - mode.omega) < same_frequency &&
             std::abs(known.mu - mode.mu) < same_frequency * mode.mu;
    });
    if (!is_known) found.push_back(mode);
  };
  for (int cell = 0; cell <= cells; ++cell) {
    const double at = omega.low + cell * spacing;
    std::vector<double> starts;
    {
      const Response response = F(Complex(0, at));
      const MassRatios ratios(response, flag, at);
      for (Index k = 0; k < ratios.count(); ++k) {
        const Complex ratio = ratios.mu(k);
        if (ratio.real() < mu.low / 2 || ratio.real() > 2 * mu.high) continue;
        const Branch branch = ratios.branch(k);
        const double step = -ratio.imag() / branch.slope.imag();
        if (std::abs(step) < reach * spacing) {
          // From the predicted zero.
          starts.push_back(at + step);
          starts.push_back((ratio + branch.slope * step).real());
        }
      }
    }
    for (std::size_t s = 0; s < starts.size(); s += 2)
      if (const auto mode = neutral_mode(F, flag, starts[s], starts[s + 1])) add(*mode);
  }
  std::ranges::sort(found, {}, &NeutralMode::mu);
  return found;
}

}  // namespace pennon::modes::global
