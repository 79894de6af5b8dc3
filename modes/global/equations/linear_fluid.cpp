#include "modes/global/equations/linear_fluid.hpp"

#include <algorithm>
#include <vector>

#include "modes/global/equations/jacobian.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Triplets = std::vector<Eigen::Triplet<Complex>>;

// A real matrix, transposed, times a complex vector.
Eigen::VectorXcd transpose_times(const Eigen::MatrixXd& matrix, const Eigen::VectorXcd& vector) {
  Eigen::VectorXcd product(matrix.cols());
  product.real() = matrix.transpose() * vector.real();
  product.imag() = matrix.transpose() * vector.imag();
  return product;
}

// The cells whose equations know a corner lie between the corner's row and column less 2 and plus
// 1: corners four rows and columns apart share an evaluation.
constexpr int below = 2, above = 1;
constexpr int period = below + above + 1;
constexpr int rows_of_force = period;  // that the force on the flag may know

class Assembly {
 public:
  Assembly(const OGrid& grid, const BaseFlow& base, int nodes, double k_x)
      : equations_(grid, base.parameters, base.q.components()),
        base_(complex_flow(base.q)),
        R_(base_.p.extent(), base_.components()),
        X_(R_),
        still_(base_.p.extent()),
        corners_(base_.p.extent()),
        result_{.flow = {base_.p.extent(), base_.components(), Symmetry::antisymmetric},
                .flag_nodes = nodes,
                .is_symmetric = k_x == 0 || base.parameters.U == 0},
        k_x_(k_x) {
    equations_.set_inflow(base.is_inflow);
  }

  LinearFluid operator()(const OGrid& grid, const BaseFlow& base) {
    add_flow(base);
    result_.G = grid_response(grid, static_cast<int>(result_.flag_nodes));
    add_displacement();
    add_velocity();
    return std::move(result_);
  }

 private:
  bool has_span() const { return base_.components() > 2; }

  LinearFluid::SparseRows matrix_of(const Triplets& entries, Eigen::Index rows,
                                    Eigen::Index columns) const {
    LinearFluid::SparseRows matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  void add_flow(const BaseFlow& base) {
    const Jacobian J = jacobian(equations_, base.q, result_.flow, has_span());
    result_.A_vv = -J.in_plane.cast<Complex>();
    if (has_span()) {
      result_.A_vv -= Complex(0, k_x_) * J.along_x.cast<Complex>();
      result_.A_vv += Complex(k_x_ * k_x_) * J.along_x_twice.cast<Complex>();
    }
    result_.A_vv.makeCompressed();
    Triplets force, volumes;
    for (int q = 0; q < J.force.outerSize(); ++q)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(J.force, q); entry; ++entry)
        add_force(entry.row(), q, entry.value(), force);
    const Eigen::Index n = result_.flow.unknowns();
    result_.A_tv = matrix_of(force, result_.flag_nodes, n);
    const Field<Complex>& volume = equations_.metrics().volume;
    result_.flow.for_each([&](int f, int j, int i, Eigen::Index k) {
      if (f < base_.components()) volumes.emplace_back(k, k, volume.row(0, j)[i]);
    });
    result_.B_vv = matrix_of(volumes, n, n);
  }

  // A segment's force along z, to its two nodes in halves.
  void add_force(Eigen::Index segment, Eigen::Index column, Complex value,
                 Triplets& entries) const {
    const Eigen::Index held = result_.flow.columns() + 1 - result_.flag_nodes;
    for (const Eigen::Index node : {segment - held, segment + 1 - held})
      if (node >= 0 && value != 0.0) entries.emplace_back(node, column, value / 2.0);
  }

  // What the last evaluation says of a corner, times `of_R` and `of_X`.
  void read(int direction, int j, int i, Complex of_R, Complex of_X, Triplets& flow,
            Triplets& force) const {
    const Eigen::Index by = corners_.index(direction, j, i);
    const int last_row = std::min(result_.flow.rows() - 1, j + above),
              last = std::min(result_.flow.columns() - 1, i + above);
    for (int at_j = std::max(0, j - below); at_j <= last_row; ++at_j)
      for (int at = std::max(0, i - below); at <= last; ++at)
        for (int f = 0; f < result_.flow.fields(); ++f) {
          Complex value = of_R * R_.field(f).row(0, at_j)[at].imag();
          if (has_span()) value += of_X * X_.field(f).row(0, at_j)[at].imag();
          if (value != 0.0)
            flow.emplace_back(result_.flow.index(f, at_j, at), by, -value / complex_step);
        }
    if (j >= rows_of_force) return;
    for (int at = std::max(0, i - below); at <= last; ++at) {
      const int segment = result_.flow.columns() - 1 - at;  // whose upper face this is
      const double value = equations_.forces().z[static_cast<std::size_t>(segment)].imag();
      add_force(segment, by, of_R * value / complex_step, force);
    }
  }

  // set(step) gives the equations a step of the corners; use(direction, j, i) each that moved.
  template <class Set, class Use>
  void for_each_step(const Set& set, const Use& use) {
    corners_.for_each_step(
        period,
        [&](const Displacement<Complex>& step) {
          set(step);
          equations_.evaluate(base_, nullptr, R_, has_span() ? &X_ : nullptr);
        },
        use);
  }

  // The grid's displacement and its derivative along x.
  void add_displacement() {
    const Complex ik(0, k_x_);
    Triplets flow, force;
    for_each_step([&](const Displacement<Complex>& step) { equations_.set_grid(step, nullptr); },
                  [&](int direction, int j, int i) { read(direction, j, i, 1, -ik, flow, force); });
    if (has_span())
      for_each_step(
          [&](const Displacement<Complex>& step) { equations_.set_grid(still_, &step); },
          [&](int direction, int j, int i) { read(direction, j, i, ik, -ik * ik, flow, force); });
    equations_.set_grid(still_, nullptr);
    keep(flow, force, result_.A_vd, result_.F_z);
  }

  void add_velocity() {
    Triplets flow, force;
    for_each_step([&](const Displacement<Complex>& step) { equations_.set_grid_velocity(step); },
                  [&](int direction, int j, int i) {
                    read(direction, j, i, 1, {0, -k_x_}, flow, force);
                  });
    equations_.set_grid_velocity(still_);
    keep(flow, force, result_.A_vg, result_.F_t);
  }

  void keep(const Triplets& flow, const Triplets& force, LinearFluid::SparseRows& D,
            Eigen::MatrixXcd& F) const {
    D = matrix_of(flow, result_.flow.unknowns(), corners_.unknowns());
    F = matrix_of(force, result_.flag_nodes, corners_.unknowns()) * result_.G.cast<Complex>();
  }

  PlaneEquations<Complex> equations_;
  PlaneFlow<Complex> base_, R_, X_;
  Displacement<Complex> still_;
  MovingCorners corners_;
  LinearFluid result_;
  double k_x_;
};

}  // namespace

Eigen::VectorXcd LinearFluid::corners(const Eigen::VectorXcd& zeta) const {
  Eigen::VectorXcd product(G.rows());
  product.real() = G * zeta.real();
  product.imag() = G * zeta.imag();
  return product;
}

Eigen::VectorXcd LinearFluid::A_vz(const Eigen::VectorXcd& zeta) const {
  return A_vd * corners(zeta);
}

Eigen::VectorXcd LinearFluid::A_vt(const Eigen::VectorXcd& zeta_t) const {
  return A_vg * corners(zeta_t);
}

Eigen::VectorXcd LinearFluid::A_vz_adjoint(const Eigen::VectorXcd& p) const {
  return transpose_times(G, A_vd.adjoint() * p);
}

Eigen::VectorXcd LinearFluid::A_vt_adjoint(const Eigen::VectorXcd& p) const {
  return transpose_times(G, A_vg.adjoint() * p);
}

Eigen::MatrixXcd LinearFluid::flag_forcing(Complex lambda, Eigen::Index first,
                                           Eigen::Index count) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const SparseRows D = A_vd + lambda * A_vg;
  const Rows columns = G.middleCols(first, count);
  const Eigen::SparseMatrix<double, Eigen::RowMajor> real = D.real(), imag = D.imag();
  Eigen::MatrixXcd product(D.rows(), count);
  product.real() = Rows(real * columns);
  product.imag() = Rows(imag * columns);
  return product;
}

LinearFluid linear_fluid(const OGrid& grid, const BaseFlow& base, int nodes, double k_x) {
  return Assembly(grid, base, nodes, k_x)(grid, base);
}

}  // namespace pennon::modes::global
