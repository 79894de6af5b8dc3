#include "dns/grid/elliptic_grid.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace pennon::dns {
namespace {

constexpr int depth_of_acceleration = 16;
constexpr int passes_without_acceleration = 2;
constexpr int most_cuts = 10;
constexpr int most_parts = 256;
constexpr int most_passes_of_part = 200;
constexpr double coarse_tolerance = 1e-4;

// The derivatives of the position, the left side of the equation, and what it is divided by.
template <class Scalar>
struct Corner {
  Scalar y_rho, z_rho, y_theta, z_theta;
  Scalar y, z, size;
};

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

// About the edges of the flag the frame turns and stretches from corner to corner. On the grid at
// rest, with central differences of steps h_rho and h_theta, L then becomes
//   (1 - h_rho^2 kappa) e_rhorho + (1 + h_theta^2 kappa) e_thetatheta,   kappa = coth(rho + i
//   theta)^2.
// The weights bring the mean of its coefficients back to 1.
Eigen::VectorXd edge_weights(const OGrid& grid) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(grid.n_rho() - 1) * grid.n_theta());
  double* weight = weights.data();
  for (int j = 1; j < grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const double h_rho = grid.rho_face_step(j), h_theta = grid.theta_face_step(i);
      const std::complex<double> tanh = std::tanh(std::complex(grid.rho(j), grid.theta(i)));
      const std::complex<double> kappa = 1.0 / (tanh * tanh);
      *weight++ =
          2 / (std::abs(1.0 - h_rho * h_rho * kappa) + std::abs(1.0 + h_theta * h_theta * kappa));
    }
  return weights;
}

}  // namespace

EllipticGrid::Differences EllipticGrid::differences(double before, double behind) {
  const double sum = before + behind;
  return {behind / (before * sum), before / (behind * sum), -2 / (before * sum),
          2 / (behind * sum)};
}

EllipticGrid::EllipticGrid(const OGrid& grid)
    : grid_(grid),
      flat_(flat_operator(grid)),
      corners_(2 * (grid.n_rho() - 1) * grid.n_theta()),
      change_(corners_.size()),
      before_(corners_.size()),
      r_rho_(corners_.size()),
      r_theta_(corners_.size()),
      weight_(edge_weights(grid)),
      part_y_(static_cast<std::size_t>(grid.n_theta())),
      part_z_(part_y_.size()),
      acceleration_(corners_.size(), depth_of_acceleration) {
  for (int j = 1; j < grid.n_rho(); ++j)
    along_rho_.push_back(differences(grid.rho_step(j - 1), grid.rho_step(j)));
  for (int i = 0; i < grid.n_theta(); ++i) {
    const Differences theta =
        differences(grid.theta_step((i + grid.n_theta() - 1) % grid.n_theta()), grid.theta_step(i));
    first_before_.push_back(theta.first_before);
    first_behind_.push_back(theta.first_behind);
    second_before_.push_back(theta.second_before);
    second_behind_.push_back(theta.second_behind);
  }
}

// use(k, corner): k counts the inner corners.
template <class Scalar, class Use>
void EllipticGrid::for_each_corner(int plane, const Displacement<Scalar>& displacement,
                                   const Use& use) const {
  const int n_theta = grid_.n_theta();
  const double *cos = grid_.along_theta().cos.data(), *sin = grid_.along_theta().sin.data();
  const double *first_before = first_before_.data(), *first_behind = first_behind_.data();
  const double *second_before = second_before_.data(), *second_behind = second_behind_.data();
  for (int j = 1; j < grid_.n_rho(); ++j) {
    const Differences rho = along_rho_[static_cast<std::size_t>(j - 1)];
    const double cosh = grid_.along_rho().cosh[static_cast<std::size_t>(j)] / 2;
    const double sinh = grid_.along_rho().sinh[static_cast<std::size_t>(j)] / 2;
    const Scalar *y0 = displacement.y.row(plane, j - 1), *y1 = displacement.y.row(plane, j),
                 *y2 = displacement.y.row(plane, j + 1);
    const Scalar *z0 = displacement.z.row(plane, j - 1), *z1 = displacement.z.row(plane, j),
                 *z2 = displacement.z.row(plane, j + 1);
    const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(j - 1) * n_theta;
#pragma GCC ivdep
    for (int i = 0; i < n_theta; ++i) {
      const auto by_theta = [&](const Scalar* f) -> Scalar {
        return first_before[i] * (f[i] - f[i - 1]) + first_behind[i] * (f[i + 1] - f[i]);
      };
      const auto by_theta_twice = [&](const Scalar* f) -> Scalar {
        return second_before[i] * (f[i] - f[i - 1]) + second_behind[i] * (f[i + 1] - f[i]);
      };
      const auto by_rho = [&](Scalar below, Scalar here, Scalar above) -> Scalar {
        return rho.first_before * (here - below) + rho.first_behind * (above - here);
      };
      const auto by_rho_twice = [&](Scalar below, Scalar here, Scalar above) -> Scalar {
        return rho.second_before * (here - below) + rho.second_behind * (above - here);
      };
      // The derivatives of the displacement, and those of the conformal grid.
      const Scalar y_t1 = by_theta(y1), z_t1 = by_theta(z1);
      Corner<Scalar> at;
      at.y_rho = by_rho(y0[i], y1[i], y2[i]) + sinh * cos[i];
      at.z_rho = by_rho(z0[i], z1[i], z2[i]) + cosh * sin[i];
      at.y_theta = y_t1 - cosh * sin[i];
      at.z_theta = z_t1 + sinh * cos[i];
      const Scalar y_rhorho = by_rho_twice(y0[i], y1[i], y2[i]) + cosh * cos[i];
      const Scalar z_rhorho = by_rho_twice(z0[i], z1[i], z2[i]) + sinh * sin[i];
      const Scalar y_thetatheta = by_theta_twice(y1) - cosh * cos[i];
      const Scalar z_thetatheta = by_theta_twice(z1) - sinh * sin[i];
      const Scalar y_rhotheta = by_rho(by_theta(y0), y_t1, by_theta(y2)) - sinh * sin[i];
      const Scalar z_rhotheta = by_rho(by_theta(z0), z_t1, by_theta(z2)) + cosh * cos[i];
      const Scalar a = at.y_theta * at.y_theta + at.z_theta * at.z_theta;
      const Scalar b = at.y_rho * at.y_theta + at.z_rho * at.z_theta;
      const Scalar c = at.y_rho * at.y_rho + at.z_rho * at.z_rho;
      at.size = 0.5 * (a + c);
      at.y = a * y_rhorho - 2.0 * b * y_rhotheta + c * y_thetatheta;
      at.z = a * z_rhorho - 2.0 * b * z_rhotheta + c * z_thetatheta;
      use(row + i, at);
    }
  }
}

template <class Scalar>
void EllipticGrid::residual(int plane, const Displacement<Scalar>& displacement, Scalar* y,
                            Scalar* z) const {
  for_each_corner(plane, displacement, [=](std::ptrdiff_t k, const Corner<Scalar>& at) {
    y[k] = at.y / at.size;
    z[k] = at.z / at.size;
  });
}

template void EllipticGrid::residual(int, const Displacement<double>&, double*, double*) const;
template void EllipticGrid::residual(int, const Displacement<std::complex<double>>&,
                                     std::complex<double>*, std::complex<double>*) const;

void EllipticGrid::find_change(int plane, const Displacement<double>& displacement) {
  const Eigen::Index corners = change_.size() / 2;
  double *y = change_.data(), *z = y + corners;
  double *y_rho = r_rho_.data(), *z_rho = y_rho + corners;
  double *y_theta = r_theta_.data(), *z_theta = y_theta + corners;
  const double* weight = weight_.data();
  for_each_corner(plane, displacement, [=](std::ptrdiff_t k, const Corner<double>& at) {
    const double J = at.y_rho * at.z_theta - at.z_rho * at.y_theta;
    const double scale = weight[k] / (at.size * J);
    y[k] = scale * (at.y_theta * at.z - at.z_theta * at.y);
    z[k] = scale * (at.z_rho * at.y - at.y_rho * at.z);
    y_rho[k] = at.y_rho;
    z_rho[k] = at.z_rho;
    y_theta[k] = at.y_theta;
    z_theta[k] = at.z_theta;
  });
  flat_.solve(y);
  flat_.solve(z);
  for (Eigen::Index k = 0; k < corners; ++k) {
    const double along_rho = y[k], along_theta = z[k];
    y[k] = y_rho[k] * along_rho + y_theta[k] * along_theta;
    z[k] = z_rho[k] * along_rho + z_theta[k] * along_theta;
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
    find_change(plane, displacement);
    const double largest = change_.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    if (!std::isfinite(largest)) {
      summary.change = summary.least_area = std::numeric_limits<double>::quiet_NaN();
      break;
    }
    before_ = corners_;
    if (summary.passes > 0 && largest > 2 * summary.change) acceleration_.restart();
    if (summary.passes < passes_without_acceleration)
      corners_ += change_;
    else
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
  if (!(summary.least_area > 0)) find_worst_cell(plane, displacement, summary);
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
    summary.least_area = 1;
    for (int part = 1; part <= parts && summary.least_area > 0; ++part) {
      for (std::size_t i = 0; i < part_y_.size(); ++i) {
        part_y_[i] = y[i] * part / parts;
        part_z_[i] = z[i] * part / parts;
      }
      move_wall(plane, part_y_.data(), part_z_.data(), displacement);
      summary = relax(plane, displacement, part < parts ? coarse_tolerance : tolerance,
                      most_passes_of_part);
    }
  }
  return summary;
}

// The areas of a row of cells, over those at rest.
class EllipticGrid::RowOfAreas {
 public:
  RowOfAreas(const OGrid& grid, int plane, int j, const Displacement<double>& displacement)
      : y0_(displacement.y.row(plane, j)),
        y1_(displacement.y.row(plane, j + 1)),
        z0_(displacement.z.row(plane, j)),
        z1_(displacement.z.row(plane, j + 1)),
        cos_(grid.along_theta().cos_centre.data()),
        sin_(grid.along_theta().sin_centre.data()),
        cos_half_(grid.along_theta().cos_half_step.data()),
        sin_half_(grid.along_theta().sin_half_step.data()),
        cosh_(grid.along_rho().cosh_centre[static_cast<std::size_t>(j)]),
        sinh_(grid.along_rho().sinh_centre[static_cast<std::size_t>(j)]),
        cosh_half_(grid.along_rho().cosh_half_step[static_cast<std::size_t>(j)]),
        sinh_half_(grid.along_rho().sinh_half_step[static_cast<std::size_t>(j)]) {}

  // Half the cross product of the diagonals a and b, which at rest are
  // sinh(rho + i theta) sinh((+-d_rho + i d_theta)/2) at the centre.
  double operator[](int i) const {
    const double y = sinh_ * cos_[i], z = cosh_ * sin_[i];
    const double real = sinh_half_ * cos_half_[i], imag = cosh_half_ * sin_half_[i];
    const double a_y = y * real - z * imag, a_z = y * imag + z * real;
    const double b_y = -y * real - z * imag, b_z = y * imag - z * real;
    const double at_rest = a_y * b_z - a_z * b_y;
    const double area = (a_y + y1_[i + 1] - y0_[i]) * (b_z + z0_[i + 1] - z1_[i]) -
                        (a_z + z1_[i + 1] - z0_[i]) * (b_y + y0_[i + 1] - y1_[i]);
    return area / at_rest;
  }

 private:
  const double *y0_, *y1_, *z0_, *z1_, *cos_, *sin_, *cos_half_, *sin_half_;
  double cosh_, sinh_, cosh_half_, sinh_half_;
};

double EllipticGrid::least_area(int plane, const Displacement<double>& displacement) const {
  // The least of each column first, in blocks of columns: comparisons side by side.
  constexpr int block = 64;
  std::array<double, block> least;
  double least_of_all = std::numeric_limits<double>::infinity();
  for (int first = 0; first < grid_.n_theta(); first += block) {
    const int count = std::min(block, grid_.n_theta() - first);
    least.fill(std::numeric_limits<double>::infinity());
    for (int j = 0; j < grid_.n_rho(); ++j) {
      const RowOfAreas areas(grid_, plane, j, displacement);
      for (int i = 0; i < count; ++i) {
        const double area = areas[first + i];
        least[static_cast<std::size_t>(i)] =
            area < least[static_cast<std::size_t>(i)] ? area : least[static_cast<std::size_t>(i)];
      }
    }
    least_of_all = std::min(least_of_all, *std::min_element(least.begin(), least.end()));
  }
  return least_of_all;
}

double EllipticGrid::largest_wall_area(int plane, const Displacement<double>& displacement) const {
  const RowOfAreas areas(grid_, plane, 0, displacement);
  double largest = 0;
  for (int i = 0; i < grid_.n_theta(); ++i) largest = std::max(largest, areas[i]);
  return largest;
}

void EllipticGrid::find_worst_cell(int plane, const Displacement<double>& displacement,
                                   EllipticGridSummary& summary) const {
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j < grid_.n_rho(); ++j) {
    const RowOfAreas areas(grid_, plane, j, displacement);
    for (int i = 0; i < grid_.n_theta(); ++i) {
      if (areas[i] >= least) continue;
      least = areas[i];
      const std::complex<double> rest = OGrid::place(grid_.rho_centre(j), grid_.theta_centre(i));
      const auto middle = [&](const Field<double>& d) {
        const double *below = d.row(plane, j), *above = d.row(plane, j + 1);
        return (below[i] + below[i + 1] + above[i] + above[i + 1]) / 4;
      };
      summary.worst_y = rest.real() + middle(displacement.y);
      summary.worst_z = rest.imag() + middle(displacement.z);
    }
  }
}

}  // namespace pennon::dns
