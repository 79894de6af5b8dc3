/// The matrices of a generalised eigenproblem A q = lambda B q, by their products with vectors. The
/// adjoint functions multiply with the conjugate transpose.
#pragma once

#include <Eigen/SparseCore>
#include <complex>

namespace pennon::modes::global {

class Pencil {
 public:
  Pencil() = default;
  Pencil(const Pencil&) = default;
  Pencil& operator=(const Pencil&) = default;
  Pencil(Pencil&&) = default;
  Pencil& operator=(Pencil&&) = default;
  virtual ~Pencil() = default;

  virtual Eigen::Index size() const = 0;
  virtual Eigen::VectorXcd A(const Eigen::VectorXcd& q) const = 0;
  virtual Eigen::VectorXcd B(const Eigen::VectorXcd& q) const = 0;
  virtual Eigen::VectorXcd A_adjoint(const Eigen::VectorXcd& p) const = 0;
  virtual Eigen::VectorXcd B_adjoint(const Eigen::VectorXcd& p) const = 0;
};

/// Two sparse matrices.
struct SparsePencil final : Pencil {
  Eigen::SparseMatrix<std::complex<double>> matrix_A, matrix_B;

  SparsePencil(const Eigen::SparseMatrix<std::complex<double>>& its_A,
               const Eigen::SparseMatrix<std::complex<double>>& its_B)
      : matrix_A(its_A), matrix_B(its_B) {}

  /// A^H p = conj(lambda) B^H p.
  SparsePencil adjoint() const { return {matrix_A.adjoint(), matrix_B.adjoint()}; }

  Eigen::Index size() const override { return matrix_A.rows(); }
  Eigen::VectorXcd A(const Eigen::VectorXcd& q) const override { return matrix_A * q; }
  Eigen::VectorXcd B(const Eigen::VectorXcd& q) const override { return matrix_B * q; }
  Eigen::VectorXcd A_adjoint(const Eigen::VectorXcd& p) const override {
    return matrix_A.adjoint() * p;
  }
  Eigen::VectorXcd B_adjoint(const Eigen::VectorXcd& p) const override {
    return matrix_B.adjoint() * p;
  }
};

}  // namespace pennon::modes::global
