/// A rational function through samples of a matrix that depends on lambda, all entries with the
/// same weights: the set-valued AAA algorithm (Nakatsukasa, Sete & Trefethen 2018; Lietaert,
/// Meerbergen, Perez & Vandereycken 2022) in barycentric form,
///
///   r(lambda) = sum_j w_j F_j / (lambda - lambda_j)  /  sum_j w_j / (lambda - lambda_j).
///
/// Support points are taken one by one where the error is largest; the weights make the linearised
/// residual at the other samples least. An evaluation is a linear combination of the F_j: the
/// product of one matrix and one vector.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace pennon::modes::global {

struct MatrixSample {
  std::complex<double> lambda;
  Eigen::MatrixXcd F;
};

class RationalFit {
 public:
  /// Adds support points until the largest error at a sample, in Frobenius' norm over the largest
  /// norm of a sample, is below `tolerance`. Precondition: two samples or more, no two at one
  /// lambda.
  RationalFit(const std::vector<MatrixSample>& samples, double tolerance);

  Eigen::MatrixXcd operator()(std::complex<double> lambda) const;
  /// r'(lambda) x.
  Eigen::VectorXcd derivative(std::complex<double> lambda, const Eigen::VectorXcd& x) const;

  /// basis^H r(lambda) basis, with the same support points and weights.
  RationalFit projected(const Eigen::MatrixXcd& basis) const;

  std::size_t support_points() const { return static_cast<std::size_t>(lambda_.size()); }
  /// The error at the samples, measured as `tolerance` is. It says nothing about other lambda.
  double error_at_samples() const { return error_; }

 private:
  RationalFit() = default;
  // The coefficients of the F_j in r and in r'.
  Eigen::VectorXcd shares(std::complex<double> lambda) const;
  Eigen::VectorXcd shares_of_derivative(std::complex<double> lambda) const;

  Eigen::VectorXcd lambda_, weights_;  // of the support points
  Eigen::MatrixXcd F_;                 // a column for each
  Eigen::Index rows_ = 0;
  double error_ = 0;
};

}  // namespace pennon::modes::global
