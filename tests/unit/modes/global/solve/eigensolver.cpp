// SLEPc on pencils whose spectrum is known.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/petsc/petsc.hpp"
#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/slepc/eigensolver.hpp"
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

Spectrum near(const SparsePencil& pencil, Complex target, int requested, bool with_adjoints) {
  return eigenpairs_near(pencil, ShiftedSparse(pencil, target, mumps_factors()), target, requested,
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

TEST(GlobalEigensolver, AdjointsOfTheFlagAreOrthogonalToModesThatAnotherSolverFound) {
  start();
  const dns::OGrid grid({.n_rho = 16, .n_theta = 32, .R = 4, .wall_spacing = 0.05});
  const BaseFlow base = base_flow(grid, {.Re = 300, .tau = 0.01}, 2);
  const CoupledOperator coupled =
      coupled_operator(grid, base,
                       flag_operator(dns::coupled_chord(grid), dns::Edge::pinned,
                                     {.mu = 0.3, .K_B = 1e-3}, base.forces, 0, 1),
                       0);
  const SparsePencil whole = coupled.assembled();
  const Complex first = eigenpair_near(whole, {0.44, 2.66}).lambda;
  // As near as spectrum_of() goes to an eigenvalue, and nearer, so that the others' adjoints hold
  // much of the first mode's.
  for (const double distance : {1e-3, 1e-5}) {
    const bool is_usual = distance >= 1e-3;
    Spectrum spectrum =
        coupled_eigenpairs_near(coupled, first + distance, 6, true, mumps_factors());
    ASSERT_EQ(spectrum.pairs.size(), 6u);
    std::vector<Eigenpair> others;
    for (const Eigenpair& pair : spectrum.pairs) {
      others.push_back(eigenpair_near(whole, pair.lambda + 1e-3));
      others.back().q /= std::sqrt(others.back().q.dot(coupled.B(others.back().q)).real());
    }
    const auto defect = [&] {
      double largest = 0;
      for (std::size_t i = 0; i < others.size(); ++i)
        for (std::size_t j = 0; j < others.size(); ++j)
          if (i != j)
            largest = std::max(largest, std::abs(spectrum.pairs[i].p.dot(coupled.B(others[j].q))));
      return largest;
    };
    const double before = defect();
    biorthogonalise(coupled, spectrum.pairs);
    EXPECT_LT(defect(), is_usual ? 1e-9 : before / 4);
    EXPECT_LT(biorthogonality_defect(coupled, spectrum.pairs), 1e-11);
    for (const Eigenpair& pair : spectrum.pairs) {
      EXPECT_LT(pair.adjoint_residual, is_usual ? 1e-10 : 1e-8);
      EXPECT_LT(std::abs(pair.p.dot(coupled.B(pair.q)) - 1.0), 1e-12);
    }
  }
}

// The same solutions as with factors of the whole matrix, and residuals of rounding.
TEST(GlobalShiftedInverse, OfTheCoupledOperatorSolvesWithTheWholeMatrix) {
  start();
  for (const double k_x : {0.0, 2.0}) {
    const dns::OGrid grid({.n_rho = 10, .n_theta = 20, .R = 3, .wall_spacing = 0.1});
    const BaseFlow base = base_flow(grid, {.Re = 100, .U = 0.4, .tau = 0.01}, k_x == 0 ? 2 : 3);
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
    return run(flag, {.Re = 300, .U = U}, settings, coupled_eigensolver(mumps_factors()))
        .found.modes;
  };
  const std::vector<GlobalMode> along = modes_with(0.5), turned = modes_with(-0.5),
                                without = modes_with(0);
  ASSERT_EQ(along.size(), 6u);
  ASSERT_EQ(turned.size(), 6u);
  // The wave that travels with the cross-flow, exp(i (k_x x + omega t)) with omega < 0, grows most.
  EXPECT_LT(along[0].lambda.imag(), -1);
  EXPECT_TRUE(std::ranges::any_of(along, [](const auto& mode) { return mode.lambda.imag() > 1; }));
  for (std::size_t k = 0; k < along.size(); ++k)
    EXPECT_LT(std::abs(along[k].lambda - std::conj(turned[k].lambda)), 1e-8) << k;
  EXPECT_TRUE(std::ranges::all_of(
      without, [](const GlobalMode& mode) { return mode.lambda.imag() > -1e-6; }));
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
