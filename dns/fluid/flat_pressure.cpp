#include "dns/fluid/flat_pressure.hpp"

#include <cmath>

namespace pennon::dns {
namespace {

// Each cell's divided by sR_j sTheta_i: see metrics.cpp for these.
SeparableSolver solver_of(const OGrid& grid, double k) {
  const int n_rho = grid.n_rho(), n_theta = grid.n_theta();
  Tridiagonal along_rho{Eigen::VectorXd::Zero(n_rho), Eigen::VectorXd(n_rho),
                        Eigen::VectorXd::Zero(n_rho)};
  for (int j = 0; j < n_rho; ++j) {
    const double sR = 2 * std::sinh(grid.rho_step(j) / 2);
    const double below = j > 0 ? 1 / grid.rho_face_step(j) : 0;
    const double above = 1 / grid.rho_face_step(j + 1);
    along_rho.lower[j] = below / sR;
    along_rho.upper[j] = j + 1 < n_rho ? above / sR : 0;
    const double outer = j + 1 < n_rho ? 1 : 2;  // p = 0 on the face
    along_rho.diagonal[j] =
        -(below + outer * above) / sR - k * k / 4 * std::pow(std::sinh(grid.rho_centre(j)), 2);
  }
  Eigen::VectorXd S(n_theta);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n_theta, n_theta);
  for (int i = 0; i < n_theta; ++i) {
    S[i] = 2 * std::sin(grid.theta_step(i) / 2);
    const double before = 1 / grid.theta_face_step(i), behind = 1 / grid.theta_face_step(i + 1);
    A(i, (i + n_theta - 1) % n_theta) += before;
    A(i, (i + 1) % n_theta) += behind;
    A(i, i) -= before + behind + S[i] * k * k / 4 * std::pow(std::sin(grid.theta_centre(i)), 2);
  }
  return {along_rho, ThetaBasis(S, A, k == 0 && grid.is_theta_uniform())};
}

}  // namespace

FlatPressure::FlatPressure(const OGrid& grid, double k)
    : solver_(solver_of(grid, k)), inverse_area_(grid.n_rho(), grid.n_theta()) {
  for (int j = 0; j < grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i)
      inverse_area_(j, i) =
          1 / (4 * std::sinh(grid.rho_step(j) / 2) * std::sin(grid.theta_step(i) / 2));
}

void FlatPressure::solve(double* values) {
  Eigen::Map<Eigen::ArrayXd>(values, inverse_area_.size()) *=
      Eigen::Map<const Eigen::ArrayXd>(inverse_area_.data(), inverse_area_.size());
  solver_.solve(values);
}

}  // namespace pennon::dns
