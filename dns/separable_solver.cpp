#include "dns/separable_solver.hpp"

#include <cblas.h>
#include <fftw3.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace pennon::dns {

class ThetaBasis::Transform {
 public:
  Transform() = default;
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  virtual ~Transform() = default;
  virtual void to_coefficients(double* values, int rows) = 0;
  virtual void to_values(double* coefficients, int rows) = 0;
};

// FFTW's half-complex transform. Its plans are made by estimate, so that every run takes the same.
class ThetaBasis::Fourier final : public ThetaBasis::Transform {
 public:
  explicit Fourier(int n) : n_(n) {
    std::vector<double> row(static_cast<std::size_t>(n));
    const auto plan = [&](fftw_r2r_kind kind) {
      return fftw_plan_r2r_1d(n, row.data(), row.data(), kind, FFTW_ESTIMATE | FFTW_UNALIGNED);
    };
    forward_ = plan(FFTW_R2HC);
    backward_ = plan(FFTW_HC2R);
  }
  ~Fourier() override {
    fftw_destroy_plan(forward_);
    fftw_destroy_plan(backward_);
  }
  void to_coefficients(double* values, int rows) override {
    for (int j = 0; j < rows; ++j, values += n_) {
      fftw_execute_r2r(forward_, values, values);
      for (int i = 0; i < n_; ++i) values[i] /= n_;
    }
  }
  void to_values(double* coefficients, int rows) override {
    for (int j = 0; j < rows; ++j, coefficients += n_)
      fftw_execute_r2r(backward_, coefficients, coefficients);
  }

 private:
  int n_;
  fftw_plan forward_, backward_;
};

namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// result = rows * matrix, all row by row; `stride` between the rows of each.
void multiply(const double* rows, int count, int stride, const RowMatrix& matrix, double* result) {
  const int n = static_cast<int>(matrix.rows());
  cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, count, n, n, 1.0, rows, stride,
              matrix.data(), n, 0.0, result, stride);
}

// Eigenvectors of S^-1 A = S^-1/2 (S^-1/2 A S^-1/2) S^1/2: those that take a row of values to its
// coefficients, and back.
struct Eigenvectors {
  Eigen::VectorXd values;
  RowMatrix to_coefficients, to_values;

  Eigenvectors(const Eigen::VectorXd& S, const Eigen::MatrixXd& A) {
    const Eigen::VectorXd root = S.cwiseSqrt();
    const Eigen::MatrixXd scaled =
        root.cwiseInverse().asDiagonal() * A * root.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled);
    values = solver.eigenvalues();
    to_coefficients = root.asDiagonal() * solver.eigenvectors();
    to_values = solver.eigenvectors().transpose() * root.cwiseInverse().asDiagonal();
  }
};

}  // namespace

class ThetaBasis::Dense final : public ThetaBasis::Transform {
 public:
  Dense(const Eigen::VectorXd& S, const Eigen::MatrixXd& A) : vectors_(S, A) {}
  const Eigen::VectorXd& eigenvalues() const { return vectors_.values; }

  void to_coefficients(double* values, int rows) override {
    apply(vectors_.to_coefficients, values, rows);
  }
  void to_values(double* coefficients, int rows) override {
    apply(vectors_.to_values, coefficients, rows);
  }

 private:
  void apply(const RowMatrix& matrix, double* values, int rows) {
    const int n = static_cast<int>(matrix.rows());
    work_.assign(values, values + static_cast<std::ptrdiff_t>(rows) * n);
    multiply(work_.data(), rows, n, matrix, values);
  }
  Eigenvectors vectors_;
  std::vector<double> work_;
};

// Where S and A do not change under i -> n - 1 - i (the flag's two sides), eigenvectors are even or
// odd, and two matrices of half the size do.
class ThetaBasis::Parity final : public ThetaBasis::Transform {
 public:
  Parity(const Eigen::VectorXd& S, const Eigen::MatrixXd& A)
      : half_(static_cast<int>(S.size()) / 2),
        even_(S.head(half_), folded(A, 1)),
        odd_(S.head(half_), folded(A, -1)) {}
  Eigen::VectorXd eigenvalues() const {
    Eigen::VectorXd all(2 * half_);
    all << even_.values, odd_.values;
    return all;
  }

  void to_coefficients(double* values, int rows) override {
    const std::ptrdiff_t n = 2 * static_cast<std::ptrdiff_t>(half_);
    work_.resize(static_cast<std::size_t>(rows * n));
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (int i = 0; i < half_; ++i) {
        const double a = values[j * n + i], b = values[j * n + n - 1 - i];
        work_[static_cast<std::size_t>(j * n + i)] = (a + b) / 2;
        work_[static_cast<std::size_t>(j * n + half_ + i)] = (a - b) / 2;
      }
    multiply(work_.data(), rows, 2 * half_, even_.to_coefficients, values);
    multiply(work_.data() + half_, rows, 2 * half_, odd_.to_coefficients, values + half_);
  }
  void to_values(double* coefficients, int rows) override {
    const std::ptrdiff_t n = 2 * static_cast<std::ptrdiff_t>(half_);
    work_.resize(static_cast<std::size_t>(rows * n));
    multiply(coefficients, rows, 2 * half_, even_.to_values, work_.data());
    multiply(coefficients + half_, rows, 2 * half_, odd_.to_values, work_.data() + half_);
    for (std::ptrdiff_t j = 0; j < rows; ++j)
      for (int i = 0; i < half_; ++i) {
        const double even = work_[static_cast<std::size_t>(j * n + i)];
        const double odd = work_[static_cast<std::size_t>(j * n + half_ + i)];
        coefficients[j * n + i] = even + odd;
        coefficients[j * n + n - 1 - i] = even - odd;
      }
  }

 private:
  // A on the even (sign = 1) or odd (-1) rows, by their first half.
  Eigen::MatrixXd folded(const Eigen::MatrixXd& A, double sign) const {
    return A.topLeftCorner(half_, half_) +
           sign * A.topRightCorner(half_, half_).rowwise().reverse();
  }
  int half_;
  Eigenvectors even_, odd_;
  std::vector<double> work_;
};

ThetaBasis::ThetaBasis(const Eigen::VectorXd& S, const Eigen::MatrixXd& A, bool is_circulant) {
  const Eigen::Index n = S.size();
  const auto is_symmetric = [&] {
    const double size = A.cwiseAbs().maxCoeff();
    constexpr double rounding = 1e-13;
    return n % 2 == 0 && (A - A.reverse()).cwiseAbs().maxCoeff() < rounding * size &&
           (S - S.reverse()).cwiseAbs().maxCoeff() < rounding * S.maxCoeff();
  };
  if (is_circulant) {
    transform_ = std::make_unique<Fourier>(static_cast<int>(n));
    eigenvalues_.resize(n);
    for (Eigen::Index m = 0; m < n; ++m) {  // half-complex: cosines 0 .. n/2, then sines backwards
      eigenvalues_[m] = 0;
      for (Eigen::Index i = 0; i < n; ++i)
        eigenvalues_[m] += A(0, i) / S[0] *
                           std::cos(2 * std::numbers::pi * static_cast<double>(m * i % n) /
                                    static_cast<double>(n));
    }
  } else if (is_symmetric()) {
    auto parity = std::make_unique<Parity>(S, A);
    eigenvalues_ = parity->eigenvalues();
    transform_ = std::move(parity);
  } else {
    auto dense = std::make_unique<Dense>(S, A);
    eigenvalues_ = dense->eigenvalues();
    transform_ = std::move(dense);
  }
}

ThetaBasis::~ThetaBasis() = default;
ThetaBasis::ThetaBasis(ThetaBasis&&) noexcept = default;
ThetaBasis& ThetaBasis::operator=(ThetaBasis&&) noexcept = default;

void ThetaBasis::to_coefficients(double* values, int rows) {
  transform_->to_coefficients(values, rows);
}

void ThetaBasis::to_values(double* coefficients, int rows) {
  transform_->to_values(coefficients, rows);
}

SeparableSolver::SeparableSolver(const Tridiagonal& along_rho, ThetaBasis along_theta)
    : basis_(std::move(along_theta)), lower_(along_rho.lower), upper_(along_rho.upper) {
  const Eigen::Index n = along_rho.diagonal.size();
  inverse_pivot_.resize(n, basis_.eigenvalues().size());
  for (Eigen::Index j = 0; j < n; ++j) {
    inverse_pivot_.row(j) = along_rho.diagonal[j] + basis_.eigenvalues().transpose().array();
    if (j > 0) inverse_pivot_.row(j) -= lower_[j] * upper_[j - 1] * inverse_pivot_.row(j - 1);
    inverse_pivot_.row(j) = inverse_pivot_.row(j).inverse();
  }
}

void SeparableSolver::solve(double* values) {
  const Eigen::Index n_rho = inverse_pivot_.rows(), n_theta = inverse_pivot_.cols();
  basis_.to_coefficients(values, static_cast<int>(n_rho));
  Eigen::Map<Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> f(values, n_rho,
                                                                                      n_theta);
  f.row(0) *= inverse_pivot_.row(0);
  for (Eigen::Index j = 1; j < n_rho; ++j)
    f.row(j) = (f.row(j) - lower_[j] * f.row(j - 1)) * inverse_pivot_.row(j);
  for (Eigen::Index j = n_rho - 2; j >= 0; --j)
    f.row(j) -= upper_[j] * inverse_pivot_.row(j) * f.row(j + 1);
  basis_.to_values(values, static_cast<int>(n_rho));
}

}  // namespace pennon::dns
