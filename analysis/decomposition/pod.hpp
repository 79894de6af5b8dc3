/// Proper orthogonal decomposition (Lumley 1967; by snapshots, Sirovich 1987; Towne, Schmidt &
/// Colonius 2018, section 2.1): the orthonormal modes phi_j whose sums come nearest to M snapshots
/// in the mean,
///
///     q_m = sum_j a_j(t_m) phi_j,     <phi_i, phi_j> = delta_ij,     mean(conj(a_i) a_j) =
///     lambda_i delta_ij.
///
/// The energies lambda_j are the eigenvalues of (1/M) sum_m q_m q_m^* W; their sum is the variance,
/// or the mean square where the mean is kept. With weights that change with time the snapshots are
/// W_m^1/2 q_m, and the modes are given back with the mean weight.
///
/// From A = W^1/2 q = U S V^*: lambda_j = s_j^2/M, phi_j = W^-1/2 u_j, a_j(t_m) = s_j conj(v_mj). A
/// is not formed; its triangular factor (triangular_factor.hpp) has the same S and V. lambda_j is
/// right to roundoff times (lambda_1 lambda_j)^1/2.
#pragma once

#include "common/linear_algebra/svd.hpp"

namespace pennon::decomposition {

template <class Scalar>
struct Pod {
  Eigen::VectorXd energy;            ///< lambda_j in falling order, all
  double variance = 0;               ///< their sum
  DenseMatrix<Scalar> coefficients;  ///< a_j(t_m), a row for each of the modes asked for
  /// The modes from weighted snapshots: u_j = sum_m A_m c_mj, a column for each mode.
  DenseMatrix<Scalar> combination;
};

/// Of R as triangular_factor() gives it; of `modes` at most. Where the mean was removed, the last
/// of M energies, which is zero, is left out. Throws InputError where the data do not vary.
template <class Scalar>
Pod<Scalar> pod(const DenseMatrix<Scalar>& R, bool mean_is_removed, Eigen::Index modes);

extern template Pod<double> pod(const DenseMatrix<double>&, bool, Eigen::Index);
extern template Pod<std::complex<double>> pod(const DenseMatrix<std::complex<double>>&, bool,
                                              Eigen::Index);

}  // namespace pennon::decomposition
