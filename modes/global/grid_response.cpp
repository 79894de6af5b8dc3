#include "modes/global/grid_response.hpp"

#include <Eigen/SparseCore>
#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <array>

#include "modes/global/jacobian.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr int reach = 1;  // of a corner's equations, in rows and columns
constexpr int period = 2 * reach + 1;
constexpr std::array<double, 2> sign_below = {-1, 1};  // along y and z

// The inner corners with 0 <= theta <= pi.
class InnerCorners {
 public:
  explicit InnerCorners(const OGrid& grid)
      : elliptic_(grid),
        n_rho_(grid.n_rho()),
        n_theta_(grid.n_theta()),
        found_{std::vector<Complex>(corners()), std::vector<Complex>(corners())} {}

  int rows() const { return n_rho_ - 1; }
  int columns() const { return n_theta_ / 2 + 1; }
  Eigen::Index unknowns() const { return 2 * Eigen::Index{rows()} * columns(); }
  Eigen::Index index(int direction, int j, int i) const {
    return 2 * (Eigen::Index{j - 1} * columns() + i) + direction;
  }

  /// Moves a corner and the one below the flag that goes with it.
  template <class Scalar>
  void set(Displacement<Scalar>& d, int direction, int j, int i, const Scalar& value) const {
    Field<Scalar>& field = direction == 0 ? d.y : d.z;
    const int below = (n_theta_ - i) % n_theta_;
    field.row(0, j)[below] = sign_below[static_cast<std::size_t>(direction)] * value;
    field.row(0, j)[i] = below == i && direction == 0 ? Scalar(0) : value;
    field.wrap_theta(0, j, j + 1);
  }

  void evaluate(const Displacement<Complex>& d) {
    elliptic_.residual(0, d, found_[0].data(), found_[1].data());
  }
  // The derivative of the equation at a corner by what was stepped.
  double derivative(int direction, int j, int i) const {
    const auto corner = static_cast<std::size_t>(j - 1) * static_cast<std::size_t>(n_theta_) +
                        static_cast<std::size_t>(i);
    return found_[static_cast<std::size_t>(direction)][corner].imag() / complex_step;
  }
  // On the axis the displacement along y is 0 by symmetry, and its equation void.
  bool is_void(int direction, int i) const {
    return direction == 0 && (i == 0 || i == columns() - 1);
  }

 private:
  std::size_t corners() const {
    return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(n_theta_);
  }

  dns::EllipticGrid elliptic_;
  int n_rho_, n_theta_;
  std::array<std::vector<Complex>, 2> found_;
};

Eigen::SparseMatrix<double> matrix_of(InnerCorners& corners, const Extent& extent) {
  std::vector<Eigen::Triplet<double>> entries;
  Displacement<Complex> d(extent);
  const auto read = [&](int by, int j, int i) {
    for (int at_j = std::max(1, j - reach); at_j <= std::min(corners.rows(), j + reach); ++at_j)
      for (int at_i = std::max(0, i - reach); at_i <= std::min(corners.columns() - 1, i + reach);
           ++at_i)
        for (int of = 0; of < 2; ++of)
          if (!corners.is_void(of, at_i))
            entries.emplace_back(corners.index(of, at_j, at_i), corners.index(by, j, i),
                                 corners.derivative(of, at_j, at_i));
  };
  for (int by = 0; by < 2; ++by)
    for (int row = 1; row <= period; ++row)
      for (int column = 0; column < period; ++column) {
        const auto for_each_seed = [&](const auto& use) {
          for (int j = row; j <= corners.rows(); j += period)
            for (int i = column; i < corners.columns(); i += period)
              if (!corners.is_void(by, i)) use(j, i);
        };
        for_each_seed([&](int j, int i) { corners.set(d, by, j, i, Complex(0, complex_step)); });
        corners.evaluate(d);
        for_each_seed([&](int j, int i) { read(by, j, i); });
        for_each_seed([&](int j, int i) { corners.set(d, by, j, i, Complex(0)); });
      }
  for (int j = 1; j <= corners.rows(); ++j)
    for (const int i : {0, corners.columns() - 1})
      entries.emplace_back(corners.index(0, j, i), corners.index(0, j, i), 1);
  Eigen::SparseMatrix<double> matrix(corners.unknowns(), corners.unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

std::vector<Displacement<double>> grid_response(const OGrid& grid) {
  constexpr int along_z = 1;
  const Extent extent{1, grid.n_rho(), grid.n_theta()};
  InnerCorners corners(grid);
  const Eigen::SparseMatrix<double> matrix = matrix_of(corners, extent);  // the factors refer to it
  const Eigen::UmfPackLU<Eigen::SparseMatrix<double>> factors(matrix);
  std::vector<Displacement<double>> response;
  for (int node = 0; node <= grid.n_theta() / 2; ++node) {
    const int corner = grid.n_theta() / 2 - node;
    Displacement<Complex> d(extent);
    corners.set(d, along_z, 0, corner, Complex(0, complex_step));
    corners.evaluate(d);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(corners.unknowns());
    for (int i = 0; i < corners.columns(); ++i)
      for (int of = 0; of < 2; ++of)
        if (!corners.is_void(of, i)) right[corners.index(of, 1, i)] = -corners.derivative(of, 1, i);
    const Eigen::VectorXd inner = factors.solve(right);
    Displacement<double>& found = response.emplace_back(extent);
    corners.set(found, along_z, 0, corner, 1.0);
    for (int j = 1; j <= corners.rows(); ++j)
      for (int i = 0; i < corners.columns(); ++i)
        for (int of = 0; of < 2; ++of) corners.set(found, of, j, i, inner[corners.index(of, j, i)]);
  }
  return response;
}

}  // namespace pennon::modes::global
