#include "dns/flag/tangent_matrix.hpp"

#include <cblas.h>
#include <lapacke.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "dns/flag/tangent_matrix_factors.hpp"

namespace pennon::dns {

// LAPACK's general band: entry (r, c) at row 2 w + r - c of column c, w the half width; the first w
// rows take the fill-in of pivoting. LAPACKE's functions that end in _work call LAPACK as they are;
// the others look for NaN in all entries first, about as many operations as a solution has.
template <int dim>
class TangentMatrix<dim>::Band {
 public:
  Band(int nodes, const std::vector<std::pair<int, int>>& coupled) : unknowns_(dim * nodes) {
    int distance = 0;
    for (const auto& [p, q] : coupled) distance = std::max(distance, std::abs(p - q));
    width_ = dim * distance + dim - 1;
    leading_ = 3 * width_ + 1;
    entries_.setZero(leading_, unknowns_);
    factors_ = entries_;
    pivots_.resize(static_cast<std::size_t>(unknowns_));
  }

  void set_zero() { entries_.setZero(); }
  double* column(int p, int q, int b) {
    const int c = dim * q + b;
    return &entries_(2 * width_ + dim * p - c, c);
  }

  bool factor() {
    factors_ = entries_;
    const lapack_int info = LAPACKE_dgbtrf_work(LAPACK_COL_MAJOR, unknowns_, unknowns_, width_,
                                                width_, factors_.data(), leading_, pivots_.data());
    assert(info >= 0);
    return info == 0;
  }
  bool factor_if_definite() { return is_definite() && factor(); }
  TangentFactors factors() const { return {}; }
  bool factor_again(const TangentFactors&) { return false; }
  void solve(Eigen::VectorXd& b) {
    [[maybe_unused]] const lapack_int info =
        LAPACKE_dgbtrs_work(LAPACK_COL_MAJOR, 'N', unknowns_, width_, width_, 1, factors_.data(),
                            leading_, pivots_.data(), b.data(), unknowns_);
    assert(info == 0);
  }

  void multiply(Eigen::VectorXd& x) {
    // The first width_ rows are room for the factors.
    product_.setZero(unknowns_);
    cblas_dgbmv(CblasColMajor, CblasNoTrans, unknowns_, unknowns_, width_, width_, 1.0,
                entries_.data() + width_, leading_, x.data(), 1, 0.0, product_.data(), 1);
    x.swap(product_);
  }

 private:
  // By the Cholesky factors of the symmetric part; entry (r, c) at row r - c of column c.
  bool is_definite() {
    lower_.setZero(width_ + 1, unknowns_);
    for (int c = 0; c < unknowns_; ++c)
      for (int r = c; r <= std::min(c + width_, unknowns_ - 1); ++r)
        lower_(r - c, c) = (entries_(2 * width_ + r - c, c) + entries_(2 * width_ + c - r, r)) / 2;
    const lapack_int info =
        LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', unknowns_, width_, lower_.data(), width_ + 1);
    assert(info >= 0);
    return info == 0;
  }

  lapack_int unknowns_, width_ = 0, leading_ = 0;
  Eigen::MatrixXd entries_, factors_, lower_;
  Eigen::VectorXd product_;
  std::vector<lapack_int> pivots_;
};

// A sparse matrix; the rows of a column are those of the coupled nodes, in order.
//
// Solved by Cholesky factors of the symmetric part S where that is positive definite: at once if
// the matrix is symmetric, else by the iteration of Concus & Golub (1976) and Widlund (1978) for
// A = S + N with N^T = -N, which solves with S once in an iteration and converges whatever N is.
// The iterations are few where N is small, as it is for a step that resolves the motion; where they
// are many, and where S is not definite, LU factors of the matrix take over.
template <int dim>
class TangentMatrix<dim>::Sparse {
 public:
  Sparse(int nodes, const std::vector<std::pair<int, int>>& pairs)
      : node_columns_(static_cast<std::size_t>(nodes) + 1, 0) {
    std::vector<std::pair<int, int>> coupled = pairs;
    std::ranges::sort(coupled, {},
                      [](const auto& pair) { return std::pair(pair.second, pair.first); });
    for (const auto& [p, q] : coupled) {
      node_rows_.push_back(p);
      ++node_columns_[static_cast<std::size_t>(q) + 1];
    }
    for (std::size_t q = 0; q + 1 < node_columns_.size(); ++q)
      node_columns_[q + 1] += node_columns_[q];
    std::vector<int> columns = {0}, rows;
    for (int q = 0; q < nodes; ++q)
      for (int b = 0; b < dim; ++b) {
        for (int k = first(q); k < first(q + 1); ++k)
          for (int a = 0; a < dim; ++a)
            rows.push_back(dim * node_rows_[static_cast<std::size_t>(k)] + a);
        columns.push_back(static_cast<int>(rows.size()));
      }
    const std::vector<double> zeros(rows.size(), 0.0);
    const auto order = Eigen::Index{dim} * nodes;
    matrix_ = Eigen::Map<const SparseTangent>(order, order, static_cast<Eigen::Index>(rows.size()),
                                              columns.data(), rows.data(), zeros.data());
    cholesky_.emplace(matrix_);
  }

  void set_zero() { matrix_.coeffs().setZero(); }
  double* column(int p, int q, int b) {
    const auto begin = node_rows_.begin() + first(q);
    const auto end = node_rows_.begin() + first(q + 1);
    const auto found = std::lower_bound(begin, end, p);
    assert(found != end && *found == p);
    return matrix_.valuePtr() + matrix_.outerIndexPtr()[dim * q + b] + dim * (found - begin);
  }

  bool factor() { return factor_if_definite() || factor_general(); }
  bool factor_if_definite() {
    uses_cholesky_ = cholesky_->factor(matrix_);
    if (uses_cholesky_) factored_ = matrix_.coeffs();
    return uses_cholesky_;
  }
  TangentFactors factors() const { return {uses_cholesky_, {factored_.begin(), factored_.end()}}; }
  bool factor_again(const TangentFactors& earlier) {
    const std::vector<double>& entries = earlier.entries;
    if (static_cast<Eigen::Index>(entries.size()) != matrix_.nonZeros() ||
        !std::ranges::all_of(entries, [](double entry) { return std::isfinite(entry); }))
      return false;
    std::ranges::copy(entries, matrix_.valuePtr());
    return earlier.is_definite ? factor_if_definite() : factor_general();
  }
  void solve(Eigen::VectorXd& b) {
    const bool is_solved = uses_cholesky_ && solve_by_cholesky(b);
    if (!is_solved && uses_cholesky_ && !factor_general())
      solution_.setConstant(b.size(), std::numeric_limits<double>::quiet_NaN());
    else if (!is_solved)
      lu_->solve(matrix_, b, solution_);
    b.swap(solution_);
  }

  void multiply(Eigen::VectorXd& x) {
    residual_.noalias() = matrix_ * x;
    x.swap(residual_);
  }
  void solve_roughly(Eigen::VectorXd& b) {
    if (!uses_cholesky_) return solve(b);
    cholesky_->solve(b, solution_);
    b.swap(solution_);
  }

 private:
  int first(int q) const { return node_columns_[static_cast<std::size_t>(q)]; }
  bool factor_general() {
    if (!lu_) lu_.emplace(matrix_);
    uses_cholesky_ = false;
    factored_ = matrix_.coeffs();
    return lu_->factor(matrix_);
  }
  bool solve_by_cholesky(const Eigen::VectorXd& b) {
    if (!cholesky_->is_exact()) return iterate(b);
    cholesky_->solve(b, solution_);
    return true;
  }
  // With z = S^-1 (b - A x) and its square z.S z the iterates are x_1 = z_0,
  // x_k+1 = x_k-1 + w (x_k - x_k-1 + z_k), 1/w = 1 + z_k.S z_k/(z_k-1.S z_k-1)/(the last w).
  // Ends with the iteration after which z will be small if it shrinks as badly as in the last two.
  bool iterate(const Eigen::VectorXd& b) {
    previous_.setZero(b.size());
    solution_.setZero(b.size());
    double w = 1;
    double first_square = 0;
    double last_square = 0;
    double last_ratio = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      residual_ = b;
      residual_.noalias() -= matrix_ * solution_;
      cholesky_->solve(residual_, correction_);
      const double square = correction_.dot(residual_);
      if (square <= 0) return square == 0;
      if (iteration == 0) first_square = last_square = square;
      const double ratio = square / last_square;
      if (iteration > 0) w = 1 / (1 + ratio / w);
      previous_ += w * (solution_ - previous_ + correction_);
      previous_.swap(solution_);
      const double next_square = square * std::max(ratio, last_ratio);
      if (iteration > 0 && next_square <= solution_error * solution_error * first_square)
        return true;
      last_square = square;
      last_ratio = iteration > 0 ? ratio : 0;
    }
    return false;
  }

  // Where more would be needed, LU factors are cheaper.
  static constexpr int most_iterations = 20;

  std::vector<int> node_rows_, node_columns_;
  SparseTangent matrix_;
  std::optional<CholeskyFactors> cholesky_;
  std::optional<LuFactors> lu_;  // from the first need
  bool uses_cholesky_ = false;
  Eigen::ArrayXd factored_;  // the entries that the factors are of
  Eigen::VectorXd solution_, previous_, residual_, correction_;
};

template <int dim>
TangentMatrix<dim>::TangentMatrix(HeldNodes held, const std::vector<std::pair<int, int>>& coupled)
    : held_(std::move(held)) {
  for (int node = 0; node < held_.nodes(); ++node) {
    number_.push_back(held_.contains(node) ? -1 : static_cast<int>(free_.size()));
    if (!held_.contains(node)) free_.push_back(node);
  }
  for (const auto& [p, q] : coupled) {
    const int row = number_[static_cast<std::size_t>(p)];
    const int column = number_[static_cast<std::size_t>(q)];
    if (row >= 0 && column >= 0) coupled_.emplace_back(row, column);
  }
  const auto nodes = static_cast<int>(free_.size());
  storage_ = std::make_unique<Storage>(nodes, coupled_);
  unknowns_.resize(Eigen::Index{dim} * nodes);
}

template <int dim>
TangentMatrix<dim>::~TangentMatrix() = default;

template <int dim>
void TangentMatrix<dim>::set_zero() {
  storage_->set_zero();
}

template <int dim>
void TangentMatrix<dim>::add(int p, int q, const Block& block) {
  const int row = number_[static_cast<std::size_t>(p)];
  const int column = number_[static_cast<std::size_t>(q)];
  if (row < 0 || column < 0) return;
  for (int b = 0; b < dim; ++b) {
    double* entries = storage_->column(row, column, b);
    for (int a = 0; a < dim; ++a) entries[a] += block(a, b);
  }
}

template <int dim>
Eigen::SparseMatrix<double> TangentMatrix<dim>::matrix() const {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [p, q] : coupled_)
    for (int b = 0; b < dim; ++b) {
      const double* column = storage_->column(p, q, b);
      for (int a = 0; a < dim; ++a) entries.emplace_back(dim * p + a, dim * q + b, column[a]);
    }
  const auto unknowns = static_cast<Eigen::Index>(dim * free_.size());
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <int dim>
bool TangentMatrix<dim>::factor() {
  return storage_->factor();
}

template <int dim>
bool TangentMatrix<dim>::factor_if_definite() {
  return storage_->factor_if_definite();
}

template <int dim>
TangentFactors TangentMatrix<dim>::factors() const {
  return storage_->factors();
}

template <int dim>
bool TangentMatrix<dim>::factor_again(const TangentFactors& earlier) {
  return storage_->factor_again(earlier);
}

template <int dim>
template <class Change>
void TangentMatrix<dim>::change_unknowns(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors,
                                         const Change& change) const {
  const auto nodes = static_cast<Eigen::Index>(free_.size());
  for (Eigen::Index n = 0; n < nodes; ++n)
    unknowns_.segment<dim>(dim * n) = vectors.col(free_[static_cast<std::size_t>(n)]);
  change(unknowns_);
  for (Eigen::Index n = 0; n < nodes; ++n)
    vectors.col(free_[static_cast<std::size_t>(n)]) = unknowns_.segment<dim>(dim * n);
}

template <int dim>
void TangentMatrix<dim>::solve(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) {
  change_unknowns(vectors, [this](Eigen::VectorXd& unknowns) { storage_->solve(unknowns); });
}

template <int dim>
void TangentMatrix<dim>::solve_roughly(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) {
  change_unknowns(vectors, [this](Eigen::VectorXd& unknowns) {
    if constexpr (dim == 3)
      storage_->solve_roughly(unknowns);
    else
      storage_->solve(unknowns);
  });
}

template <int dim>
void TangentMatrix<dim>::multiply(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) const {
  change_unknowns(vectors, [this](Eigen::VectorXd& unknowns) { storage_->multiply(unknowns); });
}

template class TangentMatrix<2>;
template class TangentMatrix<3>;

}  // namespace pennon::dns
