#include "modes/global/equations/coupled_operator.hpp"

#include <vector>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Triplets = std::vector<Eigen::Triplet<Complex>>;

void add(const Eigen::SparseMatrix<Complex>& part, Eigen::Index row, Eigen::Index column,
         Triplets& entries) {
  for (int q = 0; q < part.outerSize(); ++q)
    for (Eigen::SparseMatrix<Complex>::InnerIterator entry(part, q); entry; ++entry)
      entries.emplace_back(row + entry.row(), column + q, entry.value());
}

void add(const Eigen::MatrixXcd& part, Eigen::Index row, Eigen::Index column, Triplets& entries) {
  for (Eigen::Index q = 0; q < part.cols(); ++q)
    for (Eigen::Index p = 0; p < part.rows(); ++p)
      if (part(p, q) != 0.0) entries.emplace_back(row + p, column + q, part(p, q));
}

Eigen::SparseMatrix<Complex> matrix_of(const Triplets& entries, Eigen::Index size) {
  Eigen::SparseMatrix<Complex> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Eigen::VectorXcd CoupledOperator::A(const Eigen::VectorXcd& q) const {
  const LinearFluid& f = fluid();
  const Eigen::Index n = flow().unknowns(), m = flag_nodes();
  const Eigen::VectorXcd v = q.head(n), z = q.segment(n, m), e = q.tail(m);
  Eigen::VectorXcd product(size());
  product.head(n) = f.A_vv * v + f.D_z(z) + f.D_e(e);
  product.segment(n, m) = e;
  product.tail(m) = f.A_ev * v + (f.F_z - flag.stiffness) * z + f.F_e * e;
  return product;
}

Eigen::VectorXcd CoupledOperator::B(const Eigen::VectorXcd& q) const {
  const Eigen::Index n = flow().unknowns(), m = flag_nodes();
  Eigen::VectorXcd product(size());
  product.head(n) = fluid().B_vv * q.head(n);
  product.segment(n, m) = q.segment(n, m);
  product.tail(m) = flag.mass.cast<Complex>().cwiseProduct(q.tail(m));
  return product;
}

Eigen::VectorXcd CoupledOperator::A_adjoint(const Eigen::VectorXcd& p) const {
  const LinearFluid& f = fluid();
  const Eigen::Index n = flow().unknowns(), m = flag_nodes();
  const Eigen::VectorXcd v = p.head(n), z = p.segment(n, m), e = p.tail(m);
  Eigen::VectorXcd product(size());
  product.head(n) = f.A_vv.adjoint() * v + f.A_ev.adjoint() * e;
  product.segment(n, m) = f.D_z_adjoint(v) + (f.F_z - flag.stiffness).adjoint() * e;
  product.tail(m) = f.D_e_adjoint(v) + z + f.F_e.adjoint() * e;
  return product;
}

// Volumes and masses are real.
Eigen::VectorXcd CoupledOperator::B_adjoint(const Eigen::VectorXcd& p) const {
  return B(p);
}

SparsePencil CoupledOperator::assembled() const {
  const LinearFluid& f = fluid();
  const Eigen::Index m = flag_nodes(), z = zeta(0), e = zeta_t(0);
  const Eigen::MatrixXcd D_z = f.motion(0, 0, m), D_e = f.motion(1, 0, m) - D_z,
                         F_z = f.F_z - flag.stiffness, one = Eigen::MatrixXcd::Identity(m, m),
                         mass = flag.mass.cast<Complex>().asDiagonal();
  Triplets A, B;
  add(f.A_vv, 0, 0, A);
  add(D_z, 0, z, A);
  add(D_e, 0, e, A);
  add(one, z, e, A);
  add(f.A_ev, e, 0, A);
  add(F_z, e, z, A);
  add(f.F_e, e, e, A);
  add(f.B_vv, 0, 0, B);
  add(one, z, z, B);
  add(mass, e, e, B);
  return {matrix_of(A, size()), matrix_of(B, size())};
}

CoupledOperator coupled_operator(const OGrid& grid, const BaseFlow& base, FlagOperator flag,
                                 double k_x) {
  const int nodes = static_cast<int>(flag.mass.size());
  return {std::make_shared<LinearFluid>(linear_fluid(grid, base, nodes, k_x)), std::move(flag)};
}

}  // namespace pennon::modes::global
