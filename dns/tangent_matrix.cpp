#include "dns/tangent_matrix.hpp"

#include <umfpack.h>

#include <algorithm>
#include <cassert>
#include <cmath>

extern "C" {
void dgbtrf_(const int* rows, const int* columns, const int* below, const int* above, double* band,
             const int* leading, int* pivots, int* info);
void dgbtrs_(const char* transposed, const int* order, const int* below, const int* above,
             const int* right_hand_sides, const double* band, const int* leading, const int* pivots,
             double* b, const int* leading_b, int* info, std::size_t);
}

namespace pennon::dns {

// LAPACK's general band: entry (r, c) at row 2 w + r - c of column c, w the half width; the first w
// rows take the fill-in of pivoting.
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
    int info = 0;
    dgbtrf_(&unknowns_, &unknowns_, &width_, &width_, factors_.data(), &leading_, pivots_.data(),
            &info);
    assert(info >= 0);
    return info == 0;
  }
  void solve(Eigen::VectorXd& b) {
    constexpr int one = 1;
    int info = 0;
    dgbtrs_("N", &unknowns_, &width_, &width_, &one, factors_.data(), &leading_, pivots_.data(),
            b.data(), &unknowns_, &info, 1);
    assert(info == 0);
  }

 private:
  int unknowns_, width_ = 0, leading_ = 0;
  Eigen::MatrixXd entries_, factors_;
  std::vector<int> pivots_;
};

// Compressed columns; the rows of a column are those of the coupled nodes, in order.
template <int dim>
class TangentMatrix<dim>::Sparse {
 public:
  Sparse(int nodes, const std::vector<std::pair<int, int>>& pairs) : order_(dim * nodes) {
    std::vector<std::pair<int, int>> coupled = pairs;
    std::ranges::sort(coupled, {},
                      [](const auto& pair) { return std::pair(pair.second, pair.first); });
    first_.assign(static_cast<std::size_t>(nodes) + 1, 0);
    for (const auto& [p, q] : coupled) {
      rows_.push_back(p);
      ++first_[static_cast<std::size_t>(q) + 1];
    }
    for (std::size_t q = 0; q + 1 < first_.size(); ++q) first_[q + 1] += first_[q];
    columns_.push_back(0);
    for (int q = 0; q < nodes; ++q)
      for (int b = 0; b < dim; ++b) {
        for (int k = first(q); k < first(q + 1); ++k)
          for (int a = 0; a < dim; ++a) row_indices_.push_back(dim * row(k) + a);
        columns_.push_back(static_cast<int>(row_indices_.size()));
      }
    values_.assign(row_indices_.size(), 0);
    solution_.resize(order_);
    reals_.resize(order_);
    integers_.resize(static_cast<std::size_t>(order_));
    umfpack_di_defaults(control_);
    control_[UMFPACK_IRSTEP] = 0;  // Newton's method refines by itself
    umfpack_di_symbolic(order_, order_, columns_.data(), row_indices_.data(), nullptr, &symbolic_,
                        control_, nullptr);
  }
  ~Sparse() {
    umfpack_di_free_symbolic(&symbolic_);
    umfpack_di_free_numeric(&numeric_);
  }
  Sparse(const Sparse&) = delete;
  Sparse& operator=(const Sparse&) = delete;

  void set_zero() { std::ranges::fill(values_, 0.0); }
  double* column(int p, int q, int b) {
    const auto begin = rows_.begin() + first(q);
    const auto end = rows_.begin() + first(q + 1);
    const auto found = std::lower_bound(begin, end, p);
    assert(found != end && *found == p);
    const auto first_row = static_cast<std::size_t>(
        columns_[dim * static_cast<std::size_t>(q) + static_cast<std::size_t>(b)]);
    return &values_[first_row + dim * static_cast<std::size_t>(found - begin)];
  }

  bool factor() {
    umfpack_di_free_numeric(&numeric_);
    const int status = umfpack_di_numeric(columns_.data(), row_indices_.data(), values_.data(),
                                          symbolic_, &numeric_, control_, nullptr);
    return status == UMFPACK_OK;
  }
  void solve(Eigen::VectorXd& b) {
    umfpack_di_wsolve(UMFPACK_A, columns_.data(), row_indices_.data(), values_.data(),
                      solution_.data(), b.data(), numeric_, control_, nullptr, integers_.data(),
                      reals_.data());
    b = solution_;
  }

 private:
  int first(int q) const { return first_[static_cast<std::size_t>(q)]; }
  int row(int k) const { return rows_[static_cast<std::size_t>(k)]; }

  int order_;
  std::vector<int> rows_, first_;           // of nodes
  std::vector<int> row_indices_, columns_;  // of unknowns
  std::vector<double> values_;
  Eigen::VectorXd solution_, reals_;  // and work space
  std::vector<int> integers_;
  double control_[UMFPACK_CONTROL];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

template <int dim>
TangentMatrix<dim>::TangentMatrix(const std::vector<bool>& is_held,
                                  const std::vector<std::pair<int, int>>& coupled) {
  for (std::size_t node = 0; node < is_held.size(); ++node) {
    number_.push_back(is_held[node] ? -1 : static_cast<int>(free_.size()));
    if (!is_held[node]) free_.push_back(static_cast<int>(node));
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
void TangentMatrix<dim>::solve(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) {
  const auto nodes = static_cast<Eigen::Index>(free_.size());
  for (Eigen::Index n = 0; n < nodes; ++n)
    unknowns_.segment<dim>(dim * n) = vectors.col(free_[static_cast<std::size_t>(n)]);
  storage_->solve(unknowns_);
  for (Eigen::Index n = 0; n < nodes; ++n)
    vectors.col(free_[static_cast<std::size_t>(n)]) = unknowns_.segment<dim>(dim * n);
}

template class TangentMatrix<2>;
template class TangentMatrix<3>;

}  // namespace pennon::dns
