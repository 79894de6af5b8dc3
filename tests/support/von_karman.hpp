/// The clamped square plate of von Karman's theory by another method than pennon's: Ritz, with
/// polynomials over the whole plate. Edges held in the plane and clamped; -1 <= x, y <= 1 maps to
/// the unit square.
#pragma once

#include <gsl/gsl_integration.h>

#include <Eigen/Dense>
#include <vector>

namespace pennon::test {

class RitzPlate {
 public:
  /// `terms` polynomials in each direction for each of w, u, v (even or odd ones, as the symmetry
  /// asks).
  RitzPlate(int terms, double K_B, double K_S, double nu_s)
      : terms_(terms), K_B_(K_B), K_S_(K_S), nu_s_(nu_s) {
    constexpr int points = 24;
    gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(points);
    for (std::size_t i = 0; i < points; ++i)
      for (std::size_t j = 0; j < points; ++j) {
        double x = 0, y = 0, w_x = 0, w_y = 0;
        gsl_integration_glfixed_point(-1, 1, i, &x, &w_x, table);
        gsl_integration_glfixed_point(-1, 1, j, &y, &w_y, table);
        points_.push_back(rows_at(x, y, w_x * w_y / 4));
      }
    gsl_integration_glfixed_table_free(table);
  }

  /// Deflection of the centre under the load q per area.
  double deflection(double q) const {
    const int n = 3 * terms_ * terms_;
    Eigen::VectorXd a = Eigen::VectorXd::Zero(n);
    for (int iteration = 0; iteration < 60; ++iteration) {
      Eigen::VectorXd gradient = Eigen::VectorXd::Zero(n);
      Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(n, n);
      for (const Point& p : points_) add(p, q, a, gradient, hessian);
      const Eigen::VectorXd change = hessian.ldlt().solve(gradient);
      a -= change;
      if (change.norm() < 1e-13 * (1 + a.norm())) break;
    }
    return a.dot(rows_at(0, 0, 0).w);
  }

 private:
  struct Point {
    double area;
    Eigen::VectorXd w, w_x, w_y, w_xx, w_yy, w_xy, u_x, v_y, u_y_v_x;
  };

  // (1 - s^2)^power s^k with its first two derivatives by the coordinate of the unit square, s = 2
  // X - 1.
  static Eigen::Vector3d factor(int power, int k, double s) {
    std::vector<double> c(static_cast<std::size_t>(k + 2 * power + 1), 0.0);
    const auto at = [&](int i) -> double& { return c[static_cast<std::size_t>(i)]; };
    at(k) = 1;
    for (int r = 0; r < power; ++r)
      for (int i = static_cast<int>(c.size()) - 1; i >= 2; --i) at(i) -= at(i - 2);
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    for (int i = 0; i < static_cast<int>(c.size()); ++i) {
      value[0] += at(i) * std::pow(s, i);
      if (i > 0) value[1] += 2 * i * at(i) * std::pow(s, i - 1);
      if (i > 1) value[2] += 4 * i * (i - 1) * at(i) * std::pow(s, i - 2);
    }
    return value;
  }

  Point rows_at(double x, double y, double area) const {
    const int n = 3 * terms_ * terms_;
    Point p{area, {}, {}, {}, {}, {}, {}, {}, {}, {}};
    for (Eigen::VectorXd* row :
         {&p.w, &p.w_x, &p.w_y, &p.w_xx, &p.w_yy, &p.w_xy, &p.u_x, &p.v_y, &p.u_y_v_x})
      row->setZero(n);
    for (int i = 0; i < terms_; ++i)
      for (int j = 0; j < terms_; ++j) {
        const int w = i * terms_ + j;
        const int u = terms_ * terms_ + w;
        const int v = 2 * terms_ * terms_ + w;
        const Eigen::Vector3d fx = factor(2, 2 * i, x), fy = factor(2, 2 * j, y);
        p.w[w] = fx[0] * fy[0];
        p.w_x[w] = fx[1] * fy[0];
        p.w_y[w] = fx[0] * fy[1];
        p.w_xx[w] = fx[2] * fy[0];
        p.w_yy[w] = fx[0] * fy[2];
        p.w_xy[w] = fx[1] * fy[1];
        const Eigen::Vector3d ux = factor(1, 2 * i + 1, x), uy = factor(1, 2 * j, y);
        p.u_x[u] = ux[1] * uy[0];
        p.u_y_v_x[u] = ux[0] * uy[1];
        const Eigen::Vector3d vx = factor(1, 2 * i, x), vy = factor(1, 2 * j + 1, y);
        p.v_y[v] = vx[0] * vy[1];
        p.u_y_v_x[v] = vx[1] * vy[0];
      }
    return p;
  }

  void add(const Point& p, double q, const Eigen::VectorXd& a, Eigen::VectorXd& gradient,
           Eigen::MatrixXd& hessian) const {
    const double s_x = a.dot(p.w_x), s_y = a.dot(p.w_y);
    const double e_1 = a.dot(p.u_x) + s_x * s_x / 2, e_2 = a.dot(p.v_y) + s_y * s_y / 2;
    const double g = a.dot(p.u_y_v_x) + s_x * s_y;
    const Eigen::VectorXd d_1 = p.u_x + s_x * p.w_x, d_2 = p.v_y + s_y * p.w_y;
    const Eigen::VectorXd d_g = p.u_y_v_x + s_x * p.w_y + s_y * p.w_x;
    const double T_1 = K_S_ * (e_1 + nu_s_ * e_2), T_2 = K_S_ * (e_2 + nu_s_ * e_1);
    const double M = K_S_ * (1 - nu_s_) / 2 * g;
    const Eigen::VectorXd laplacian = p.w_xx + p.w_yy;
    gradient +=
        p.area * (T_1 * d_1 + T_2 * d_2 + M * d_g + K_B_ * a.dot(laplacian) * laplacian - q * p.w);
    hessian += p.area * (K_S_ * (d_1 * d_1.transpose() + d_2 * d_2.transpose() +
                                 nu_s_ * (d_1 * d_2.transpose() + d_2 * d_1.transpose()) +
                                 (1 - nu_s_) / 2 * d_g * d_g.transpose()) +
                         T_1 * p.w_x * p.w_x.transpose() + T_2 * p.w_y * p.w_y.transpose() +
                         M * (p.w_x * p.w_y.transpose() + p.w_y * p.w_x.transpose()) +
                         K_B_ * laplacian * laplacian.transpose());
  }

  int terms_;
  double K_B_, K_S_, nu_s_;
  std::vector<Point> points_;
};

}  // namespace pennon::test
