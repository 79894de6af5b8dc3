#include "modes/global/equations/grid_response.hpp"

#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <array>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr int corner_reach = 1;  // of a corner's equations, in rows and columns
constexpr int corner_period = 2 * corner_reach + 1;

// The linearised equations of the corners within the grid: the moving ones but for the flag's.
class InnerEquations {
 public:
  explicit InnerEquations(const OGrid& grid)
      : corners(Extent{1, grid.n_rho(), grid.n_theta()}),
        elliptic_(grid),
        columns_(grid.n_theta()),
        found_{std::vector<Complex>(equations()), std::vector<Complex>(equations())} {}

  const MovingCorners corners;

  Eigen::Index of_flag() const { return 2 * Eigen::Index{corners.columns()}; }  // before the others
  Eigen::Index unknowns() const { return corners.unknowns() - of_flag(); }
  Eigen::Index index(int direction, int j, int i) const {
    return corners.index(direction, j, i) - of_flag();
  }

  void evaluate(const Displacement<Complex>& d) {
    elliptic_.residual(0, d, found_[0].data(), found_[1].data());
  }
  // The derivative of the equation at a corner by what was stepped.
  double derivative(int direction, int j, int i) const {
    const auto corner = static_cast<std::size_t>(j - 1) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(i);
    return found_[static_cast<std::size_t>(direction)][corner].imag() / complex_step;
  }

 private:
  std::size_t equations() const {
    return static_cast<std::size_t>(corners.rows() - 1) * static_cast<std::size_t>(columns_);
  }

  dns::EllipticGrid elliptic_;
  int columns_;
  std::array<std::vector<Complex>, 2> found_;
};

// A row for each inner corner's displacement, a column for each moving corner's.
Eigen::SparseMatrix<double> matrix_of(InnerEquations& equations) {
  const MovingCorners& corners = equations.corners;
  std::vector<Eigen::Triplet<double>> entries;
  const auto read = [&](int by, int j, int i) {
    for (int at_j = std::max(1, j - corner_reach);
         at_j < std::min(corners.rows(), j + corner_reach + 1); ++at_j)
      for (int at_i = std::max(0, i - corner_reach);
           at_i < std::min(corners.columns(), i + corner_reach + 1); ++at_i)
        for (const int of : {MovingCorners::y_displacement, MovingCorners::z_displacement})
          if (!corners.is_void(of, at_i))
            entries.emplace_back(equations.index(of, at_j, at_i), corners.index(by, j, i),
                                 equations.derivative(of, at_j, at_i));
  };
  corners.for_each_step(
      corner_period, [&](const Displacement<Complex>& step) { equations.evaluate(step); }, read);
  for (int j = 1; j < corners.rows(); ++j)
    for (const int i : {0, corners.columns() - 1})
      entries.emplace_back(equations.index(MovingCorners::y_displacement, j, i),
                           corners.index(MovingCorners::y_displacement, j, i), 1);
  Eigen::SparseMatrix<double> matrix(equations.unknowns(), corners.unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Eigen::MatrixXd grid_response(const OGrid& grid, int nodes) {
  InnerEquations equations(grid);
  const MovingCorners& corners = equations.corners;
  const Eigen::SparseMatrix<double> matrix = matrix_of(equations);
  const Eigen::SparseMatrix<double> inner = matrix.rightCols(equations.unknowns());
  Eigen::UmfPackLU<Eigen::SparseMatrix<double>> factors;
  factors.umfpackControl()(UMFPACK_IRSTEP) =
      0;  // refinement changes nothing and takes twice the time
  factors.compute(inner);
  Eigen::MatrixXd response = Eigen::MatrixXd::Zero(corners.unknowns(), nodes);
  for (int node = 0; node < nodes; ++node) {
    const Eigen::Index at_flag = corners.wall_index(corners.columns() - nodes + node);
    response(at_flag, node) = 1;
    const Eigen::VectorXd right = -matrix.col(at_flag);
    response.col(node).tail(equations.unknowns()) = factors.solve(right);
  }
  return response;
}

}  // namespace pennon::modes::global
