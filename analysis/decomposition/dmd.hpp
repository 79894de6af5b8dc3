/// Dynamic mode decomposition: snapshots at equal steps dt as a sum of exponentials in time,
///
///     q_m = sum_j b_j phi_j exp(lambda_j (t_m - t_0)),    |phi_j| = 1,  b_j > 0,
///
/// of rank r. Both variants work in the coordinates of R (triangular_factor.hpp), with X its first
/// M - 1 columns and Y its last M - 1.
///
/// Exact (Tu, Rowley, Luchtenburg, Brunton & Kutz 2014, definition 1): X = U S V^* of rank r; the
/// eigenvalues theta and vectors w of U^* Y V S^-1; lambda = log(theta)/dt; phi along Y c,
/// c = V S^-1 w. White noise of variance s^2 in every value makes theta too small, to first order
/// by the factor 1 - s^2/(the mode's mean square) (Dawson, Hemati, Williams & Rowley 2016): growth
/// rates come out too low.
///
/// Optimised (Askham & Kutz 2018): lambda minimises the sum of the squared misfits over all
/// snapshots together, by variable projection (Golub & Pereyra 1973, with the gradient of Kaufman
/// 1975) and the damping of Levenberg and Marquardt, on the projections on the first r singular
/// vectors, from the exact eigenvalues on. In white noise it is the estimate of greatest likelihood
/// but for that projection.
///
/// An oscillation that stands has one shape for both its phases, and no shape alone says how it
/// moves: then each snapshot is stacked with the d - 1 behind it (delays; Arbabi & Mezic 2017),
/// which the exact variant needs, and the optimised one to start from.
///
/// Errors are one standard deviation in white noise of the size that the misfit has, by the
/// linearised fit; those of the exact variant without its bias, those of the optimised one, with
/// the true lambda and noise, the bound of Cramer and Rao. What the data hold beside r exponentials
/// counts as noise.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "common/linear_algebra/svd.hpp"

namespace pennon::decomposition {

enum class DmdVariant { exact, optimised };

struct DmdChoice {
  DmdVariant variant = DmdVariant::exact;
  std::optional<Eigen::Index> rank = {};  ///< none: that of the signal (signal_rank.hpp)
  Eigen::Index delays = 1;                ///< snapshots that are stacked, d
};

struct DmdMode {
  std::complex<double> lambda;  ///< growth + i (angular frequency)
  /// b_j: exact, of the first snapshots as a sum of modes, by least squares; optimised, of all. A
  /// pair of real data swings with twice as much.
  double amplitude = 0;
  /// |Y c - theta X c|/(|theta| |X c|), c the combination of snapshots that is the mode; 0 where
  /// the data are such a sum, and also where the rank is that of the data, whatever they do: see
  /// the misfit.
  double residual = 0;
  double growth_error = 0, omega_error = 0;
};

struct Dmd {
  Eigen::Index rank = 0;
  Eigen::Index rank_of_signal =
      0;  ///< optimised: where it was higher, no fit of that rank was found
  /// The largest mean square over the snapshots first; of a pair the one with omega > 0 first.
  std::vector<DmdMode> modes;
  /// phi_j as a sum of weighted snapshots, a column for each mode, with the phase that it has in
  /// the first snapshot.
  Eigen::MatrixXcd combination;
  /// What the sum of all modes leaves of all snapshots, over their norm.
  double misfit = 0;
  Eigen::Index vanished = 0;  ///< eigenvalues theta = 0, which have no lambda
};

/// `values`: how many values a snapshot has; with the number of snapshots it sets the shape of the
/// matrix whose rank is asked for. Throws InputError where the rank is above that of the data, or
/// there are too few snapshots; SolverError where the optimised fit does not converge, for a rank
/// that was asked for or for any.
template <class Scalar>
Dmd dmd(const DenseMatrix<Scalar>& R, double dt, std::size_t values, const DmdChoice&);

extern template Dmd dmd(const DenseMatrix<double>&, double, std::size_t, const DmdChoice&);
extern template Dmd dmd(const DenseMatrix<std::complex<double>>&, double, std::size_t,
                        const DmdChoice&);

}  // namespace pennon::decomposition
