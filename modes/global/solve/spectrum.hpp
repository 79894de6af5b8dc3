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
  int requested = 0;  ///< pairs that were asked for: n_modes of each target that was given
};

/// Eigenpair::residual, computed from A and B.
double residual_of(const Pencil&, const Eigenpair&);

/// Scales q to q^H B q = 1 and, where there is one, p to p^H B q = 1.
void normalise(const Pencil&, Eigenpair&);

/// The largest |p_i^H B q_j|, i != j, of normalised pairs that have adjoints. For exact pairs it is
/// 0.
double biorthogonality_defect(const Pencil&, const std::vector<Eigenpair>&);

/// Makes p_i^H B q_j = 0, i != j, to rounding, and computes all residuals anew. Nothing is done
/// where one of the pairs has no adjoint. Precondition: the pairs are normalised.
///
/// p^H B q = 1 makes the adjoints of damped modes large, for these are nearly orthogonal to their
/// modes: sqrt(p^H B p) is 22 for a flag's first mode and 2e4 for its sixth. The Krylov method
/// leaves an error of 1e-12 of such a p, mostly along the adjoint next to the target, and that is
/// not small beside 1. From the residuals follow, to first order, the components of each mode and
/// each adjoint along the others; among pairs with |p| |B q| < 1e4 these are removed, and the
/// eigenvalues are corrected. Gram and Schmidt's method for two sets of vectors, by increasing |p|,
/// removes the rest.
void biorthogonalise(const Pencil&, std::vector<Eigenpair>&);

/// Gives the pair the adjoint p, a vector that belongs to the same eigenvalue, and computes the
/// adjoint's residual.
void set_adjoint(const Pencil&, Eigen::VectorXcd p, Eigenpair&);

/// Whether two computed eigenvalues are the same but for their accuracy.
bool are_same(std::complex<double> a, std::complex<double> b);

/// Adds pairs to a spectrum, which stays sorted, the most unstable first. Of two pairs whose
/// eigenvalues are the same the one with the smaller residual is kept.
void merge(std::vector<Eigenpair> others, Spectrum&);

/// One eigenpair near a target, by inverse iteration (Wielandt 1944) with UMFPACK; the shift is
/// moved toward the eigenvalue now and then. Throws SolverError where it does not converge.
Eigenpair eigenpair_near(const SparsePencil&, std::complex<double> target);

}  // namespace pennon::modes::global
