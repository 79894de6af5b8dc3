/// Neutral modes of flow and flag: those with lambda = i omega, which neither grow nor decay.
///
/// On the axis of the angular frequency the equations of the flag,
///
///   [lambda^2 mu m + K - F(lambda)] zeta = 0        (aerodynamic_matrix.hpp),
///
/// are linear in the mass ratio: mu is an eigenvalue of
///
///   [K - F(i omega)] zeta = mu omega^2 m zeta.
///
/// It is complex for most omega. A neutral mode is where it is real: a zero of one real function of
/// one real variable, found by Newton's method with the exact slope; psi the mode from the left,
///
///   d mu/d omega = psi^H [-i F'(i omega) - 2 omega mu m] zeta / (omega^2 psi^H m zeta).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "modes/global/equations/flag_operator.hpp"

namespace pennon::modes::global {

/// F at one lambda and, as a product, its derivative there.
struct Response {
  Eigen::MatrixXcd F;
  std::function<Eigen::VectorXcd(const Eigen::VectorXcd& zeta)> derivative;
};
/// A response is good until the next one is asked for.
using Aerodynamics = std::function<Response(std::complex<double> lambda)>;

struct Interval {
  double low, high;
  bool contains(double x) const { return low <= x && x <= high; }
};

struct NeutralMode {
  double omega, mu;
  std::complex<double>
      by_mu;              ///< d lambda/d mu: the mode grows above mu where its real part is > 0
  Eigen::VectorXcd zeta;  ///< at the free nodes, of length 1
  int evaluations = 0;    ///< of F that Newton's method took
};

/// Newton's method from a frequency and a mass ratio nearby; `flag` with mu = 1. None where it does
/// not converge to a neutral mode with mu > 0 and a frequency of the same sign.
std::optional<NeutralMode> neutral_mode(const Aerodynamics&, const FlagOperator& flag, double omega,
                                        double mu);

/// All neutral modes with frequency and mass ratio in the intervals, the smallest mu first:
/// Newton's method from where the straight lines between the mass ratios at the frequencies of a
/// fine grid have a zero. `F` is asked for many times.
std::vector<NeutralMode> neutral_modes(const Aerodynamics& F, const FlagOperator& flag,
                                       const Interval& omega, const Interval& mu);

/// The frequencies whose size is in the interval: where the spectrum is not symmetric about
/// omega = 0, of both signs. With a cross-flow and a wave along the span it is not: waves that
/// travel with the cross-flow and against it differ. All there is without one of the two is
/// F(lambda; k_x, U) = conj F(conj lambda; -k_x, U) = conj F(conj lambda; k_x, -U).
std::vector<Interval> frequency_windows(const Interval& size, bool is_symmetric);

/// All the complex mass ratios at a frequency.
Eigen::VectorXcd mass_ratios(const Eigen::MatrixXcd& F, const FlagOperator& flag, double omega);

/// What is next to neutral at a frequency: complex mass ratios with a small imaginary part, and for
/// each its shape and the one from the left.
struct ShapesNearby {
  std::vector<std::complex<double>> mu;
  std::vector<Eigen::VectorXcd> shapes;
};
ShapesNearby shapes_nearby(const Response&, const FlagOperator& flag, double omega,
                           const Interval& mu);

}  // namespace pennon::modes::global
