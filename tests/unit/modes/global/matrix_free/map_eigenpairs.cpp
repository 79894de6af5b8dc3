/// Arnoldi's method on maps whose eigenvalues are known.
#include "modes/global/matrix_free/map_eigenpairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"

namespace pennon::modes {
namespace {

// A complex pair 0.9 +- 0.4 i, then 0.95 and real values below it, slightly coupled.
Eigen::MatrixXd matrix() {
  constexpr Eigen::Index n = 200;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  A.block<2, 2>(0, 0) << 0.9, 0.4, -0.4, 0.9;
  for (Eigen::Index k = 2; k < n; ++k) {
    A(k, k) = 0.95 * (1 - static_cast<double>(k - 2) / n);
    A(k - 1, k) = 0.001;
  }
  return A;
}

LinearMap map_of(const Eigen::MatrixXd& A) {
  return [&A](const double* in, double* out) {
    Eigen::Map<Eigen::VectorXd>(out, A.rows()) =
        A * Eigen::Map<const Eigen::VectorXd>(in, A.cols());
  };
}

TEST(MapEigenpairs, OfAMatrixAreFoundInOrder) {
  const Eigen::MatrixXd A = matrix();
  const std::vector<MapEigenpair> pairs = largest_eigenpairs(
      map_of(A), Eigen::VectorXd::Ones(A.rows()), {.count = 3, .basis = 30, .tolerance = 1e-10});
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_NEAR(std::abs(pairs[0].value - std::complex<double>(0.9, 0.4)), 0, 1e-9);
  EXPECT_NEAR(std::abs(pairs[1].value - 0.95), 0, 1e-7);
  for (const MapEigenpair& pair : pairs) {
    EXPECT_LT(pair.residual, 1e-8);
    EXPECT_NEAR((A * pair.vector - pair.value * pair.vector).norm(), 0, 1e-8);
  }
}

TEST(MapEigenpairs, ThatDoNotConvergeAreAFault) {
  const Eigen::MatrixXd A = matrix();
  const auto find = [&] {
    largest_eigenpairs(map_of(A), Eigen::VectorXd::Ones(A.rows()),
                       {.count = 6, .basis = 9, .tolerance = 1e-12, .most_restarts = 1});
  };
  EXPECT_THAT(test::failure_of<SolverError>(find), testing::HasSubstr("of 6 eigenvalues"));
}

}  // namespace
}  // namespace pennon::modes
