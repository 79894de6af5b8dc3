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
  const Eigen::VectorXcd q_v = q.head(n), zeta = q.segment(n, m), zeta_t = q.tail(m);
  Eigen::VectorXcd product(size());
  product.head(n) = f.A_vv * q_v + f.A_vz(zeta) + f.A_vt(zeta_t);
  product.segment(n, m) = zeta_t;
  product.tail(m) = f.A_tv * q_v + (f.F_z - flag.stiffness) * zeta + f.F_t * zeta_t;
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
  const Eigen::VectorXcd p_v = p.head(n), p_z = p.segment(n, m), p_t = p.tail(m);
  Eigen::VectorXcd product(size());
  product.head(n) = f.A_vv.adjoint() * p_v + f.A_tv.adjoint() * p_t;
  product.segment(n, m) = f.A_vz_adjoint(p_v) + (f.F_z - flag.stiffness).adjoint() * p_t;
  product.tail(m) = f.A_vt_adjoint(p_v) + p_z + f.F_t.adjoint() * p_t;
  return product;
}

// Volumes and masses are real.
Eigen::VectorXcd CoupledOperator::B_adjoint(const Eigen::VectorXcd& p) const {
  return B(p);
}

SparsePencil CoupledOperator::assembled() const {
  const LinearFluid& f = fluid();
  const Eigen::Index m = flag_nodes(), z = zeta(0), t = zeta_t(0);
  const Eigen::MatrixXcd A_vz = f.flag_forcing(0, 0, m), A_vt = f.flag_forcing(1, 0, m) - A_vz,
                         A_tz = f.F_z - flag.stiffness, one = Eigen::MatrixXcd::Identity(m, m),
                         mass = flag.mass.cast<Complex>().asDiagonal();
  Triplets A, B;
  add(f.A_vv, 0, 0, A);
  add(A_vz, 0, z, A);
  add(A_vt, 0, t, A);
  add(one, z, t, A);
  add(f.A_tv, t, 0, A);
  add(A_tz, t, z, A);
  add(f.F_t, t, t, A);
  add(f.B_vv, 0, 0, B);
  add(one, z, z, B);
  add(mass, t, t, B);
  return {matrix_of(A, size()), matrix_of(B, size())};
}

CoupledOperator coupled_operator(const OGrid& grid, const BaseFlow& base, FlagOperator flag,
                                 double k_x) {
  const int nodes = static_cast<int>(flag.mass.size());
  return {std::make_shared<LinearFluid>(linear_fluid(grid, base, nodes, k_x)), std::move(flag)};
}

}  // namespace pennon::modes::global
