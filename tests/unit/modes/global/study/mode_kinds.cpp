// The shares of a mode's energy, and what follows from them: kinds, and the search that counts
// them.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "modes/global/study/mode_search.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

FlagParameters flag_of_case() {
  FlagParameters flag;
  flag.mu = 0.4;
  flag.K_B = 2e-3;
  return flag;
}

const FlagParameters flag = flag_of_case();
const FlowParameters flow{.Re = 100};

Settings settings_of(double R, std::int64_t n_rho) {
  Settings settings;
  settings.n_modes = 2;
  return resolve(settings, flag, {n_rho, 24, 4, R, 0.1, 0, 0.02});
}

class ModeKinds : public testing::Test {
 protected:
  // Velocity 1 along y in one cell, and the flag at rest: a point well inside of r < R/2, beside
  // the flag or in its wake, or outside.
  Eigenpair in_cell(Complex lambda, const auto& is_there) const {
    const HalfPlane& cells = problem_.coupled.flow();
    Eigenpair pair{.lambda = lambda, .q = Eigen::VectorXcd::Zero(problem_.coupled.size())};
    for (int j = 0; j < cells.rows(); ++j)
      for (int i = 0; i < cells.columns(); ++i) {
        const Complex place =
            OGrid::place(problem_.grid.rho_centre(j), problem_.grid.theta_centre(i));
        if (!is_there(place)) continue;
        pair.q[cells.index(0, j, i)] = 1;
        return pair;
      }
    ADD_FAILURE() << "there is no such cell";
    return pair;
  }
  Eigenpair beside_flag(Complex lambda) const {
    return in_cell(lambda, [](Complex place) { return place.real() < 1 && place.imag() < 0.5; });
  }
  Eigenpair in_wake(Complex lambda) const {
    return in_cell(lambda, [](Complex place) { return place.real() > 1.6 && place.real() < 2.2; });
  }
  Eigenpair outside(Complex lambda) const {
    return in_cell(lambda, [](Complex place) { return std::abs(place) > 5; });
  }
  EnergyShares shares_of(const Eigenpair& pair) const {
    return energy_shares(problem_.grid, problem_.coupled, fixed_points_, pair);
  }

  Settings settings_ = settings_of(6, 16);
  CoupledProblem problem_ = coupled_problem(flag, flow, settings_);
  FixedPoints fixed_points_{problem_.grid, problem_.base};
};

TEST_F(ModeKinds, GiveEachPlaceItsShare) {
  const EnergyShares near = shares_of(beside_flag(1)), wake = shares_of(in_wake(1)),
                     outer = shares_of(outside(1));
  EXPECT_EQ(near.near, 1);
  EXPECT_EQ(wake.wake, 1);
  EXPECT_EQ(outer.outer, 1);
  for (const EnergyShares& share : {near, wake, outer}) EXPECT_EQ(share.flag, 0);
}

// The flag moves as y^2, and the fluid is at rest at fixed points but in one cell and its mirror
// image. Mass and stiffness are summed here entry by entry.
TEST_F(ModeKinds, WeighTheFlagAgainstTheFluid) {
  const CoupledOperator& coupled = problem_.coupled;
  const Complex lambda(0.3, 2);
  Eigenpair pair = in_wake(lambda);
  const Eigen::VectorXcd in_cell = pair.q;
  const Eigen::Index nodes = coupled.flag_nodes();
  double energy = 0;
  for (Eigen::Index k = 0; k < nodes; ++k) {
    const auto zeta = [&](Eigen::Index node) {
      return std::pow(problem_.chord[static_cast<std::size_t>(node) + 1], 2);
    };
    pair.q[coupled.zeta(k)] = zeta(k);
    energy += coupled.flag.mass[k] * std::norm(lambda) * zeta(k) * zeta(k) / 2;
    for (Eigen::Index l = 0; l < nodes; ++l)
      energy += zeta(k) * coupled.flag.stiffness(k, l).real() * zeta(l) / 2;
  }
  // What is at rest at fixed points moves against the grid.
  const Displacement<Complex> d = displacement_of(coupled, pair.q, coupled.zeta(0));
  PlaneFlow<Complex> carried(problem_.base.q.p.extent(), 2);
  const Field<Complex> nothing(problem_.base.q.p.extent());
  for (int f = 0; f < carried.fields(); ++f)
    carried.field(f) = fixed_points_.of_field(f, nothing, d);
  pair.q.head(coupled.flow().unknowns()) -= coupled.flow().pack(carried);
  double of_cell = 0;  // and of its mirror image
  for (Eigen::Index k = 0; k < coupled.flow().unknowns(); ++k)
    of_cell += coupled.fluid().B_vv.coeff(k, k).real() * std::norm(in_cell[k]);
  const EnergyShares shares = shares_of(pair);
  EXPECT_NEAR(shares.flag, energy / (energy + of_cell), 1e-12);
  EXPECT_NEAR(shares.wake, of_cell / (energy + of_cell), 1e-12);
  EXPECT_NEAR(shares.near, 0, 1e-12);
  EXPECT_NEAR(shares.outer, 0, 1e-12);
  pair.q *= Complex(2, -3);
  EXPECT_NEAR(shares_of(pair).flag, shares.flag, 1e-12);
}

// A uniform disturbance has its energy where the area is: pi R^2/4 of pi R^2 within R/2, but for
// the hole that the flag does not make and for the cells' curved sides.
TEST_F(ModeKinds, CutCellsAtHalfTheRadius) {
  for (const std::int64_t n_rho : {8, 16, 32}) {
    const CoupledProblem problem = coupled_problem(flag, flow, settings_of(6, n_rho));
    const FixedPoints fixed_points(problem.grid, problem.base);
    Eigenpair pair{.lambda = 1, .q = Eigen::VectorXcd::Zero(problem.coupled.size())};
    problem.coupled.flow().for_each([&](int f, int, int, Eigen::Index k) { pair.q[k] = f == 0; });
    const EnergyShares share = energy_shares(problem.grid, problem.coupled, fixed_points, pair);
    EXPECT_NEAR(share.outer, 0.75, 0.02) << n_rho;
    EXPECT_NEAR(share.near + share.wake, 0.25, 0.02) << n_rho;
  }
}

TEST(ModeKind, FollowsFromSharesThatLeaveNoDoubt) {
  const auto kind = [](EnergyShares shares) { return kind_by_shares(shares); };
  // A light flag on 60 x 120 cells, R = 8: flutter, a mode of the box and one of the wake.
  EXPECT_EQ(kind({1.7e-3, 1.8e-1, 8.1e-1, 3.0e-3}), ModeKind::flag);
  EXPECT_EQ(kind({1.4e-6, 2.5e-3, 2.5e-2, 9.7e-1}), ModeKind::box);
  EXPECT_EQ(kind({2.5e-6, 8.4e-4, 9.1e-1, 8.7e-2}), std::nullopt);
  EXPECT_EQ(kind({0.3, 0.2, 0.1, 0.4}), std::nullopt);
}

TEST(ModeKind, NeedsAnEigenvalueThatStays) {
  constexpr double R = 8, larger_R = 12;
  const auto stays_here = [&](Complex lambda, const std::vector<Complex>& others) {
    return stays(lambda, others, R, larger_R, 0.02);
  };
  const Complex flutter(-0.49731, 6.24542);
  EXPECT_TRUE(stays_here(flutter, {{-0.49777, 6.2453}, {-0.7, 5.5}}));
  // The modes of the box: (ln r + 2 pi i k)/R.
  const auto of_box = [](double radius, int k) {
    return Complex(std::log(0.043), 2 * M_PI * k) / radius;
  };
  for (int k = 0; k < 40; ++k) {
    std::vector<Complex> larger;
    larger.reserve(60);
    for (int l = 0; l < 60; ++l) larger.push_back(of_box(larger_R, l));
    EXPECT_FALSE(stays_here(of_box(R, k), larger)) << k;
  }
  EXPECT_FALSE(stays_here(flutter, {}));
  // Another 4 % away, but no nearer than chance among neighbours so close.
  EXPECT_FALSE(stays_here({-1, 5}, {{-1, 5.2}, {-1, 5.6}}));
  EXPECT_TRUE(stays_here({-1, 5}, {{-1, 5.01}, {-1, 5.6}}));
  // Near the neutral curve the growth rate may change its sign.
  EXPECT_TRUE(stays_here({1e-3, 5}, {{-2e-3, 5.01}, {-1, 4}}));
}

TEST(ModeKind, LargerBoxKeepsTheCellsWithinR) {
  for (const std::int64_t n_rho : {10, 16, 24}) {
    const Settings settings = settings_of(8, n_rho);
    const OGrid grid = grid_of(settings), larger = grid_of(with_larger_box(settings, grid));
    EXPECT_GE(larger.settings().R, 12);
    EXPECT_LT(larger.rho(larger.n_rho() - 1), std::asinh(24));
    for (int j = 0; j <= grid.n_rho(); ++j) EXPECT_NEAR(larger.rho(j), grid.rho(j), 1e-9) << j;
  }
}

// A solver whose eigenvalues are known: next to any target the first n of a list.
class ModeSearch : public ModeKinds {
 protected:
  FoundPairs search(std::vector<Eigenpair> list) {
    asked_.clear();
    const EigenSolver solve = [&, list](const CoupledOperator&, Complex, int n, bool) {
      asked_.push_back(n);
      Spectrum found;
      for (int k = 0; k < std::min(n, static_cast<int>(list.size())); ++k)
        found.pairs.push_back(list[static_cast<std::size_t>(k)]);
      return found;
    };
    KindFinder kinds(flag, flow, settings_, solve);
    return search_modes(problem_, settings_, solve, kinds);
  }

  std::vector<int> asked_;
};

TEST_F(ModeSearch, CountsWhatIsNotOfTheBox) {
  settings_.target = {0, 1};
  const FoundPairs found =
      search({outside({-0.1, 1}), beside_flag({-0.3, 1}), outside({-0.2, 2}), outside({-0.25, 2}),
              beside_flag({0.1, 3}), beside_flag({0, 9})});
  EXPECT_EQ(asked_, (std::vector<int>{2, 8}));
  EXPECT_EQ(found.requested, 2);
  EXPECT_EQ(found.converged, 2);
  EXPECT_EQ(found.searched, 8);
  EXPECT_EQ(found.box, 3);
  // The two next to the target, and as many of the box, which are behind them.
  ASSERT_EQ(found.pairs.size(), 4u);
  EXPECT_EQ(found.pairs[0].pair.lambda, Complex(0.1, 3));
  EXPECT_EQ(found.pairs[1].pair.lambda, Complex(-0.3, 1));
  EXPECT_EQ(found.pairs[2].pair.lambda, Complex(-0.1, 1));
  EXPECT_EQ(found.pairs[2].kind, ModeKind::box);
}

TEST_F(ModeSearch, EndsAtFourTimesAsMany) {
  settings_.target = {0, 1};
  std::vector<Eigenpair> list(20);
  for (std::size_t k = 0; k < list.size(); ++k) list[k] = outside({-0.1, static_cast<double>(k)});
  const FoundPairs found = search(list);
  EXPECT_EQ(asked_, (std::vector<int>{2, 8}));
  EXPECT_EQ(found.converged, 0);
  EXPECT_EQ(found.requested, 2);
  EXPECT_EQ(found.box, 8);
  EXPECT_EQ(found.pairs.size(), 2u);
}

TEST_F(ModeSearch, LeavesOutWhatIsFasterThanTheStep) {
  settings_.target = {0, 1};
  const FoundPairs found =
      search({beside_flag({1 / 0.019, 0}), beside_flag({0.2, 1}), beside_flag({0.1, 2})});
  EXPECT_EQ(found.too_fast, 1);
  EXPECT_EQ(found.converged, 2);
  EXPECT_EQ(found.pairs.front().pair.lambda, Complex(0.2, 1));
}

TEST_F(ModeSearch, TakesTheLeadingOnesWithoutATarget) {
  const FoundPairs found = search({beside_flag({-3, 1}), beside_flag({0.2, 1})});
  EXPECT_EQ(asked_, (std::vector<int>(5, 2)));  // of each point once
  EXPECT_EQ(found.requested, 2);
  EXPECT_EQ(found.pairs.front().pair.lambda, Complex(0.2, 1));
  // Of two mirror images one.
  EXPECT_EQ(search({beside_flag({0.2, -1}), beside_flag({0.2, 1})}).converged, 1);
}

}  // namespace
}  // namespace pennon::modes::global
