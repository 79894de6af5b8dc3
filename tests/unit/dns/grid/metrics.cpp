/// Metrics of the moving grid: closed cells, exactness at the flag's edges, derivatives.
#include "dns/grid/metrics.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "tests/support/grids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using Complex = std::complex<double>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const OGridSettings uniform{30, 60, 8, 0.024, 0};
const OGridSettings near{60, 120, 2, 0.01, 0};
const OGridSettings near_clustered{60, 120, 2, 0.01, 0.5};
const OGridSettings clustered{30, 60, 8, 0.024, 0.5};

// A smooth map of the plane that leaves no line as it is.
Complex bent(Complex r, double x = 0) {
  const double y = r.real(), z = r.imag();
  return {y + 0.1 * std::sin(z + 0.3 * y + x), z + 0.2 * std::sin(0.9 * y - 0.2 * z + 2 * x)};
}
// Its derivative by x, for the displacement along a span.
Complex bent_by_x(Complex r, double x) {
  const double y = r.real(), z = r.imag();
  return {0.1 * std::cos(z + 0.3 * y + x), 0.4 * std::cos(0.9 * y - 0.2 * z + 2 * x)};
}
// Its derivative along (v + i w).
Complex bent_along(Complex r, Complex v) {
  const double y = r.real(), z = r.imag();
  return {v.real() + 0.1 * std::cos(z + 0.3 * y) * (v.imag() + 0.3 * v.real()),
          v.imag() + 0.2 * std::cos(0.9 * y - 0.2 * z) * (0.9 * v.real() - 0.2 * v.imag())};
}

Metrics<double> metrics_of(const OGrid& grid, const Displacement<double>& displacement,
                           const Displacement<double>* slope = nullptr) {
  Metrics<double> metrics(extent_of(grid), slope != nullptr);
  update_metrics(grid, 0, displacement, slope, metrics);
  return metrics;
}

Displacement<double> bent_slope(const OGrid& grid, double x) {
  return image_of(grid, [&](Complex r) { return r + bent_by_x(r, x); });
}

// f + i h g, ghosts too.
Displacement<Complex> stepped(const OGrid& grid, const Displacement<double>& f, double h,
                              const Displacement<double>& g) {
  Displacement<Complex> sum(extent_of(grid));
  for (std::size_t k = 0; k < sum.y.values().size(); ++k) {
    sum.y.values()[k] = {f.y.values()[k], h * g.y.values()[k]};
    sum.z.values()[k] = {f.z.values()[k], h * g.z.values()[k]};
  }
  return sum;
}

// The sum of a cell's area vectors, and of their lengths.
struct Closure {
  double sum, size;
};
Closure closure(const FaceMetrics<double>& rho, const FaceMetrics<double>& theta,
                Field<double> FaceMetrics<double>::*area, int j, int i) {
  const double below = (rho.*area).row(0, j)[i], above = (rho.*area).row(0, j + 1)[i];
  const double before = (theta.*area).row(0, j)[i], behind = (theta.*area).row(0, j)[i + 1];
  return {above - below + behind - before,
          std::abs(above) + std::abs(below) + std::abs(behind) + std::abs(before)};
}

TEST(Metrics, HaveAreasOfACellThatSumToZero) {
  for (const OGridSettings& settings : {uniform, clustered}) {
    const OGrid grid(settings);
    const Metrics<double> metrics =
        metrics_of(grid, image_of(grid, [](Complex r) { return bent(r); }));
    for (int j = 0; j < grid.n_rho(); ++j)
      for (int i = 0; i < grid.n_theta(); ++i)
        for (const auto area : {&FaceMetrics<double>::area_y, &FaceMetrics<double>::area_z}) {
          const Closure cell = closure(metrics.rho_faces, metrics.theta_faces, area, j, i);
          // Corners of the displacement, up to 0.5, are rounded too.
          ASSERT_NEAR(cell.sum, 0, 10 * epsilon * (cell.size + 0.5)) << j << ", " << i;
        }
  }
}

TEST(Metrics, HaveAreasAlongTheSpanThatMakeUpForTheChangeOfTheVolume) {
  constexpr double x = 0.4, h = 1e-30;  // of the complex step: without error
  const OGrid grid(clustered);
  const auto displacement = image_of(grid, [](Complex r) { return bent(r, x); });
  const auto slope = bent_slope(grid, x);
  const Metrics<double> metrics = metrics_of(grid, displacement, &slope);
  Metrics<Complex> along(extent_of(grid), false);
  update_metrics<Complex>(grid, 0, stepped(grid, displacement, h, slope), nullptr, along);
  double largest = 0;
  for (int j = 0; j < grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const double change = along.volume.row(0, j)[i].imag() / h;
      const Closure cell =
          closure(metrics.rho_faces, metrics.theta_faces, &FaceMetrics<double>::area_x, j, i);
      ASSERT_NEAR(cell.sum + change, 0, 10 * epsilon * (cell.size + 0.5)) << j << ", " << i;
      largest = std::max(largest, std::abs(change));
    }
  EXPECT_GT(largest, 1e-3);
}

TEST(Metrics, HaveTheVolumeOfTheStreamThatTheCellsFill) {
  // The cells' volumes differ from their polygons' by a part that does not depend on the motion.
  const OGrid grid(uniform);
  const Metrics<double> rest = metrics_of(grid, Displacement<double>(extent_of(grid)));
  const Metrics<double> moved = metrics_of(grid, image_of(grid, [](Complex r) { return bent(r); }));
  constexpr std::size_t columns = 61;
  std::vector<double> y(31 * columns), z(31 * columns);
  const auto polygon = [&](const Displacement<double>& displacement, int j, int i) {
    corners_of(grid, 0, displacement, y.data(), z.data());
    const auto at = [&](int row, int column) {
      const auto k = static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column);
      return Complex(y[k], z[k]);
    };
    const Complex a = at(j + 1, i + 1) - at(j, i), b = at(j, i + 1) - at(j + 1, i);
    return (std::conj(a) * b).imag() / 2;
  };
  const auto bending = image_of(grid, [](Complex r) { return bent(r); });
  const Displacement<double> none(extent_of(grid));
  for (const int j : {0, 3, 29})
    for (const int i : {0, 17, 30, 59}) {
      const double polygons = polygon(bending, j, i) - polygon(none, j, i);
      const double volumes = moved.volume.row(0, j)[i] - rest.volume.row(0, j)[i];
      EXPECT_NEAR(volumes, polygons, 100 * epsilon * (1 + std::abs(polygons))) << j << ", " << i;
      const double second_order =
          (std::pow(grid.rho_step(j), 2) + std::pow(grid.theta_step(i), 2)) / 4;
      EXPECT_NEAR(rest.volume.row(0, j)[i], polygon(none, j, i),
                  second_order * polygon(none, j, i));
    }
}

TEST(Metrics, SeparateOnTheFlatGrid) {
  for (const OGridSettings& settings : {uniform, clustered}) {
    const OGrid grid(settings);
    const Metrics<double> metrics = metrics_of(grid, Displacement<double>(extent_of(grid)));
    constexpr double roundoff = 20 * epsilon;
    for (int j = 0; j <= grid.n_rho(); ++j)
      for (int i = 0; i < grid.n_theta(); ++i) {
        const double along = 2 * std::sin(grid.theta_step(i) / 2) / grid.rho_face_step(j);
        EXPECT_NEAR(metrics.rho_faces.along.row(0, j)[i], along, roundoff * along);
        EXPECT_NEAR(metrics.rho_faces.across.row(0, j)[i], 0, roundoff);
      }
    for (int j = 0; j < grid.n_rho(); ++j)
      for (int i = 0; i <= grid.n_theta(); ++i) {
        const double along = 2 * std::sinh(grid.rho_step(j) / 2) / grid.theta_face_step(i);
        EXPECT_NEAR(metrics.theta_faces.along.row(0, j)[i], along, roundoff * along);
        EXPECT_NEAR(metrics.theta_faces.across.row(0, j)[i], 0, roundoff);
      }
    for (int j = 0; j < grid.n_rho(); ++j)
      for (int i = 0; i < grid.n_theta(); ++i) {
        const double volume = 4 * std::sinh(grid.rho_step(j) / 2) *
                              std::sin(grid.theta_step(i) / 2) *
                              std::norm(OGrid::slope(grid.rho_centre(j), grid.theta_centre(i)));
        EXPECT_NEAR(metrics.volume.row(0, j)[i], volume, roundoff * volume);
      }
  }
}

// What remains of grad s, grad t times the derivatives of the position in a cell of a bent grid;
// the largest over the cells.
double inverse_Jacobian_error(const OGrid& grid) {
  constexpr double x = 0.0;
  const auto slope = bent_slope(grid, x);
  const Metrics<double> m =
      metrics_of(grid, image_of(grid, [](Complex r) { return bent(r); }), &slope);
  double largest = 0;
  for (int j = 0; j < grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const double rho = grid.rho_centre(j), theta = grid.theta_centre(i);
      const Complex r = OGrid::place(rho, theta), Z = OGrid::slope(rho, theta);
      const Complex r_s = grid.rho_step(j) * bent_along(r, Z);
      const Complex r_t = grid.theta_step(i) * bent_along(r, Complex(0, 1) * Z);
      const Complex s(m.s_y.row(0, j)[i], m.s_z.row(0, j)[i]);
      const Complex t(m.t_y.row(0, j)[i], m.t_z.row(0, j)[i]);
      const auto dot = [](Complex a, Complex b) { return (std::conj(a) * b).real(); };
      const double aspect = std::abs(r_s) / std::abs(r_t);
      largest = std::max({largest, std::abs(dot(s, r_s) - 1), std::abs(dot(t, r_t) - 1),
                          std::abs(dot(s, r_t)) * aspect, std::abs(dot(t, r_s)) / aspect});
      // At fixed y and z, s(x, r(x, s, t)) does not change with x.
      const Complex r_xi = bent_by_x(r, x);
      largest = std::max({largest, std::abs(m.s_x.row(0, j)[i] + dot(s, r_xi)) * std::abs(r_s),
                          std::abs(m.t_x.row(0, j)[i] + dot(t, r_xi)) * std::abs(r_t)});
    }
  return largest;
}

// Of the area vectors' products with grad s and grad t, at the flag and at the outer boundary too,
// without a span or where the grid also bends along x. The area of a face across s is J grad s for
// one cell, with grad s = (-grad s . r_xi, grad s) along (x; y, z): from it, `along` is
// J |grad s|^2 and `across` J grad s . grad t.
double face_error(const OGrid& grid, bool has_span) {
  constexpr double x = 0;
  const auto slope = bent_slope(grid, x);
  const Metrics<double> m = metrics_of(grid, image_of(grid, [](Complex r) { return bent(r, x); }),
                                       has_span ? &slope : nullptr);
  double largest = 0;
  const auto compare = [&](double rho, double theta, double s_step, double t_step,
                           const FaceMetrics<double>& faces, int j, int i, bool across_rho) {
    const Complex r = OGrid::place(rho, theta), Z = OGrid::slope(rho, theta);
    const Complex r_s = s_step * bent_along(r, Z);
    const Complex r_t = t_step * bent_along(r, Complex(0, 1) * Z);
    const Complex r_xi = has_span ? bent_by_x(r, x) : 0;
    const auto cross = [](Complex a, Complex b) { return (std::conj(a) * b).imag(); };
    const double J = cross(r_s, r_t);
    using Gradient = Eigen::Vector3d;
    const Gradient s = Gradient(-cross(r_xi, r_t), r_t.imag(), -r_t.real()) / J;
    const Gradient t = Gradient(cross(r_xi, r_s), -r_s.imag(), r_s.real()) / J;
    const double exact = J * (across_rho ? s : t).squaredNorm();
    largest = std::max({largest, std::abs(faces.along.row(0, j)[i] / exact - 1),
                        std::abs(faces.across.row(0, j)[i] - J * s.dot(t))});
  };
  for (int j = 0; j <= grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i)
      compare(grid.rho(j), grid.theta_centre(i), grid.rho_face_step(j), grid.theta_step(i),
              m.rho_faces, j, i, true);
  for (int j = 0; j < grid.n_rho(); ++j)
    for (int i = 0; i <= grid.n_theta(); ++i)
      compare(grid.rho_centre(j), grid.theta(i), grid.rho_step(j), grid.theta_face_step(i),
              m.theta_faces, j, i, false);
  return largest;
}

template <class Error>
void expect_second_order(const Error& error) {
  for (const OGridSettings& settings : {near, near_clustered}) {
    OGrid grid(settings);
    double last = error(grid);
    for (int refinement = 0; refinement < 2; ++refinement) {
      grid = refined(grid);
      const double found = error(grid);
      EXPECT_NEAR(std::log2(last / found), 2, 0.2) << last << ", " << found;
      last = found;
    }
  }
}

TEST(Metrics, HaveTheInverseJacobianToSecondOrder) {
  expect_second_order(inverse_Jacobian_error);
}

TEST(Metrics, HaveTheGradientsAtTheFacesToSecondOrder) {
  expect_second_order([](const OGrid& grid) { return face_error(grid, false); });
}

TEST(Metrics, HaveTheGradientsAtTheFacesOfASpanThatBendsAlongXToSecondOrder) {
  expect_second_order([](const OGrid& grid) { return face_error(grid, true); });
}

// Areas over mean volumes would be wrong by a factor 20 there.
TEST(Metrics, AreRightNextToTheEdgesOfATurnedFlag) {
  const OGrid grid(uniform);
  const Metrics<double> rest = metrics_of(grid, Displacement<double>(extent_of(grid)));
  const Metrics<double> turned = metrics_of(
      grid, image_of(grid, [](Complex r) { return 0.5 + std::polar(1.0, 1.1) * (r - 0.5); }));
  const double second_order = std::pow(grid.theta_step(0), 2);
  for (const int edge : {0, grid.n_theta() / 2})
    for (const int j : {0, 1, 2}) {
      for (const int i : {edge, (edge + grid.n_theta() - 1) % grid.n_theta()}) {
        const double along = rest.rho_faces.along.row(0, j)[i];
        EXPECT_NEAR(turned.rho_faces.along.row(0, j)[i], along, second_order * along);
        EXPECT_NEAR(turned.rho_faces.across.row(0, j)[i], 0, second_order);
      }
      const double along = rest.theta_faces.along.row(0, j)[edge];
      EXPECT_NEAR(turned.theta_faces.along.row(0, j)[edge], along, second_order * along);
      EXPECT_NEAR(turned.theta_faces.across.row(0, j)[edge], 0, second_order);
    }
}

TEST(Metrics, GiveTheirDerivativeByAComplexStep) {
  constexpr double x = 0.4, h = 1e-30, difference = 1e-4;
  const OGrid grid(clustered);
  const auto displacement = image_of(grid, [](Complex r) { return bent(r, x); });
  const auto slope = bent_slope(grid, x);
  const auto direction = image_of(
      grid, [](Complex r) { return r + Complex(std::sin(r.imag()), std::cos(2 * r.real())); });
  Metrics<Complex> stepped_metrics(extent_of(grid), true);
  const Displacement<Complex> stepped_slope = stepped(grid, slope, h, slope);
  update_metrics(grid, 0, stepped(grid, displacement, h, direction), &stepped_slope,
                 stepped_metrics);
  const Metrics<double> here = metrics_of(grid, displacement, &slope);
  // Displacement and slope moved by `distance` along their directions.
  const auto moved = [&](double distance) {
    Displacement<double> d = displacement, d_xi = slope;
    for (const auto component : {&Displacement<double>::y, &Displacement<double>::z})
      for (std::size_t k = 0; k < (d.*component).values().size(); ++k) {
        (d.*component).values()[k] += distance * (direction.*component).values()[k];
        (d_xi.*component).values()[k] += distance * (slope.*component).values()[k];
      }
    return metrics_of(grid, d, &d_xi);
  };
  const Metrics<double> plus = moved(difference), minus = moved(-difference);
  const auto compare = [&](const char* name, const auto& of, int rows, int columns) {
    double largest = 0, worst = 0, worst_real = 0, largest_real = 0;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const Complex found = of(stepped_metrics).row(0, j)[i];
        const double expected = (of(plus).row(0, j)[i] - of(minus).row(0, j)[i]) / (2 * difference);
        largest = std::max(largest, std::abs(expected));
        worst = std::max(worst, std::abs(found.imag() / h - expected));
        largest_real = std::max(largest_real, std::abs(of(here).row(0, j)[i]));
        worst_real = std::max(worst_real, std::abs(found.real() - of(here).row(0, j)[i]));
      }
    // The central difference errs by difference^2 times third derivatives, which at the flag's
    // edges are large: the displacement is divided by cells of 1e-3 there.
    EXPECT_LT(worst, 1e-3 * largest) << name;
    EXPECT_GT(largest, 0) << name;
    EXPECT_LT(worst_real, 1e3 * epsilon * largest_real) << name;
  };
  const int rows = grid.n_rho(), columns = grid.n_theta();
  for (const bool across_rho : {true, false}) {
    const auto faces = [=](const char* name, auto member) {
      compare(
          name,
          [=](const auto& m) -> const auto& {
            return member(across_rho ? m.rho_faces : m.theta_faces);
          },
          across_rho ? rows + 1 : rows, across_rho ? columns : columns + 1);
    };
    faces(
        "area_x", [](const auto& f) -> const auto& { return f.area_x; });
    faces(
        "area_y", [](const auto& f) -> const auto& { return f.area_y; });
    faces(
        "area_z", [](const auto& f) -> const auto& { return f.area_z; });
    faces(
        "along", [](const auto& f) -> const auto& { return f.along; });
    faces(
        "across", [](const auto& f) -> const auto& { return f.across; });
  }
  compare(
      "s_x", [](const auto& m) -> const auto& { return m.s_x; }, rows, columns);
  compare(
      "s_y", [](const auto& m) -> const auto& { return m.s_y; }, rows, columns);
  compare(
      "s_z", [](const auto& m) -> const auto& { return m.s_z; }, rows, columns);
  compare(
      "t_x", [](const auto& m) -> const auto& { return m.t_x; }, rows, columns);
  compare(
      "t_y", [](const auto& m) -> const auto& { return m.t_y; }, rows, columns);
  compare(
      "t_z", [](const auto& m) -> const auto& { return m.t_z; }, rows, columns);
  compare(
      "volume", [](const auto& m) -> const auto& { return m.volume; }, rows, columns);
}

}  // namespace
}  // namespace pennon::dns
