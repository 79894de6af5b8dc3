#include "dns/elliptic_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pennon::dns {
namespace {

constexpr int depth_of_acceleration = 8;
constexpr int most_cuts = 10;
constexpr int most_parts = 256;
constexpr int most_passes_of_part = 200;
constexpr double coarse_tolerance = 1e-4;

// d_rho^2 + d_theta^2 at the inner corners.
SeparableSolver flat_operator(const OGrid& grid) {
  const int n_rho = grid.n_rho(), n_theta = grid.n_theta();
  Tridiagonal along_rho{Eigen::VectorXd(n_rho - 1), Eigen::VectorXd(n_rho - 1),
                        Eigen::VectorXd(n_rho - 1)};
  for (int j = 1; j < n_rho; ++j) {
    const double before = grid.rho_step(j - 1), behind = grid.rho_step(j);
    along_rho.lower[j - 1] = 2 / (before * (before + behind));
    along_rho.upper[j - 1] = 2 / (behind * (before + behind));
    along_rho.diagonal[j - 1] = -2 / (before * behind);
  }
  Eigen::VectorXd S(n_theta);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n_theta, n_theta);
  for (int i = 0; i < n_theta; ++i) {
    const int before = (i + n_theta - 1) % n_theta, behind = (i + 1) % n_theta;
    S[i] = (grid.theta_step(before) + grid.theta_step(i)) / 2;
    A(i, before) += 1 / grid.theta_step(before);
    A(i, behind) += 1 / grid.theta_step(i);
    A(i, i) -= 1 / grid.theta_step(before) + 1 / grid.theta_step(i);
  }
  return {along_rho, ThetaBasis(S, A, grid.is_theta_uniform())};
}

}  // namespace

EllipticGrid::Differences EllipticGrid::differences(double before, double behind) {
  const double sum = before + behind;
  return {
      {-behind / (before * sum), (behind - before) / (before * behind), before / (behind * sum)},
      {2 / (before * sum), -2 / (before * behind), 2 / (behind * sum)}};
}

EllipticGrid::EllipticGrid(const OGrid& grid)
    : grid_(grid),
      flat_(flat_operator(grid)),
      corners_(2 * (grid.n_rho() - 1) * grid.n_theta()),
      change_(corners_.size()),
      before_(corners_.size()),
      acceleration_(corners_.size(), depth_of_acceleration) {
  for (int j = 1; j < grid.n_rho(); ++j)
    along_rho_.push_back(differences(grid.rho_step(j - 1), grid.rho_step(j)));
  for (int i = 0; i < grid.n_theta(); ++i) {
    const Differences theta =
        differences(grid.theta_step((i + grid.n_theta() - 1) % grid.n_theta()), grid.theta_step(i));
    for (std::size_t k = 0; k < 3; ++k) {
      theta_first_[k].push_back(theta.first[k]);
      theta_second_[k].push_back(theta.second[k]);
    }
    cos_theta_.push_back(std::cos(grid.theta(i)));
    sin_theta_.push_back(std::sin(grid.theta(i)));
    cos_centre_.push_back(std::cos(grid.theta_centre(i)));
    sin_centre_.push_back(std::sin(grid.theta_centre(i)));
    cos_half_step_.push_back(std::cos(grid.theta_step(i) / 2));
    sin_half_step_.push_back(std::sin(grid.theta_step(i) / 2));
  }
}

void EllipticGrid::residual(int plane, const Displacement<double>& displacement, double* y,
                            double* z) const {
  const int n_theta = grid_.n_theta();
  const double *cos = cos_theta_.data(), *sin = sin_theta_.data();
  const double *before1 = theta_first_[0].data(), *middle1 = theta_first_[1].data(),
               *behind1 = theta_first_[2].data();
  const double *before2 = theta_second_[0].data(), *middle2 = theta_second_[1].data(),
               *behind2 = theta_second_[2].data();
  for (int j = 1; j < grid_.n_rho(); ++j) {
    const Differences& rho = along_rho_[static_cast<std::size_t>(j - 1)];
    const double cosh = std::cosh(grid_.rho(j)) / 2, sinh = std::sinh(grid_.rho(j)) / 2;
    const auto along_rho = [](const double(&weights)[3], double below, double here, double above) {
      return weights[0] * below + weights[1] * here + weights[2] * above;
    };
    const double *y0 = displacement.y.row(plane, j - 1), *y1 = displacement.y.row(plane, j),
                 *y2 = displacement.y.row(plane, j + 1);
    const double *z0 = displacement.z.row(plane, j - 1), *z1 = displacement.z.row(plane, j),
                 *z2 = displacement.z.row(plane, j + 1);
    double* out_y = y + static_cast<std::ptrdiff_t>(j - 1) * n_theta;
    double* out_z = z + static_cast<std::ptrdiff_t>(j - 1) * n_theta;
    for (int i = 0; i < n_theta; ++i) {
      const auto first = [&](const double* f) {
        return before1[i] * f[i - 1] + middle1[i] * f[i] + behind1[i] * f[i + 1];
      };
      const auto second = [&](const double* f) {
        return before2[i] * f[i - 1] + middle2[i] * f[i] + behind2[i] * f[i + 1];
      };
      // The derivatives of the displacement, and those of the conformal grid.
      const double y_rho = along_rho(rho.first, y0[i], y1[i], y2[i]) + sinh * cos[i];
      const double z_rho = along_rho(rho.first, z0[i], z1[i], z2[i]) + cosh * sin[i];
      const double y_theta = first(y1) - cosh * sin[i];
      const double z_theta = first(z1) + sinh * cos[i];
      const double y_rhorho = along_rho(rho.second, y0[i], y1[i], y2[i]) + cosh * cos[i];
      const double z_rhorho = along_rho(rho.second, z0[i], z1[i], z2[i]) + sinh * sin[i];
      const double y_thetatheta = second(y1) - cosh * cos[i];
      const double z_thetatheta = second(z1) - sinh * sin[i];
      const double y_rhotheta =
          along_rho(rho.first, first(y0), first(y1), first(y2)) - sinh * sin[i];
      const double z_rhotheta =
          along_rho(rho.first, first(z0), first(z1), first(z2)) + cosh * cos[i];
      const double a = y_theta * y_theta + z_theta * z_theta;
      const double b = y_rho * y_theta + z_rho * z_theta;
      const double c = y_rho * y_rho + z_rho * z_rho;
      const double scale = 2 / (a + c);
      out_y[i] = scale * (a * y_rhorho - 2 * b * y_rhotheta + c * y_thetatheta);
      out_z[i] = scale * (a * z_rhorho - 2 * b * z_rhotheta + c * z_thetatheta);
    }
  }
}

void EllipticGrid::move_wall(int plane, const double* y, const double* z,
                             Displacement<double>& displacement) const {
  const auto move = [&](Field<double>& d, const double* wall) {
    const std::vector<double> before(d.row(plane, 0), d.row(plane, 0) + grid_.n_theta());
    for (int j = 0; j < grid_.n_rho(); ++j) {
      // Its derivative vanishes at the flag: a tip moved without what is about it would fold.
      const double share = (1 + grid_.rho(j)) * std::exp(-grid_.rho(j));
      double* row = d.row(plane, j);
      for (int i = 0; i < grid_.n_theta(); ++i)
        row[i] += share * (wall[i] - before[static_cast<std::size_t>(i)]);
    }
    d.wrap_theta(plane, 0, grid_.n_rho() + 1);
  };
  move(displacement.y, y);
  move(displacement.z, z);
}

EllipticGridSummary EllipticGrid::relax(int plane, Displacement<double>& displacement,
                                        double tolerance, int most_passes) {
  const int n_rho = grid_.n_rho(), n_theta = grid_.n_theta();
  const Eigen::Index corners = change_.size() / 2;
  const auto copy = [&](Field<double>& d, double* packed, bool to_field) {
    for (int j = 1; j < n_rho; ++j, packed += n_theta) {
      double* row = d.row(plane, j);
      if (to_field)
        std::copy(packed, packed + n_theta, row);
      else
        std::copy(row, row + n_theta, packed);
    }
    if (to_field) d.wrap_theta(plane, 1, n_rho);
  };
  copy(displacement.y, corners_.data(), false);
  copy(displacement.z, corners_.data() + corners, false);
  acceleration_.restart();
  EllipticGridSummary summary;
  summary.least_area = least_area(plane, displacement);
  while (summary.passes < most_passes) {
    residual(plane, displacement, change_.data(), change_.data() + corners);
    flat_.solve(change_.data());
    flat_.solve(change_.data() + corners);
    change_ = -change_;
    before_ = corners_;
    const double largest = change_.cwiseAbs().maxCoeff();
    if (summary.passes > 0 && largest > 2 * summary.change) acceleration_.restart();
    acceleration_.advance(corners_, change_);
    const auto area_there = [&] {
      copy(displacement.y, corners_.data(), true);
      copy(displacement.z, corners_.data() + corners, true);
      return least_area(plane, displacement);
    };
    // The cells at the flag's edges are so small that a pass can fold them: it is then cut.
    double area = area_there();
    for (int cut = 1; area < summary.least_area / 2 && cut <= most_cuts; ++cut) {
      acceleration_.restart();
      corners_ = before_ + std::ldexp(1.0, -cut) * change_;
      area = area_there();
    }
    summary.least_area = area;
    summary.change = largest;
    ++summary.passes;
    if (largest <= tolerance || area <= 0) break;
  }
  return summary;
}

EllipticGridSummary EllipticGrid::follow(int plane, const double* y, const double* z,
                                         Displacement<double>& displacement, double tolerance,
                                         int most_passes) {
  const int n_rho = grid_.n_rho(), n_theta = grid_.n_theta();
  move_wall(plane, y, z, displacement);
  EllipticGridSummary summary = relax(plane, displacement, tolerance, most_passes);
  if (summary.least_area > 0) return summary;
  // Too far at once: from the grid at rest, in ever smaller parts.
  for (int parts = 4; parts <= most_parts && summary.least_area <= 0; parts *= 4) {
    for (int j = 0; j <= n_rho; ++j)
      for (Field<double>* d : {&displacement.y, &displacement.z})
        std::fill_n(d->row(plane, j) - Field<double>::ghosts, n_theta + 2 * Field<double>::ghosts,
                    0.0);
    std::vector<double> part_y(static_cast<std::size_t>(n_theta)), part_z(part_y.size());
    summary.least_area = 1;
    for (int part = 1; part <= parts && summary.least_area > 0; ++part) {
      for (std::size_t i = 0; i < part_y.size(); ++i) {
        part_y[i] = y[i] * part / parts;
        part_z[i] = z[i] * part / parts;
      }
      move_wall(plane, part_y.data(), part_z.data(), displacement);
      summary = relax(plane, displacement, part < parts ? coarse_tolerance : tolerance,
                      most_passes_of_part);
    }
  }
  return summary;
}

double EllipticGrid::least_area(int plane, const Displacement<double>& displacement) const {
  double least = std::numeric_limits<double>::infinity();
  const int n_theta = grid_.n_theta();
  for (int j = 0; j < grid_.n_rho(); ++j) {
    const double *y0 = displacement.y.row(plane, j), *y1 = displacement.y.row(plane, j + 1);
    const double *z0 = displacement.z.row(plane, j), *z1 = displacement.z.row(plane, j + 1);
    const double mean = std::cosh(grid_.rho_centre(j)), half = std::sinh(grid_.rho_centre(j));
    const double cosh = std::cosh(grid_.rho_step(j) / 2), sinh = std::sinh(grid_.rho_step(j) / 2);
    // The diagonals at rest: sinh(zeta_c) sinh((d_rho + i d_theta)/2) and its like.
    const auto rest = [&](int i, double side) {
      const double cos = cos_centre_[static_cast<std::size_t>(i)];
      const double sin = sin_centre_[static_cast<std::size_t>(i)];
      const double c = cos_half_step_[static_cast<std::size_t>(i)];
      const double s = sin_half_step_[static_cast<std::size_t>(i)];
      const std::complex<double> at(half * cos, mean * sin);
      return at * std::complex<double>(side * sinh * c, cosh * s);
    };
    for (int i = 0; i < n_theta; ++i) {
      const std::complex<double> a = rest(i, 1), b = rest(i, -1);
      const double area_at_rest = a.real() * b.imag() - a.imag() * b.real();
      const double area = (a.real() + y1[i + 1] - y0[i]) * (b.imag() + z0[i + 1] - z1[i]) -
                          (a.imag() + z1[i + 1] - z0[i]) * (b.real() + y0[i + 1] - y1[i]);
      least = std::min(least, area / area_at_rest);
    }
  }
  return least;
}

}  // namespace pennon::dns
