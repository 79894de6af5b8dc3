/// The O-grid of a section x = const about the flag at rest:
///
///   y + i z = 1/2 + 1/2 cosh(rho + i theta),     0 <= rho <= asinh(2 R),  0 <= theta < 2 pi.
///
/// rho = 0 is the flag (0 <= y <= 1, z = 0), theta = 0 its trailing edge, theta = pi its leading
/// edge; theta < pi is the upper side. The map is conformal: |d(y + i z)/d(rho + i theta)|^2 =
/// (sinh^2 rho + sin^2 theta)/4. It takes up the square-root singularities of the two edges, which
/// lie on corners of cells. The outer boundary is at the distance R from mid-chord.
///
/// The wall spacing grows by a constant ratio in rho; theta may be drawn toward the wake.
#pragma once

#include <complex>
#include <vector>

namespace pennon::dns {

struct OGridSettings {
  int n_rho = 60;
  int n_theta = 120;             ///< even
  double R = 8;                  ///< outer radius, in L
  double wall_spacing = 0.012;   ///< of rho at the flag
  double wake_clustering = 0.0;  ///< b of theta = t - b sin t, 0 <= b < 1: denser about theta = 0
};

/// Functions of rho that the moving grid asks for again and again: at the corners j = 0 .. n_rho,
/// at the centres, of half a cell's step. `step` and `face_step` are OGrid's.
struct RhoTable {
  std::vector<double> cosh, sinh, cosh_centre, sinh_centre, cosh_half_step, sinh_half_step;
  std::vector<double> step, face_step;
};

/// The same of theta: at the corners i = 0 .. n_theta, at the centres, of half a cell's step.
struct ThetaTable {
  std::vector<double> cos, sin, cos_centre, sin_centre, cos_half_step, sin_half_step;
  std::vector<double> step, face_step;
};

class OGrid {
 public:
  /// Throws InputError if no growth of the spacing reaches R with n_rho cells.
  explicit OGrid(const OGridSettings&);

  int n_rho() const { return settings_.n_rho; }
  int n_theta() const { return settings_.n_theta; }
  const OGridSettings& settings() const { return settings_; }

  /// Of corners, j = 0 .. n_rho, i = 0 .. n_theta.
  double rho(int j) const { return rho_[static_cast<std::size_t>(j)]; }
  double theta(int i) const { return theta_[static_cast<std::size_t>(i)]; }
  /// Of cell centres: midpoints.
  double rho_centre(int j) const { return (rho(j) + rho(j + 1)) / 2; }
  double theta_centre(int i) const { return (theta(i) + theta(i + 1)) / 2; }
  /// d rho/d(index) and d theta/d(index): in the cells, and between the centres across the faces.
  /// At the wall as the one-sided difference of second order takes it, at the outer boundary twice
  /// the distance to the centre of the cell.
  double rho_step(int j) const { return rho(j + 1) - rho(j); }
  double theta_step(int i) const { return theta(i + 1) - theta(i); }
  double rho_face_step(int j) const;
  double theta_face_step(int i) const;  ///< i = 0 .. n_theta, periodic

  const RhoTable& along_rho() const { return along_rho_; }
  const ThetaTable& along_theta() const { return along_theta_; }

  /// The ratio by which the spacing of rho grows from cell to cell.
  double growth() const { return growth_; }
  bool is_theta_uniform() const { return settings_.wake_clustering == 0; }

  /// The place y + i z of a point, and its derivative by rho + i theta.
  static std::complex<double> place(double rho, double theta);
  static std::complex<double> slope(double rho, double theta);

 private:
  OGridSettings settings_;
  double growth_ = 1;
  std::vector<double> rho_, theta_;
  RhoTable along_rho_;
  ThetaTable along_theta_;
};

}  // namespace pennon::dns
