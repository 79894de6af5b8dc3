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

CholeskyFactors::CholeskyFactors(const SparseTangent& pattern) {
  cholmod_start(&common_);
  common_.print = 0;  // its messages: the status says all
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.quick_return_if_not_posdef = 1;
  const auto order = static_cast<std::size_t>(pattern.cols());
  const auto entries = static_cast<std::size_t>(pattern.nonZeros());
  lower_ = cholmod_allocate_sparse(order, order, (entries + order) / 2, 1, 1, -1, CHOLMOD_REAL,
                                   &common_);
  if (lower_ == nullptr) throw std::bad_alloc();
  auto* first = static_cast<int*>(lower_->p);
  auto* rows = static_cast<int*>(lower_->i);
  const int* begins = pattern.outerIndexPtr();
  const int* rows_of_pattern = pattern.innerIndexPtr();
  for (int column = 0; column < pattern.cols(); ++column) {
    first[column] = static_cast<int>(pairs_.size());
    for (int k = begins[column]; k < begins[column + 1]; ++k) {
      const int row = rows_of_pattern[k];
      if (row < column) continue;
      const int* const end = rows_of_pattern + begins[row + 1];
      const int* const mirrored = std::lower_bound(rows_of_pattern + begins[row], end, column);
      assert(mirrored != end && *mirrored == column);
      rows[pairs_.size()] = row;
      pairs_.push_back({k, mirrored - rows_of_pattern});
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

bool CholeskyFactors::factor(const SparseTangent& matrix) {
  constexpr double rounding = 1e-12;  // of the largest entry
  auto* entries = static_cast<double*>(lower_->x);
  const double* values = matrix.valuePtr();
  double largest = 0;
  double largest_difference = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const double entry = values[pairs_[k].entry];
    const double mirrored = values[pairs_[k].mirrored];
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

LuFactors::LuFactors(const SparseTangent& pattern)
    : integers_(static_cast<std::size_t>(pattern.cols())), reals_(integers_.size()) {
  umfpack_di_defaults(control_.data());
  control_[UMFPACK_IRSTEP] = 0;  // Newton's method refines by itself
  const auto order = static_cast<int>(pattern.cols());
  umfpack_di_symbolic(order, order, pattern.outerIndexPtr(), pattern.innerIndexPtr(), nullptr,
                      &symbolic_, control_.data(), nullptr);
}

LuFactors::~LuFactors() {
  umfpack_di_free_symbolic(&symbolic_);
  umfpack_di_free_numeric(&numeric_);
}

bool LuFactors::factor(const SparseTangent& matrix) {
  umfpack_di_free_numeric(&numeric_);
  return umfpack_di_numeric(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(),
                            symbolic_, &numeric_, control_.data(), nullptr) == UMFPACK_OK;
}

void LuFactors::solve(const SparseTangent& matrix, const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  x.resize(b.size());
  umfpack_di_wsolve(UMFPACK_A, matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(),
                    x.data(), b.data(), numeric_, control_.data(), nullptr, integers_.data(),
                    reals_.data());
}

}  // namespace pennon::dns
