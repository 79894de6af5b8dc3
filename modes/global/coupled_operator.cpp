#include "modes/global/coupled_operator.hpp"

#include <vector>

#include "modes/global/grid_response.hpp"
#include "modes/global/jacobian.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

class Assembly {
 public:
  Assembly(const OGrid& grid, const BaseFlow& base, const FlagOperator& flag, double k_x)
      : equations_(grid, base.parameters, base.q.components()),
        base_(complex_flow(base.q)),
        R_(base_.p.extent(), base_.components()),
        X_(R_),
        still_(base_.p.extent()),
        flag_(flag),
        result_{{},
                {},
                HalfPlane(base_.p.extent(), base_.components(), Symmetry::antisymmetric),
                flag.mass.size()},
        k_x_(k_x) {
    equations_.set_inflow(base.is_inflow);
  }

  CoupledOperator operator()(const OGrid& grid, const BaseFlow& base) {
    add_flow(base);
    const std::vector<Displacement<double>> response = grid_response(grid);
    const Eigen::Index held = static_cast<Eigen::Index>(response.size()) - result_.flag_nodes;
    for (Eigen::Index node = 0; node < result_.flag_nodes; ++node)
      add_motion(node, response[static_cast<std::size_t>(held + node)]);
    add_flag();
    const Eigen::Index n = result_.flow.unknowns() + 2 * result_.flag_nodes;
    result_.A.resize(n, n);
    result_.A.setFromTriplets(A_.begin(), A_.end());
    result_.B.resize(n, n);
    result_.B.setFromTriplets(B_.begin(), B_.end());
    return std::move(result_);
  }

 private:
  bool has_span() const { return base_.components() > 2; }

  void add(Eigen::Index row, Eigen::Index column, Complex value) {
    if (value != 0.0) A_.emplace_back(row, column, value);
  }

  void add_flow(const BaseFlow& base) {
    const Jacobian J = jacobian(equations_, base.q, result_.flow, has_span());
    const auto add_part = [&](const Eigen::SparseMatrix<double>& part, Complex factor) {
      for (int q = 0; q < part.outerSize(); ++q)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(part, q); entry; ++entry)
          add(entry.row(), q, -factor * entry.value());
    };
    add_part(J.in_plane, 1);
    add_part(J.along_x, Complex(0, k_x_));
    add_part(J.along_x_twice, -k_x_ * k_x_);
    for (int q = 0; q < J.force.outerSize(); ++q)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(J.force, q); entry; ++entry)
        add_force(entry.row(), q, entry.value());
    const Field<Complex>& volume = equations_.metrics().volume;
    result_.flow.for_each([&](int f, int j, int i, Eigen::Index k) {
      if (f < base_.components()) B_.emplace_back(k, k, volume.row(0, j)[i]);
    });
  }

  // A segment's force along z, to its two nodes in halves.
  void add_force(Eigen::Index segment, Eigen::Index column, Complex value) {
    const Eigen::Index held = base_.p.extent().n_theta / 2 + 1 - result_.flag_nodes;
    for (const Eigen::Index node : {segment - held, segment + 1 - held})
      if (node >= 0) add(result_.zeta_t(node), column, value / 2.0);
  }

  // What the last evaluation says, times `of_R` and `of_X`.
  void read(Eigen::Index column, Complex of_R, Complex of_X, bool with_force) {
    result_.flow.for_each([&](int f, int j, int i, Eigen::Index k) {
      Complex value = of_R * R_.field(f).row(0, j)[i].imag();
      if (has_span()) value += of_X * X_.field(f).row(0, j)[i].imag();
      add(k, column, -value / complex_step);
    });
    if (!with_force) return;
    const std::vector<Complex>& force = equations_.forces().z;
    for (std::size_t s = 0; s < force.size(); ++s)
      add_force(static_cast<Eigen::Index>(s), column, of_R * force[s].imag() / complex_step);
  }

  // The grid's displacement, its derivative along x and its velocity.
  void add_motion(Eigen::Index node, const Displacement<double>& response) {
    Displacement<Complex> step(base_.p.extent());
    for (std::size_t k = 0; k < response.y.values().size(); ++k) {
      step.y.values()[k] = Complex(0, complex_step * response.y.values()[k]);
      step.z.values()[k] = Complex(0, complex_step * response.z.values()[k]);
    }
    PlaneFlow<Complex>* X = has_span() ? &X_ : nullptr;
    const Complex ik(0, k_x_);
    equations_.set_grid(step, nullptr);
    equations_.evaluate(base_, nullptr, R_, X);
    read(result_.zeta(node), 1, -ik, true);
    if (has_span()) {
      equations_.set_grid(still_, &step);
      equations_.evaluate(base_, nullptr, R_, X);
      read(result_.zeta(node), ik, -ik * ik, true);
    }
    equations_.set_grid(still_, nullptr);
    equations_.set_grid_velocity(step);
    equations_.evaluate(base_, nullptr, R_, X);
    read(result_.zeta_t(node), 1, -ik, true);
    equations_.set_grid_velocity(still_);
  }

  void add_flag() {
    for (Eigen::Index p = 0; p < result_.flag_nodes; ++p) {
      add(result_.zeta(p), result_.zeta_t(p), 1);
      B_.emplace_back(result_.zeta(p), result_.zeta(p), 1);
      B_.emplace_back(result_.zeta_t(p), result_.zeta_t(p), flag_.mass[p]);
      for (Eigen::Index q = 0; q < result_.flag_nodes; ++q)
        add(result_.zeta_t(p), result_.zeta(q), -flag_.stiffness(p, q));
    }
  }

  PlaneEquations<Complex> equations_;
  PlaneFlow<Complex> base_, R_, X_;
  Displacement<Complex> still_;
  const FlagOperator& flag_;
  CoupledOperator result_;
  double k_x_;
  std::vector<Eigen::Triplet<Complex>> A_, B_;
};

}  // namespace

CoupledOperator coupled_operator(const OGrid& grid, const BaseFlow& base, const FlagOperator& flag,
                                 double k_x) {
  return Assembly(grid, base, flag, k_x)(grid, base);
}

}  // namespace pennon::modes::global
