/// Snapshots in as few numbers as their inner products need. With the weighted data A = W^1/2 q, a
/// row for each value and a column for each snapshot,
///
///     A = Q R,    Q^* Q = 1,
///
/// R has as many rows as there are snapshots, or as values where these are fewer, and
/// <q_l, q_m> = r_l^* r_m for its columns. Proper orthogonal and dynamic mode decomposition follow
/// from R alone, and each of their modes is a sum of snapshots. R is found band by band: the factor
/// of the bands before is the upper part of what the next one is added to (a QR decomposition of
/// one tall matrix in parts; Demmel, Grigori, Hoemmen & Langou 2012). Unlike the matrix of inner
/// products A^* A it keeps small singular values, down to roundoff of the largest and not of its
/// square.
#pragma once

#include "analysis/decomposition/bands.hpp"

namespace pennon::decomposition {

/// The same on every rank. Throws InputError where its M x M entries exceed the memory.
template <class Scalar>
DenseMatrix<Scalar> triangular_factor(const Bands<Scalar>&);

/// The factor of all ranks' rows together from that of each rank's; the same on every rank.
template <class Scalar>
DenseMatrix<Scalar> gathered_factor(const DenseMatrix<Scalar>& mine);

}  // namespace pennon::decomposition
