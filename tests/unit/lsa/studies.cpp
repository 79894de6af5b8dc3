/// Curves, maps, neutral curves, maxima: that they say what the point says.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "common/io/hdf5.hpp"
#include "lsa/batch.hpp"
#include "lsa/curve.hpp"
#include "lsa/map.hpp"
#include "lsa/most_unstable.hpp"
#include "lsa/neutral.hpp"
#include "lsa/quantity.hpp"
#include "lsa/root.hpp"
#include "tests/support/lsa_oracle.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::lsa {
namespace {

using std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

const Point paper{0.125, 1000, 1.0, pi, 0.3, 1e-4, 0};

std::size_t index(Axis axis) {
  return static_cast<std::size_t>(axis);
}

MapSettings map_of(Axis x, Sweep along_x, Axis y, Sweep along_y) {
  MapSettings map;
  map.is_given = true;
  map.fields = map_quantities();
  map.sweeps[index(x)] = std::move(along_x);
  map.sweeps[index(y)] = std::move(along_y);
  return map;
}

TEST(Batch, IsTheSameToTheBitAsPoints) {
  oracle::Sampler sampler(11);
  auto points = std::make_unique<PointBatch>();
  auto results = std::make_unique<StabilityBatch>();
  for (const AddedMass kind : {AddedMass::two_d, AddedMass::wu, AddedMass::lamb})
    for (int bits = 0; bits < 8; ++bits) {
      Model model;
      model.added_mass = kind;
      model.bending = (bits & 1) != 0;
      model.cross_flow = (bits & 2) != 0;
      model.form = (bits & 4) != 0 ? Form::as_printed : Form::consistent;
      std::array<Point, batch_size> each;
      for (std::size_t i = 0; i < batch_size; ++i) {
        each[i] = sampler().point;
        for (const Axis a :
             {Axis::mu, Axis::Re, Axis::k_x, Axis::k_y, Axis::nu_s, Axis::K_B, Axis::U})
          lanes(*points, a)[i] = value(each[i], a);
      }
      solve(model, *points, batch_size, *results);
      for (std::size_t i = 0; i < batch_size; ++i) {
        const Stability s = solve(each[i], Theory{model, {}});
        EXPECT_EQ(results->P[i], s.P);
        EXPECT_EQ(results->omega_r_plus[i], s.omega_r_plus);
        EXPECT_EQ(results->omega_i_plus[i], s.omega_i_plus);
        EXPECT_EQ(results->omega_r_minus[i], s.omega_r_minus);
        EXPECT_EQ(results->omega_i_minus[i], s.omega_i_minus);
        EXPECT_EQ(results->growth[i], s.growth);
        EXPECT_TRUE(results->mu_cr[i] == s.mu_cr ||
                    (std::isnan(s.mu_cr) && std::isnan(results->mu_cr[i])));
      }
    }
}

TEST(Point, IsFiniteAtTheEndsOfWhatACaseMayGive) {
  for (const double mu : {1e-30, 1e30})
    for (const double Re : {1e-30, 1e30})
      for (const double k_x : {0.0, 1e-30, 1e30})
        for (const double k_y : {1e-30, 1e30})
          for (const AddedMass kind : {AddedMass::two_d, AddedMass::wu, AddedMass::lamb}) {
            Theory theory;
            theory.model.added_mass = kind;
            const Stability s = solve({mu, Re, k_x, k_y, 0.3, 0, 0}, theory);
            EXPECT_TRUE(std::isfinite(s.P) && std::isfinite(s.growth) &&
                        std::isfinite(s.frequency));
            EXPECT_TRUE(std::isfinite(s.omega_r_minus) && std::isfinite(s.omega_r_plus));
          }
}

TEST(Map, HoldsWhatThePointsSayWhateverTheNumberOfThreads) {
  const test::TemporaryFolder folder;
  const MapSettings map =
      map_of(Axis::k_x, {0, 6, 700, Scale::linear, {}}, Axis::mu, {0.01, 1, 33, Scale::log, {}});
  std::vector<std::vector<double>> growth;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    const MapSummary summary = compute_map(map, paper, {}, {}, OutputFolder(folder.path()), false);
    EXPECT_EQ(summary.points, 700 * 33);
    growth.push_back(hdf5::Reader(folder.path() / "map.h5").read("/fields/growth").values);
  }
  EXPECT_EQ(growth[0], growth[1]);
  EXPECT_EQ(growth[0], growth[2]);
  const MapAxes axes = axes_of(map);
  EXPECT_EQ(axes.y_axis, Axis::mu) << "the mass ratio lies along the ordinate";
  for (std::size_t j = 0; j < axes.y.size(); j += 8)
    for (std::size_t i = 0; i < axes.x.size(); i += 50) {
      Point there = paper;
      there.k_x = axes.x[i];
      there.mu = axes.y[j];
      EXPECT_EQ(growth[0][j * axes.x.size() + i], solve(there, Theory{}).growth);
    }
}

TEST(Map, TracesTheNeutralCurveToMachinePrecision) {
  const test::TemporaryFolder folder;
  const MapSettings map = map_of(Axis::k_x, {0.1, 12, 60, Scale::linear, {}}, Axis::mu,
                                 {0.02, 0.5, 40, Scale::log, {}});
  const MapSummary summary = compute_map(map, paper, {}, {}, OutputFolder(folder.path()), false);
  ASSERT_EQ(summary.neutral.size(), 1U);
  const Polyline& line = summary.neutral[0];
  ASSERT_GT(line.x.size(), 60U);
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    Point there = paper;
    there.k_x = line.x[i];
    // On a vertical grid line mu is what was refined; on a horizontal one k_x, to whose last bit
    // mu_cr answers with its slope, which is below one in relative terms here.
    EXPECT_NEAR(solve(there, Theory{}).mu_cr / line.y[i], 1, 16 * epsilon) << line.x[i];
  }
}

TEST(Map, TakesTheAddedMassMinamiOncePerWavenumber) {
  const test::TemporaryFolder folder;
  Theory theory;
  theory.model.added_mass = AddedMass::minami;
  MapSettings map =
      map_of(Axis::k_x, {0.5, 6, 5, Scale::linear, {}}, Axis::mu, {0.02, 0.5, 20, Scale::log, {}});
  compute_map(map, paper, theory, {}, OutputFolder(folder.path()), false);
  const auto c_m = hdf5::Reader(folder.path() / "map.h5").read("/fields/c_m");
  Point there = paper;
  there.k_x = 0.5;
  EXPECT_EQ(c_m.values[0], solve(there, theory).c_m);
  EXPECT_EQ(c_m.values[c_m.values.size() - 5], c_m.values[0]);
}

TEST(NeutralCurve, ClosesWhereItIsClosed) {
  std::vector<double> nodes;
  for (int i = 0; i <= 40; ++i) nodes.push_back(-2 + 0.1 * i + 0.013);
  const auto circle = [](double x, double y) { return x * x + y * y - 1; };
  const auto lines = trace_neutral(circle, nodes, nodes);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].x.front(), lines[0].x.back());
  EXPECT_EQ(lines[0].y.front(), lines[0].y.back());
  for (std::size_t i = 0; i < lines[0].x.size(); ++i)
    EXPECT_NEAR(std::hypot(lines[0].x[i], lines[0].y[i]), 1, 4 * epsilon);
}

TEST(NeutralCurve, KeepsTheTwoBranchesOfASaddleApart) {
  std::vector<double> nodes = {-1, -0.5, 0.5, 1};
  const auto hyperbola = [](double x, double y) { return x * y + 0.01; };
  EXPECT_EQ(trace_neutral(hyperbola, nodes, nodes).size(), 2U);
}

TEST(NeutralCurve, LeavesOutWhatIsNotANumber) {
  std::vector<double> nodes = {0, 1, 2};
  EXPECT_TRUE(trace_neutral([](double, double) { return std::nan(""); }, nodes, nodes).empty());
}

TEST(Root, ReachesTheLastBitsAndPassesExceptionsThroughGsl) {
  EXPECT_NEAR(find_root([](double t) { return t * t - 2; }, 0, 2), std::sqrt(2), 2 * epsilon);
  EXPECT_THROW(find_root(
                   [n = 0](double t) mutable {
                     if (++n > 4) throw std::runtime_error("no");
                     return t - 0.3;
                   },
                   0, 1),
               std::runtime_error);
}

TEST(MostUnstable, FindsTheWavenumberWhereTheGrowthIsStationary) {
  Theory theory;
  theory.model.added_mass = AddedMass::two_d;
  Point flat = paper;
  flat.k_x = 0;
  const auto found = most_unstable(flat, theory, Axis::k_y, {0.1, 100, 200, Scale::log, {}});
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->is_at_an_end);
  const auto growth = [&](double k_y) {
    Point there = flat;
    there.k_y = k_y;
    return solve(there, theory).growth;
  };
  const double k = found->wavenumber;
  for (const double step : {1e-3, 1e-2, 0.3}) {
    EXPECT_GT(growth(k), growth(k * (1 + step)));
    EXPECT_GT(growth(k), growth(k * (1 - step)));
  }
  const double h = 1e-4 * k;
  EXPECT_NEAR((growth(k + h) - growth(k - h)) / (2 * h) * k / growth(k), 0, 1e-6);
}

TEST(MostUnstable, IsTwoDimensionalWhereTheSpanChangesTheTensionOnly) {
  Theory theory;
  theory.model.added_mass = AddedMass::two_d;
  const auto found = most_unstable(paper, theory, Axis::k_x, {0, 6, 61, Scale::linear, {}});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->wavenumber, 0);
}

TEST(MostUnstable, IsNoneWhereAllAreStable) {
  Point light = paper;
  light.mu = 1e-3;
  EXPECT_FALSE(most_unstable(light, {}, Axis::k_y, {1, 10, 50, Scale::linear, {}}).has_value());
}

TEST(Curve, HasACurveForEachMemberOfItsFamily) {
  CurveSettings settings;
  settings.sweeps[index(Axis::Re)] = Sweep{100, 1000, 10, Scale::log, {}};
  settings.sweeps[index(Axis::gamma)] = Sweep{0, 0, 0, Scale::linear, {1, 5}};
  const Curve curve = compute(settings, paper, {});
  ASSERT_EQ(curve.values.size(), 2U);
  Point there = paper;
  there.Re = 1000;
  there.k_x = 2 * pi / 5;
  EXPECT_EQ(curve.values[1].back(), solve(there, Theory{}).mu_cr);
}

}  // namespace
}  // namespace pennon::lsa
