#include "dns/numerics/separable_solver.hpp"

#include <cblas.h>
#include <fftw3.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pennon::dns {

class ThetaBasis::Transform {
 public:
  Transform() = default;
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  virtual ~Transform() = default;
  virtual void to_coefficients(double* values, double* coefficients, int rows) = 0;
  virtual void to_values(double* coefficients, double* values, int rows) = 0;
};

// Coefficients are the real and imaginary parts of the harmonics 0 .. n/2. FFTW's plans are made by
// estimate, so that every run takes the same, for as many rows and as aligned numbers as were last
// asked for: solvers ask for no others.
class ThetaBasis::Fourier final : public ThetaBasis::Transform {
 public:
  explicit Fourier(int n) : n_(n) {}
  Fourier(const Fourier&) = delete;
  Fourier& operator=(const Fourier&) = delete;
  ~Fourier() override { forget_plans(); }

  void to_coefficients(double* values, double* coefficients, int rows) override {
    plan(rows, fftw_alignment_of(values) == 0 && fftw_alignment_of(coefficients) == 0);
    fftw_execute_dft_r2c(forward_, values, reinterpret_cast<fftw_complex*>(coefficients));
  }
  void to_values(double* coefficients, double* values, int rows) override {
    plan(rows, fftw_alignment_of(values) == 0 && fftw_alignment_of(coefficients) == 0);
    fftw_execute_dft_c2r(backward_, reinterpret_cast<fftw_complex*>(coefficients), values);
    const double scale = 1.0 / n_;
    const std::ptrdiff_t size = static_cast<std::ptrdiff_t>(rows) * n_;
    for (std::ptrdiff_t k = 0; k < size; ++k) values[k] *= scale;
  }

 private:
  void forget_plans() {
    if (forward_) fftw_destroy_plan(forward_);
    if (backward_) fftw_destroy_plan(backward_);
  }
  void plan(int rows, bool is_aligned) {
    if (rows == rows_ && is_aligned == is_aligned_) return;
    forget_plans();
    rows_ = rows;
    is_aligned_ = is_aligned;
    const int harmonics = n_ / 2 + 1;
    const auto count = static_cast<std::size_t>(rows);
    std::vector<double> values(count * static_cast<std::size_t>(n_));
    std::vector<double> coefficients(2 * count * static_cast<std::size_t>(harmonics));
    auto* complex = reinterpret_cast<fftw_complex*>(coefficients.data());
    const unsigned flags = FFTW_ESTIMATE | FFTW_DESTROY_INPUT | (is_aligned ? 0 : FFTW_UNALIGNED);
    forward_ = fftw_plan_many_dft_r2c(1, &n_, rows, values.data(), nullptr, 1, n_, complex, nullptr,
                                      1, harmonics, flags);
    backward_ = fftw_plan_many_dft_c2r(1, &n_, rows, complex, nullptr, 1, harmonics, values.data(),
                                       nullptr, 1, n_, flags);
  }

  int n_, rows_ = 0;
  bool is_aligned_ = false;
  fftw_plan forward_ = nullptr, backward_ = nullptr;
};

namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// S^-1 A = S^-1/2 (S^-1/2 A S^-1/2) S^1/2 on some columns of the rows, from the column `first`: its
// eigenvalues, and the matrices that take a row of values to its coefficients, and back.
struct Block {
  int first;
  Eigen::VectorXd eigenvalues;
  RowMatrix to_coefficients, to_values;

  // `sums`: how many values were added up into each number of the rows.
  Block(int first_column, const Eigen::VectorXd& S, const Eigen::MatrixXd& A, double sums)
      : first(first_column) {
    const Eigen::VectorXd root = S.cwiseSqrt();
    const Eigen::MatrixXd scaled =
        root.cwiseInverse().asDiagonal() * A * root.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
    eigenvalues = solver.eigenvalues();
    to_coefficients = root.asDiagonal() * solver.eigenvectors() / sums;
    to_values = solver.eigenvectors().transpose() * root.cwiseInverse().asDiagonal();
  }
};

// Whether A and S are the same from behind.
bool is_symmetric(const Eigen::VectorXd& S, const Eigen::MatrixXd& A) {
  constexpr double rounding = 1e-13;
  return S.size() % 2 == 0 &&
         (A - A.reverse()).cwiseAbs().maxCoeff() < rounding * A.cwiseAbs().maxCoeff() &&
         (S - S.reverse()).cwiseAbs().maxCoeff() < rounding * S.maxCoeff();
}

// Takes each row's value i and the one as far from the end to their sum and their difference.
void fold(double* values, std::ptrdiff_t rows, std::ptrdiff_t stride, std::ptrdiff_t n) {
  for (std::ptrdiff_t j = 0; j < rows; ++j) {
    double *front = values + j * stride, *back = front + n - 1;
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < n / 2; ++i) {
      const double sum = front[i] + back[-i];
      back[-i] = front[i] - back[-i];
      front[i] = sum;
    }
  }
}

}  // namespace

// Rows are folded while S^-1 A allows it: even vectors first, odd ones behind them, backwards.
class ThetaBasis::Folded final : public ThetaBasis::Transform {
 public:
  Folded(const Eigen::VectorXd& S, const Eigen::MatrixXd& A) : n_(static_cast<int>(S.size())) {
    Eigen::Index half = S.size() / 2;
    if (!is_symmetric(S, A)) {
      blocks_.emplace_back(0, S, A, 1.0);
      return;
    }
    folds_ = 1;
    const Eigen::VectorXd part = S.head(half);
    const Eigen::MatrixXd near = A.topLeftCorner(half, half);
    const Eigen::MatrixXd far = A.topRightCorner(half, half).rowwise().reverse();
    const Eigen::MatrixXd even = near + far, odd = near - far;
    if (!is_symmetric(part, even) || !is_symmetric(part, odd)) {
      blocks_.emplace_back(0, part, even, 2.0);
      blocks_.emplace_back(static_cast<int>(half), part.reverse(), odd.reverse(), 2.0);
      return;
    }
    folds_ = 2;
    const Eigen::Index quarter = half / 2;
    const Eigen::VectorXd piece = part.head(quarter);
    int first = 0;
    for (const Eigen::MatrixXd& matrix : {even, Eigen::MatrixXd(odd.reverse())}) {
      const Eigen::MatrixXd near_in_half = matrix.topLeftCorner(quarter, quarter);
      const Eigen::MatrixXd far_in_half =
          matrix.topRightCorner(quarter, quarter).rowwise().reverse();
      const Eigen::MatrixXd odd_in_half = (near_in_half - far_in_half).reverse();
      blocks_.emplace_back(first, piece, near_in_half + far_in_half, 4.0);
      blocks_.emplace_back(first + static_cast<int>(quarter), piece.reverse(), odd_in_half, 4.0);
      first += static_cast<int>(half);
    }
  }

  Eigen::VectorXd eigenvalues() const {
    Eigen::VectorXd all(n_);
    for (const Block& block : blocks_)
      all.segment(block.first, block.eigenvalues.size()) = block.eigenvalues;
    return all;
  }

  void to_coefficients(double* values, double* coefficients, int rows) override {
    if (folds_ > 0) fold(values, rows, n_, n_);
    if (folds_ > 1) fold(values, 2 * static_cast<std::ptrdiff_t>(rows), n_ / 2, n_ / 2);
    for (const Block& block : blocks_)
      multiply(values + block.first, rows, block.to_coefficients, coefficients + block.first);
  }
  void to_values(double* coefficients, double* values, int rows) override {
    for (const Block& block : blocks_)
      multiply(coefficients + block.first, rows, block.to_values, values + block.first);
    if (folds_ > 1) fold(values, 2 * static_cast<std::ptrdiff_t>(rows), n_ / 2, n_ / 2);
    if (folds_ > 0) fold(values, rows, n_, n_);
  }

 private:
  void multiply(const double* rows, int count, const RowMatrix& matrix, double* result) const {
    const int n = static_cast<int>(matrix.rows());
    cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, n, n, 1.0, rows, n_,
                matrix.data(), n, 0.0, result, n_);
  }

  int n_, folds_ = 0;
  std::vector<Block> blocks_;
};

ThetaBasis::ThetaBasis(const Eigen::VectorXd& S, const Eigen::MatrixXd& A, bool is_circulant) {
  const Eigen::Index n = S.size();
  if (is_circulant) {
    transform_ = std::make_unique<Fourier>(static_cast<int>(n));
    eigenvalues_.resize(2 * (n / 2 + 1));
    for (Eigen::Index m = 0; m <= n / 2; ++m) {
      double eigenvalue = 0;
      for (Eigen::Index i = 0; i < n; ++i)
        eigenvalue += A(0, i) / S[0] *
                      std::cos(2 * std::numbers::pi * static_cast<double>(m * i % n) /
                               static_cast<double>(n));
      eigenvalues_[2 * m] = eigenvalues_[2 * m + 1] = eigenvalue;
    }
  } else {
    auto folded = std::make_unique<Folded>(S, A);
    eigenvalues_ = folded->eigenvalues();
    transform_ = std::move(folded);
  }
}

ThetaBasis::~ThetaBasis() = default;
ThetaBasis::ThetaBasis(ThetaBasis&&) noexcept = default;
ThetaBasis& ThetaBasis::operator=(ThetaBasis&&) noexcept = default;

void ThetaBasis::to_coefficients(double* values, double* coefficients, int rows) {
  transform_->to_coefficients(values, coefficients, rows);
}

void ThetaBasis::to_values(double* coefficients, double* values, int rows) {
  transform_->to_values(coefficients, values, rows);
}

SeparableSolver::SeparableSolver(const Tridiagonal& along_rho, ThetaBasis along_theta)
    : basis_(std::move(along_theta)), lower_(along_rho.lower), upper_(along_rho.upper) {
  const Eigen::Index n = along_rho.diagonal.size();
  inverse_pivot_.resize(n, basis_.eigenvalues().size());
  coefficients_.resize(n, basis_.eigenvalues().size());
  for (Eigen::Index j = 0; j < n; ++j) {
    inverse_pivot_.row(j) = along_rho.diagonal[j] + basis_.eigenvalues().transpose().array();
    if (j > 0) inverse_pivot_.row(j) -= lower_[j] * upper_[j - 1] * inverse_pivot_.row(j - 1);
    inverse_pivot_.row(j) = inverse_pivot_.row(j).inverse();
  }
}

void SeparableSolver::solve(double* values) {
  const Eigen::Index n_rho = inverse_pivot_.rows(), n_theta = inverse_pivot_.cols();
  basis_.to_coefficients(values, coefficients_.data(), static_cast<int>(n_rho));
  // Columns in blocks that stay in the cache between the elimination and the substitution.
  constexpr Eigen::Index block = 32;
  for (Eigen::Index first = 0; first < n_theta; first += block) {
    const Eigen::Index count = std::min(block, n_theta - first);
    const auto f = [&](Eigen::Index j) { return coefficients_.row(j).segment(first, count); };
    const auto inverse = [&](Eigen::Index j) {
      return inverse_pivot_.row(j).segment(first, count);
    };
    f(0) *= inverse(0);
    for (Eigen::Index j = 1; j < n_rho; ++j) f(j) = (f(j) - lower_[j] * f(j - 1)) * inverse(j);
    for (Eigen::Index j = n_rho - 2; j >= 0; --j) f(j) -= upper_[j] * inverse(j) * f(j + 1);
  }
  basis_.to_values(coefficients_.data(), values, static_cast<int>(n_rho));
}

}  // namespace pennon::dns
