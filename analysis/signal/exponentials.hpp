/// A signal as a sum of complex exponentials, by the matrix pencil (Hua & Sarkar 1990):
///
///     f(t_0 + k dt) = sum_i a_i exp(lambda_i k dt).
///
/// The rows of the Hankel matrix f_{j+k} span the vectors (1, z_i, z_i^2, ...), z_i = exp(lambda_i
/// dt). Its singular vectors above the noise are that space; the shift of the space by one sample
/// has the eigenvalues z_i. The method needs neither start values nor a guess of the period; a
/// transient or an offset takes exponentials of its own and does not disturb the leading mode. The
/// median singular value determines what counts as noise (Gavish & Donoho 2014).
#pragma once

#include <complex>
#include <vector>

#include "analysis/signal/spanwise_amplitudes.hpp"

namespace pennon::analysis {

struct Exponential {
  std::complex<double> lambda;     ///< growth + i (angular frequency)
  std::complex<double> amplitude;  ///< at the first sample
};

/// At most `most` exponentials; none for a signal that is zero. The fit is exact to roundoff where
/// the signal is a sum of no more than that many. Precondition: at least 8 samples.
std::vector<Exponential> fit_exponentials(const Complexes& samples, double dt, std::size_t most);

}  // namespace pennon::analysis
