// SLEPc on pencils whose spectrum is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "common/petsc/petsc.hpp"
#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/slepc/krylov_schur.hpp"
#include "modes/global/solve/slepc/mumps_factors.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;

void start() {
  petsc::start();
  static const SlepcSession session;
}

// Blocks [0 1; -5 -2], of -1 +- 2i, and then n on the diagonal; B singular in the last row.
Matrix stiffness(int n) {
  Matrix A(n, n);
  A.insert(0, 1) = 1;
  A.insert(1, 0) = -5;
  A.insert(1, 1) = -2;
  for (int k = 2; k < n; ++k) A.insert(k, k) = k;
  A.insert(0, 0) = 0;
  return A;
}

Matrix mass(int n) {
  Matrix B(n, n);
  for (int k = 0; k + 1 < n; ++k) B.insert(k, k) = 1;
  return B;
}

Spectrum near(const SparsePencil& pencil, Complex target, int n_modes, bool with_adjoints) {
  return eigenpairs_near(pencil, ShiftedSparse(pencil, target, mumps_factors()), target, n_modes,
                         with_adjoints);
}

TEST(GlobalEigensolver, FindsTheEigenvaluesOfADiagonalAndOfA2By2Block) {
  start();
  constexpr int n = 40;
  const SparsePencil pencil(stiffness(n), mass(n));
  const Spectrum near_block = near(pencil, {-1, 1.9}, 1, false);
  ASSERT_EQ(near_block.pairs.size(), 1u);
  EXPECT_LT(std::abs(near_block.pairs[0].lambda - Complex(-1, 2)), 1e-12);
  const Spectrum near_diagonal = near(pencil, {7.3, 0}, 3, false);
  ASSERT_EQ(near_diagonal.pairs.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(std::abs(near_diagonal.pairs[k].lambda - (8.0 - static_cast<double>(k))), 1e-10);
  EXPECT_EQ(near_diagonal.requested, 3);
}

TEST(GlobalEigensolver, FindsAdjointsThatAreOrthogonalToTheOtherModes) {
  start();
  constexpr int n = 40;
  Matrix A = stiffness(n);
  for (int k = 2; k + 1 < n; ++k) A.insert(k, k + 1) = 0.3;
  const SparsePencil pencil(A, mass(n));
  const Spectrum spectrum = near(pencil, {7.3, 0.2}, 4, true);
  ASSERT_EQ(spectrum.pairs.size(), 4u);
  EXPECT_LT(biorthogonality_defect(pencil, spectrum.pairs), 1e-8);
  for (const Eigenpair& pair : spectrum.pairs) {
    EXPECT_LT(pair.adjoint_residual, 1e-10);
    EXPECT_LT(std::abs(pair.p.dot(mass(n) * pair.q) - 1.0), 1e-12);
  }
}

// A flag in a flow on a small grid: six eigenpairs next to a target, whose adjoints differ in size
// by a factor of ten. All bounds follow from the matrices, the distance of the target, the gaps
// between the eigenvalues and the vectors; none has a number that was measured.
class AdjointsOfTheFlag : public testing::TestWithParam<double> {
 protected:
  static CoupledOperator small_flag() {
    start();
    const dns::OGrid grid({.n_rho = 16, .n_theta = 32, .R = 4, .wall_spacing = 0.05});
    const BaseFlow base = base_flow(grid, {.Re = 300, .dt_of_pressure = 0.01}, 2);
    return coupled_operator(grid, base,
                            flag_operator(dns::coupled_chord(grid), dns::Edge::pinned,
                                          {.mu = 0.3, .K_B = 1e-3}, base.forces, 0, 1),
                            0);
  }

  // Of the same modes, each with a target and factors of its own.
  std::vector<Eigenpair> found_one_by_one() const {
    std::vector<Eigenpair> others;
    for (const Eigenpair& pair : pairs) {
      others.push_back(eigenpair_near(whole, pair.lambda + 1e-3));
      normalise(coupled, others.back());
    }
    return others;
  }

  // What n terms, summed or eliminated, lose to rounding, over the sum of their sizes: errors of
  // either sign add up as sqrt(n) (Higham & Mary 2019).
  double rounding() const {
    return std::numeric_limits<double>::epsilon() * std::sqrt(static_cast<double>(coupled.size()));
  }

  // The same of A - lambda B, entry by entry.
  Eigen::SparseMatrix<double> rounding(Complex lambda) const {
    return rounding() * (whole.matrix_A.cwiseAbs() + std::abs(lambda) * whole.matrix_B.cwiseAbs());
  }

  Eigen::VectorXcd adjoint_remainder(const Eigenpair& pair) const {
    return coupled.A_adjoint(pair.p) - std::conj(pair.lambda) * coupled.B_adjoint(pair.p);
  }

  // The largest |p_i^H B o_j| over its bound, o_j the mode that another solver found with mu_j.
  // With the remainders s_i = A^H p_i - conj(lambda_i) B^H p_i and r_j = A o_j - mu_j B o_j,
  //
  //   (mu_j - lambda_i) p_i^H B o_j = s_i^H o_j - p_i^H r_j.
  //
  // Of s_i^H q_j biorthogonalise() leaves the rounding of p_i^H (A - lambda B) q_j: what s_i^H o_j
  // keeps is of o_j - q_j, which is of second order. r_j is the other solver's.
  double defect_over_bound(const std::vector<Eigenpair>& others) const {
    double largest = 0;
    for (const Eigenpair& i : pairs) {
      const double remainder = adjoint_remainder(i).norm();
      const Eigen::VectorXd lost = rounding(i.lambda).transpose() * i.p.cwiseAbs();
      for (std::size_t j = 0; j < others.size(); ++j) {
        const Eigen::VectorXcd &q = pairs[j].q, &o = others[j].q, Bo = coupled.B(o);
        if (&i == &pairs[j]) continue;
        const double from_other = std::abs(i.p.dot(coupled.A(o) - others[j].lambda * Bo)),
                     apart = (o - q * (q.dot(o) / q.squaredNorm())).norm(),
                     bound = (from_other + remainder * apart + lost.dot(o.cwiseAbs())) /
                             std::abs(others[j].lambda - i.lambda);
        largest = std::max(largest, std::abs(i.p.dot(Bo)) / bound);
      }
    }
    return largest;
  }

  // What rounding leaves of a product of a unit vector with T^H = B^H (A - target B)^-H outside the
  // modes, root mean square. It is largest for the vector along B^H p of the mode next to the
  // target, for then the solution is large, p / |B^H p| / |lambda - target|: the solver solves with
  // matrices that differ from A and B by rounding, as if its right-hand side had errors of
  // rounding(target)^T |solution|, of either sign. The modes' own share is taken out.
  double lost_by_product(const ShiftedInverse& inverse) const {
    const Eigenpair& next = pairs.front();
    const Eigen::VectorXd errors = rounding(target).transpose() * next.p.cwiseAbs() /
                                   coupled.B_adjoint(next.p).norm() /
                                   std::abs(next.lambda - target);
    constexpr int samples = 20;
    double squares = 0;
    for (int k = 0; k < samples; ++k) {
      const Eigen::VectorXd signs = Eigen::VectorXd::Random(errors.size()).cwiseSign();
      Eigen::VectorXcd lost =
          coupled.B_adjoint(inverse.solve_adjoint((signs.cwiseProduct(errors)).cast<Complex>()));
      const Eigen::VectorXcd all = lost;
      for (const Eigenpair& each : pairs) lost -= each.q.dot(all) * coupled.B_adjoint(each.p);
      squares += lost.squaredNorm() / samples;
    }
    return std::sqrt(squares);
  }

  // The largest |A^H p - conj(lambda) B^H p| over its bound. Krylov's vectors fulfil T^H c = theta
  // c, c = B^H p and theta = 1 / conj(lambda - target), but for the rounding of products with T^H;
  // that is multiplied by |lambda - target| in the remainder, which is itself subject to rounding.
  double remainder_over_bound(double lost) const {
    double largest = 0;
    for (const Eigenpair& pair : pairs) {
      const double bound = (rounding(pair.lambda).transpose() * pair.p.cwiseAbs()).norm() +
                           std::abs(pair.lambda - target) * coupled.B_adjoint(pair.p).norm() * lost;
      largest = std::max(largest, adjoint_remainder(pair).norm() / bound);
    }
    return largest;
  }

  // Of what the p_i^H B q_j lose to rounding.
  double inner_product_bound() const {
    double largest = 0;
    for (const Eigenpair& i : pairs)
      for (const Eigenpair& j : pairs)
        largest = std::max(largest, i.p.norm() * coupled.B(j.q).norm());
    return rounding() * largest;
  }

  const CoupledOperator coupled = small_flag();
  const SparsePencil whole = coupled.assembled();
  const Complex first = eigenpair_near(whole, {0.44, 2.66}).lambda, target = first + GetParam();
  std::vector<Eigenpair> pairs =
      coupled_eigenpairs_near(coupled, target, 6, true, mumps_factors()).pairs;
};

// As near as spectrum_of() goes to an eigenvalue, and nearer, so that the others' adjoints hold
// much of the first mode's.
INSTANTIATE_TEST_SUITE_P(GlobalEigensolver, AdjointsOfTheFlag, testing::Values(1e-3, 1e-5));

TEST_P(AdjointsOfTheFlag, AreOrthogonalToModesThatAnotherSolverFound) {
  ASSERT_EQ(pairs.size(), 6u);
  ASSERT_TRUE(are_same(pairs.front().lambda, first));
  const std::vector<Eigenpair> others = found_one_by_one();
  biorthogonalise(coupled, pairs);
  const double lost = lost_by_product(ShiftedCoupled(coupled, target, mumps_factors()));
  const auto expect_within_bounds = [&] {
    EXPECT_LT(defect_over_bound(others), 1);
    EXPECT_LT(remainder_over_bound(lost), 1);
    EXPECT_LT(biorthogonality_defect(coupled, pairs), inner_product_bound());
    for (const Eigenpair& pair : pairs)
      EXPECT_LT(std::abs(pair.p.dot(coupled.B(pair.q)) - 1.0), inner_product_bound());
  };
  expect_within_bounds();
  // Now modes and adjoints that hold 1e-8 of each other.
  const std::vector<Eigenpair> pure = pairs;
  for (Eigenpair& pair : pairs)
    for (const Eigenpair& other : pure) {
      pair.q += 1e-8 * other.q;
      pair.p += 1e-8 * other.p;
    }
  for (Eigenpair& pair : pairs) normalise(coupled, pair);
  EXPECT_GT(defect_over_bound(others), 1);
  EXPECT_GT(biorthogonality_defect(coupled, pairs), inner_product_bound());
  biorthogonalise(coupled, pairs);
  expect_within_bounds();
}

// The same solutions as with factors of the whole matrix, and residuals of rounding.
TEST(GlobalShiftedInverse, OfTheCoupledOperatorSolvesWithTheWholeMatrix) {
  start();
  for (const double k_x : {0.0, 2.0}) {
    const dns::OGrid grid({.n_rho = 10, .n_theta = 20, .R = 3, .wall_spacing = 0.1});
    const BaseFlow base =
        base_flow(grid, {.Re = 100, .U = 0.4, .dt_of_pressure = 0.01}, k_x == 0 ? 2 : 3);
    const CoupledOperator coupled =
        coupled_operator(grid, base,
                         flag_operator(dns::coupled_chord(grid), dns::Edge::pinned,
                                       {.mu = 0.3, .K_B = 1e-3}, base.forces, k_x, 20),
                         k_x);
    const SparsePencil whole = coupled.assembled();
    const Complex target(0.2, -1.7);
    const Eigen::VectorXcd b = Eigen::VectorXcd::Random(coupled.size());
    EXPECT_LT((coupled.A(b) - whole.A(b)).norm(), 1e-12 * whole.A(b).norm());
    EXPECT_LT((coupled.A_adjoint(b) - whole.A_adjoint(b)).norm(),
              1e-12 * whole.A_adjoint(b).norm());
    EXPECT_LT((coupled.B_adjoint(b) - whole.B_adjoint(b)).norm(), 1e-12 * b.norm());
    const ShiftedSparse by_whole(whole, target, mumps_factors());
    for (const auto& factors : {mumps_factors(), umfpack_factors()}) {
      const ShiftedCoupled by_parts(coupled, target, factors);
      const Eigen::VectorXcd q = by_whole.solve(b), p = by_whole.solve_adjoint(b);
      EXPECT_LT((by_parts.solve(b) - q).norm(), 1e-10 * q.norm()) << k_x;
      EXPECT_LT((by_parts.solve_adjoint(b) - p).norm(), 1e-10 * p.norm()) << k_x;
    }
  }
}

TEST(GlobalEigensolver, MergesTheModesOfSeveralTargetsIntoOneSpectrum) {
  start();
  FlagParameters flag;
  flag.mu = 0.3;
  flag.K_B = 1e-3;
  Settings settings;
  settings.n_modes = 3;
  settings = resolve(settings, flag, {16, 32, 4, 4, 0.05, 0, 0.02});
  const auto modes_near = [&](const std::vector<double>& target) {
    settings.target = target;
    return run(flag, {.Re = 300}, settings, coupled_eigensolver(mumps_factors()));
  };
  const Result one = modes_near({0.4, 2.6}), other = modes_near({-0.5, 4.5}),
               merged = modes_near({0.4, 2.6, -0.5, 4.5});
  const auto holds = [](const Result& result, const GlobalMode& mode) {
    return std::ranges::any_of(result.found.modes, [&](const GlobalMode& each) {
      return are_same(each.lambda, mode.lambda);
    });
  };
  std::size_t common = 0;
  for (const GlobalMode& mode : one.found.modes) {
    EXPECT_TRUE(holds(merged, mode));
    common += holds(other, mode) ? 1 : 0;
  }
  for (const GlobalMode& mode : other.found.modes) EXPECT_TRUE(holds(merged, mode));
  EXPECT_GT(common, 0u);  // else nothing had to be merged
  EXPECT_EQ(merged.found.modes.size(), one.found.modes.size() + other.found.modes.size() - common);
  EXPECT_EQ(merged.fields.modes.size(), merged.found.modes.size());
  EXPECT_EQ(merged.found.requested, 6);
}

// Without a target. Turning the cross-flow round is a reflection of the span: it conjugates lambda.
TEST(GlobalEigensolver, SeeksWavesOfEitherDirectionInACrossFlow) {
  start();
  FlagParameters flag;
  flag.mu = 0.3;
  flag.K_B = 1e-3;
  flag.gamma = 3;
  Settings settings;
  settings.n_modes = 6;
  settings = resolve(settings, flag, {16, 32, 12, 4, 0.05, 0, 0.02});
  const auto modes_with = [&](double U) {
    FoundModes found =
        run(flag, {.Re = 300, .U = U}, settings, coupled_eigensolver(mumps_factors())).found;
    EXPECT_EQ(found.converged, 6);
    found.modes.resize(6);  // those of the box are behind them
    return found.modes;
  };
  const std::vector<GlobalMode> along = modes_with(0.5), turned = modes_with(-0.5),
                                without = modes_with(0);
  // The wave that travels with the cross-flow, exp(i (k_x x + omega t)) with omega < 0, grows most.
  EXPECT_LT(along[0].lambda.imag(), -1);
  EXPECT_TRUE(std::ranges::any_of(along, [](const auto& mode) { return mode.lambda.imag() > 1; }));
  for (std::size_t k = 0; k < along.size(); ++k)
    EXPECT_LT(std::abs(along[k].lambda - std::conj(turned[k].lambda)), 1e-8) << k;
  EXPECT_TRUE(std::ranges::all_of(
      without, [](const GlobalMode& mode) { return mode.lambda.imag() > -1e-6; }));
}

// What is called a mode of the flag is there with R = 8 and with R = 12; what is called a mode of
// the box is not, whether its shares said so or a second solution. The cells within R = 8 are the
// same.
TEST(GlobalEigensolver, TellsModesOfTheFlagFromThoseOfTheBox) {
  start();
  FlagParameters flag;
  flag.mu = 0.125;
  flag.K_B = 1e-4;
  Settings settings;
  settings.n_modes = 5;
  settings = resolve(settings, flag, {24, 48, 60, 8, 0.03, 0, 0.01});
  const FlowParameters flow{.Re = 1000};
  const EigenSolver solve = coupled_eigensolver(mumps_factors());
  const FoundModes found = run(flag, flow, settings, solve).found;
  EXPECT_EQ(found.converged, 5);
  EXPECT_GT(found.checked, 0);
  const CoupledProblem larger =
      coupled_problem(flag, flow, with_larger_box(settings, grid_of(settings)));
  const double R = larger.grid.settings().R;
  EXPECT_NEAR(R, 12, 2);
  for (const GlobalMode& mode : found.modes) {
    const Complex next = solve(larger.coupled, mode.lambda, 1, false).pairs.at(0).lambda;
    const double move = std::abs(next - mode.lambda) / std::abs(mode.lambda);
    if (mode.kind == ModeKind::box)
      EXPECT_GT(move, 0.03) << mode.lambda << next;
    else
      EXPECT_LT(move, 0.01) << mode.lambda << next;
  }
  // Growth rate times R is the same for the leading mode of the box, as in a loop of transport and
  // pressure; the flag's is where it was.
  const auto leading_of_box = std::ranges::find(found.modes, ModeKind::box, &GlobalMode::kind);
  ASSERT_NE(leading_of_box, found.modes.end());
  const Complex expected = leading_of_box->lambda * 8.0 / R;
  const Complex other = solve(larger.coupled, expected, 1, false).pairs.at(0).lambda;
  EXPECT_LT(std::abs(other - expected), 0.1 * std::abs(expected)) << other << expected;
}

TEST(GlobalEigensolver, SurvivesATargetOnAnEigenvalue) {
  start();
  constexpr int n = 40;
  const Spectrum spectrum = near(SparsePencil(stiffness(n), mass(n)), {7 + 1e-12, 0}, 1, false);
  ASSERT_FALSE(spectrum.pairs.empty());
  EXPECT_LT(std::abs(spectrum.pairs[0].lambda - 7.0), 1e-8);
}

}  // namespace
}  // namespace pennon::modes::global
