/// Eigenpairs of A q = lambda B q that were found next to one or several targets.
#pragma once

#include <complex>
#include <vector>

#include "modes/global/equations/pencil.hpp"

namespace pennon::modes::global {

struct Eigenpair {
  std::complex<double> lambda;
  Eigen::VectorXcd q;
  double residual = 0;  ///< |A q - lambda B q| over |A q| + |lambda| |B q|
  /// The adjoint, A^H p = conj(lambda) B^H p, and its residual; empty where it was not sought.
  Eigen::VectorXcd p = {};
  double adjoint_residual = 0;
};

struct Spectrum {
  std::vector<Eigenpair> pairs;  ///< converged; the most unstable first
  int requested = 0;
};

/// The residual of a pair.
double residual_of(const Pencil&, const Eigenpair&);

/// Scales q to q^H B q = 1 and, where there is one, p to p^H B q = 1.
void normalise(const Pencil&, Eigenpair&);

/// The largest |p_i^H B q_j|, i != j, of normalised pairs that have adjoints: 0 but for rounding
/// and the residuals.
double biorthogonality_defect(const Pencil&, const std::vector<Eigenpair>&);

/// Makes p_i^H B q_j = 0, i != j, to rounding, and finds all residuals anew. Nothing is done where
/// one has no adjoint. Precondition: normalised.
///
/// p^H B q = 1 makes the adjoints of damped modes large, for these are nearly orthogonal to their
/// modes: sqrt(p^H B p) is 22 for a flag's first mode and 2e4 for its sixth. What Krylov's space
/// leaves in such a p, 1e-12 of it and most along the adjoint next to the target, is then no longer
/// small beside 1. The residuals tell what each mode and each adjoint holds of the others; among
/// pairs with |p| |B q| < 1e4 that is taken out, and the eigenvalues are corrected, to first order.
/// What is left goes by Gram and Schmidt's method for two sets of vectors, by growing |p|: a large
/// p gives up what it holds of smaller ones, and the other way round q does; either changes by a
/// small part of itself.
void biorthogonalise(const Pencil&, std::vector<Eigenpair>&);

/// Gives the pair, whose eigenvalue is that of p, its adjoint.
void set_adjoint(const Pencil&, Eigen::VectorXcd p, Eigenpair&);

/// Whether two eigenvalues are one.
bool are_same(std::complex<double> a, std::complex<double> b);

/// Adds the pairs that are not there yet: eigenvalues closer than their own accuracy are one, of
/// which the better pair is kept. The most unstable first.
void merge(std::vector<Eigenpair> others, Spectrum&);

/// Inverse iteration (Wielandt 1944) from a target, which is moved toward the eigenvalue now and
/// then, for one eigenpair, by UMFPACK. Throws SolverError where it does not settle.
Eigenpair eigenpair_near(const SparsePencil&, std::complex<double> target);

}  // namespace pennon::modes::global
