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
/// one real variable, found by Newton's method with the exact slope,
///
///   d mu/d omega = psi^H [-i F'(i omega) - 2 omega mu m] zeta / (omega^2 psi^H m zeta),
///
/// where psi is the left eigenvector (the adjoint mode).
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
/// Evaluates F. A Response may be used only until the next one is evaluated.
using Aerodynamics = std::function<Response(std::complex<double> lambda)>;

struct Interval {
  double low, high;
  bool contains(double x) const { return low <= x && x <= high; }
};

struct NeutralMode {
  double omega, mu;
  /// d lambda/d mu: where its real part is positive, the mode grows at larger mass ratios.
  std::complex<double> by_mu;
  Eigen::VectorXcd zeta;  ///< at the free nodes, of length 1
  int evaluations = 0;    ///< of F that Newton's method took
};

/// The neutral mode near a frequency and a mass ratio, by Newton's method; `flag` with mu = 1. None
/// where it does not converge to one with mu > 0 and a frequency of the same sign.
std::optional<NeutralMode> neutral_mode(const Aerodynamics&, const FlagOperator& flag, double omega,
                                        double mu);

/// All neutral modes with frequency and mass ratio in the intervals, by increasing mu. Newton's
/// method starts where Im mu, interpolated linearly between the frequencies of a fine grid, has a
/// zero. `F` is evaluated many times, so it should be a fit.
std::vector<NeutralMode> neutral_modes(const Aerodynamics& F, const FlagOperator& flag,
                                       const Interval& omega, const Interval& mu);

/// The windows of omega in which |omega| lies in the interval. One window suffices where the
/// spectrum is symmetric about omega = 0. It is not symmetric with both a cross-flow and a wave
/// along the span, since waves that travel with the cross-flow differ from those that travel
/// against it; then there is a window for each sign. In general only F(lambda; k_x, U) = conj
/// F(conj lambda; -k_x, U) = conj F(conj lambda; k_x, -U) holds.
std::vector<Interval> frequency_windows(const Interval& size, bool is_symmetric);

/// All complex mass ratios at a frequency: the eigenvalues mu of the equation above.
Eigen::VectorXcd mass_ratios(const Eigen::MatrixXcd& F, const FlagOperator& flag, double omega);

/// The modes that are nearly neutral at a frequency, to first order neutral within 1 of it.
struct ShapesNearby {
  std::vector<std::complex<double>> mu;  ///< their complex mass ratios
  std::vector<Eigen::VectorXcd> shapes;  ///< zeta and psi of each
};
/// Those whose mass ratio lies within a factor 2 of the interval.
ShapesNearby shapes_nearby(const Response&, const FlagOperator& flag, double omega,
                           const Interval& mu);

}  // namespace pennon::modes::global
