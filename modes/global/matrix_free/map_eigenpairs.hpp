/// Eigenpairs of a linear map that is given as a function of a vector, by ARPACK's implicitly
/// restarted Arnoldi method with reverse communication (Lehoucq, Sorensen & Yang 1998).
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

namespace pennon::modes {

/// out = map(in), both of one size.
using LinearMap = std::function<void(const double* in, double* out)>;

struct MapEigenpair {
  std::complex<double> value;  ///< imaginary part >= 0; its conjugate is left out
  Eigen::VectorXcd vector;     ///< of norm 1
  double residual = 0;         ///< |map(vector) - value vector|/|value|, computed anew
};

struct MapSettings {
  int count = 2;            ///< eigenvalues wanted, a complex pair counts as two
  int basis = 20;           ///< Arnoldi vectors, >= count + 2
  double tolerance = 1e-6;  ///< of an eigenvalue, relative
  int most_restarts = 100;
};

/// The eigenpairs of largest modulus, by decreasing modulus. `start`: the vector to begin with.
/// Throws SolverError where fewer than `count` converge.
std::vector<MapEigenpair> largest_eigenpairs(const LinearMap&, const Eigen::VectorXd& start,
                                             const MapSettings&);

}  // namespace pennon::modes
