#include "common/linear_algebra/svd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <limits>

#include "common/errors.hpp"

namespace pennon {
namespace {

template <class Scalar>
class SingularValues : public testing::Test {
 protected:
  using Matrix = DenseMatrix<Scalar>;

  static constexpr double roundoff = 1e-14;

  static Matrix of_rank(Eigen::Index rank, Eigen::Index rows, Eigen::Index columns) {
    return Matrix::Random(rows, rank) * Matrix::Random(rank, columns);
  }
  static double distance_from_orthonormal(const Matrix& Q) {
    return (Q.adjoint() * Q - Matrix::Identity(Q.cols(), Q.cols())).norm();
  }
};

using Scalars = testing::Types<double, std::complex<double>>;
TYPED_TEST_SUITE(SingularValues, Scalars);

TYPED_TEST(SingularValues, OfTallAndWideMatricesGiveThemBack) {
  for (const auto& [rows, columns] : {std::pair{7, 3}, std::pair{3, 7}, std::pair{4, 4}}) {
    const auto A = this->of_rank(std::min(rows, columns), rows, columns);
    const auto [U, sigma, V] = thin_svd(A);
    ASSERT_EQ(sigma.size(), 3 + (rows == columns));
    ASSERT_EQ(U.cols(), sigma.size());
    ASSERT_EQ(V.cols(), sigma.size());
    EXPECT_TRUE(std::is_sorted(sigma.begin(), sigma.end(), std::greater<>()));
    EXPECT_LT((U * sigma.asDiagonal() * V.adjoint() - A).norm(), 10 * this->roundoff * A.norm());
    EXPECT_LT(this->distance_from_orthonormal(U), 10 * this->roundoff);
    EXPECT_LT(this->distance_from_orthonormal(V), 10 * this->roundoff);
    EXPECT_LT((singular_values(A) - sigma).norm(), 10 * this->roundoff * sigma[0]);
  }
}

TYPED_TEST(SingularValues, SquaredAreTheEigenvaluesOfTheGramMatrix) {
  const auto A = this->of_rank(2, 6, 4);
  const auto sigma = singular_values(A);
  // The traces of the Gram matrix and of its square, which no decomposition enters.
  const auto gram = (A.adjoint() * A).eval();
  EXPECT_NEAR(sigma.squaredNorm(), std::real(gram.trace()), 1e-13 * sigma.squaredNorm());
  EXPECT_NEAR(sigma.array().pow(4).sum(), gram.squaredNorm(), 1e-13 * gram.squaredNorm());
  EXPECT_LT(sigma[2], this->roundoff * sigma[0]);
}

TYPED_TEST(SingularValues, LastVectorsOfTheFullOneSpanWhatVanishes) {
  const auto wide = this->of_rank(2, 3, 5);
  const auto [U, sigma, V] = full_svd(wide);
  ASSERT_EQ(U.cols(), 3);
  ASSERT_EQ(V.cols(), 5);
  EXPECT_LT(this->distance_from_orthonormal(V), 10 * this->roundoff);
  EXPECT_LT((wide * V.rightCols(3)).norm(), 10 * this->roundoff * sigma[0]);
  EXPECT_LT((wide.adjoint() * U.rightCols(1)).norm(), 10 * this->roundoff * sigma[0]);
}

TYPED_TEST(SingularValues, OfWhatIsNotFiniteAreRefused) {
  auto A = this->of_rank(2, 3, 2);
  A(1, 1) = std::numeric_limits<double>::quiet_NaN();
  try {
    thin_svd(A);
    FAIL() << "NaN has no singular values";
  } catch (const SolverError& error) {
    EXPECT_STREQ(error.what(),
                 "the singular values of a matrix of 3 x 2 entries do not exist: it has entries "
                 "that are not finite");
  }
  A(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(singular_values(A), SolverError);
}

}  // namespace
}  // namespace pennon
