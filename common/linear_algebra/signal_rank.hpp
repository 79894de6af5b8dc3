/// How many singular values of a noisy matrix are signal.
#pragma once

#include <Eigen/Core>

namespace pennon {

/// Of singular values in falling order, of a matrix whose fewer rows or columns are `beta` times
/// the more, 0 < beta <= 1: how many are above the optimal threshold for white noise of unknown
/// level, omega(beta) times the median (Gavish & Donoho 2014, equation 5: omega by their cubic,
/// good to a fiftieth), and above `roundoff` times the largest. With fewer than eight values the
/// median says nothing of the noise, and the second alone holds.
Eigen::Index signal_rank(const Eigen::VectorXd& sigma, double beta, double roundoff);

}  // namespace pennon
