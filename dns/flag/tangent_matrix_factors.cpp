#include "dns/flag/tangent_matrix_factors.hpp"

#include <omp.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <new>

namespace pennon::dns {
namespace {

// CHOLMOD asks for four threads for each front, however small: with as many idle processors it is
// no faster, with fewer several times slower. While this lives no parallel region opens.
class OneThread {
 public:
  OneThread() { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_ = omp_get_max_active_levels();
};

}  // namespace

void CompressedColumns::evaluate_residual(const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                                          Eigen::VectorXd& residual) const {
  residual = b;
  subtract_product(x, residual);
}

void CompressedColumns::subtract_product(const Eigen::VectorXd& x, Eigen::VectorXd& sum) const {
  for (int column = 0; column < order(); ++column)
    for (int k = columns[static_cast<std::size_t>(column)];
         k < columns[static_cast<std::size_t>(column) + 1]; ++k)
      sum[rows[static_cast<std::size_t>(k)]] -= values[static_cast<std::size_t>(k)] * x[column];
}

CholeskyFactors::CholeskyFactors(const CompressedColumns& pattern) {
  cholmod_start(&common_);
  common_.print = 0;  // its messages: the status says all
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.quick_return_if_not_posdef = 1;
  const auto order = static_cast<std::size_t>(pattern.order());
  lower_ = cholmod_allocate_sparse(order, order, (pattern.rows.size() + order) / 2, 1, 1, -1,
                                   CHOLMOD_REAL, &common_);
  if (lower_ == nullptr) throw std::bad_alloc();
  auto* first = static_cast<int*>(lower_->p);
  auto* rows = static_cast<int*>(lower_->i);
  const auto entries = [&](int column) {
    return std::pair(pattern.columns[static_cast<std::size_t>(column)],
                     pattern.columns[static_cast<std::size_t>(column) + 1]);
  };
  for (int column = 0; column < pattern.order(); ++column) {
    first[column] = static_cast<int>(pairs_.size());
    const auto [begin, end] = entries(column);
    for (int k = begin; k < end; ++k) {
      const int row = pattern.rows[static_cast<std::size_t>(k)];
      if (row < column) continue;
      const auto [mirror_begin, mirror_end] = entries(row);
      const auto mirrored = std::lower_bound(pattern.rows.begin() + mirror_begin,
                                             pattern.rows.begin() + mirror_end, column);
      assert(mirrored != pattern.rows.begin() + mirror_end && *mirrored == column);
      rows[pairs_.size()] = row;
      pairs_.push_back(
          {static_cast<std::size_t>(k), static_cast<std::size_t>(mirrored - pattern.rows.begin())});
    }
  }
  first[order] = static_cast<int>(pairs_.size());
  factors_ = cholmod_analyze(lower_, &common_);
  if (factors_ == nullptr) throw std::bad_alloc();
}

CholeskyFactors::~CholeskyFactors() {
  cholmod_free_dense(&solution_, &common_);
  cholmod_free_dense(&y_, &common_);
  cholmod_free_dense(&e_, &common_);
  cholmod_free_factor(&factors_, &common_);
  cholmod_free_sparse(&lower_, &common_);
  cholmod_finish(&common_);
}

bool CholeskyFactors::factor(const CompressedColumns& matrix) {
  constexpr double rounding = 1e-12;  // of the largest entry
  auto* entries = static_cast<double*>(lower_->x);
  double largest = 0;
  double largest_difference = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double entry = matrix.values[pairs_[k].entry];
    const double mirrored = matrix.values[pairs_[k].mirrored];
    entries[k] = (entry + mirrored) / 2;
    largest = std::max(largest, std::abs(entry));
    largest_difference = std::max(largest_difference, std::abs(entry - mirrored));
  }
  is_exact_ = largest_difference <= rounding * largest;
  const OneThread one_thread;
  cholmod_factorize(lower_, factors_, &common_);
  if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  return common_.status == CHOLMOD_OK;
}

void CholeskyFactors::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  const OneThread one_thread;
  const auto order = static_cast<std::size_t>(b.size());
  cholmod_dense right{
      order,
      1,
      order,
      order,
      const_cast<double*>(b.data()),  // NOLINT(cppcoreguidelines-pro-type-const-cast)
      nullptr,
      CHOLMOD_REAL,
      CHOLMOD_DOUBLE};
  if (cholmod_solve2(CHOLMOD_A, factors_, &right, nullptr, &solution_, nullptr, &y_, &e_,
                     &common_) == 0)
    throw std::bad_alloc();
  x = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(solution_->x), b.size());
}

LuFactors::LuFactors(const CompressedColumns& pattern)
    : integers_(pattern.columns.size() - 1), reals_(pattern.columns.size() - 1) {
  umfpack_di_defaults(control_.data());
  control_[UMFPACK_IRSTEP] = 0;  // Newton's method refines by itself
  umfpack_di_symbolic(pattern.order(), pattern.order(), pattern.columns.data(), pattern.rows.data(),
                      nullptr, &symbolic_, control_.data(), nullptr);
}

LuFactors::~LuFactors() {
  umfpack_di_free_symbolic(&symbolic_);
  umfpack_di_free_numeric(&numeric_);
}

bool LuFactors::factor(const CompressedColumns& matrix) {
  umfpack_di_free_numeric(&numeric_);
  return umfpack_di_numeric(matrix.columns.data(), matrix.rows.data(), matrix.values.data(),
                            symbolic_, &numeric_, control_.data(), nullptr) == UMFPACK_OK;
}

void LuFactors::solve(const CompressedColumns& matrix, const Eigen::VectorXd& b,
                      Eigen::VectorXd& x) {
  x.resize(b.size());
  umfpack_di_wsolve(UMFPACK_A, matrix.columns.data(), matrix.rows.data(), matrix.values.data(),
                    x.data(), b.data(), numeric_, control_.data(), nullptr, integers_.data(),
                    reals_.data());
}

}  // namespace pennon::dns
