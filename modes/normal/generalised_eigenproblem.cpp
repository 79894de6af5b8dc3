#include "modes/normal/generalised_eigenproblem.hpp"

#include <arpack.h>
#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

// Each correction gains the digits that the multiplied-out K keeps of its smallest energies.
constexpr int most_corrections = 8;
constexpr double sufficient_residual = 1e-12;

// The products ARPACK and the corrections need.
class Operators {
 public:
  Operators(const GeneralisedEigenproblem& problem, double shift, const std::string& what)
      : problem_(problem), mass_(problem.E.transpose() * problem.R * problem.E) {
    const ExtendedSparse stiffness = problem.E.transpose() * problem.S * problem.E;
    factors_.compute(stiffness + static_cast<Extended>(shift) * mass_);
    if (factors_.info() != Eigen::Success || !(factors_.vectorD().minCoeff() > 0))
      throw SolverError(
          fmt::format("{}: the stiffness with shift {} is not positive definite; take fewer "
                      "elements, a longer spanwise wave, or tension and bending that differ less",
                      what, shift));
  }

  // K v, from its factors.
  ExtendedMatrix stiffness_times(const ExtendedMatrix& v) const {
    return problem_.E.transpose() * (problem_.S * (problem_.E * v));
  }
  // M v.
  ExtendedMatrix mass_times(const ExtendedMatrix& v) const { return mass_ * v; }
  // (K + s M)^-1 v, to the accuracy of the multiplied-out K.
  ExtendedMatrix solve(const ExtendedMatrix& v) const { return factors_.solve(v); }

  // The largest (v^T M v)^1/2 of the columns.
  double largest_norm(const ExtendedMatrix& v) const {
    const ExtendedVector squares = v.cwiseProduct(mass_times(v)).colwise().sum();
    return static_cast<double>(std::sqrt(squares.maxCoeff()));
  }

 private:
  const GeneralisedEigenproblem& problem_;
  ExtendedSparse mass_;
  Eigen::SimplicialLDLT<ExtendedSparse> factors_;
};

// One run of ARPACK: its arrays, and the order in which it wants to be called.
class Lanczos {
 public:
  Lanczos(a_int size, a_int count)
      : size_(size),
        count_(count),
        basis_(std::min(size, std::max(2 * count + 1, count + smallest_surplus))),
        residual_(Eigen::VectorXd::LinSpaced(size, 1, 2)),
        vectors_(size, basis_),
        work_(3 * size),
        inner_work_(basis_ * (basis_ + 8)) {}

  // The vectors ARPACK found, one a column.
  Eigen::MatrixXd run(const Operators& operators, const std::string& what) {
    a_int task = 0;
    while (true) {
      dsaupd_c(&task, "G", size_, "LM", count_, to_machine_precision, residual_.data(), basis_,
               vectors_.data(), size_, parameters_.data(), pointers_.data(), work_.data(),
               inner_work_.data(), static_cast<a_int>(inner_work_.size()), &info_);
      if (task == 99) break;
      apply(task, operators);
    }
    if (info_ != 0 || parameters_[4] < count_)
      throw SolverError(
          fmt::format("{}: ARPACK converged {} of {} modes in {} iterations (info {}): their "
                      "frequencies differ by too little (a very short spanwise wave does that), or "
                      "they are too many; take a longer wave or ask for fewer modes",
                      what, parameters_[4], count_, parameters_[2], info_));
    return extract(what);
  }

 private:
  static constexpr a_int smallest_surplus = 20;
  static constexpr a_int largest_iterations = 1000;
  static constexpr double to_machine_precision = 0;

  auto column(int pointer) { return work_.segment(pointers_[pointer] - 1, size_); }

  void apply(a_int task, const Operators& operators) {
    const auto extended = [this](int pointer) { return column(pointer).cast<Extended>(); };
    if (task == -1)
      column(1) = operators.solve(operators.mass_times(extended(0))).cast<double>();
    else if (task == 1)
      column(1) = operators.solve(extended(2)).cast<double>();
    else if (task == 2)
      column(1) = operators.mass_times(extended(0)).cast<double>();
    else
      assert(false && "ARPACK asked for a product that this mode does not have");
  }

  Eigen::MatrixXd extract(const std::string& what) {
    Eigen::VectorXd theta(count_);
    Eigen::MatrixXd found(size_, count_);
    std::vector<a_int> select(static_cast<std::size_t>(basis_));
    a_int info = 0;
    dseupd_c(1, "A", select.data(), theta.data(), found.data(), size_, 0.0, "G", size_, "LM",
             count_, to_machine_precision, residual_.data(), basis_, vectors_.data(), size_,
             parameters_.data(), pointers_.data(), work_.data(), inner_work_.data(),
             static_cast<a_int>(inner_work_.size()), &info);
    if (info != 0)
      throw SolverError(fmt::format("{}: ARPACK gave no vectors (info {})", what, info));
    return found;
  }

  a_int size_, count_, basis_;
  a_int info_ = 1;  // 1: the start vector is ours, so that each run gives the same bits
  Eigen::VectorXd residual_;
  Eigen::MatrixXd vectors_;
  Eigen::VectorXd work_, inner_work_;
  std::array<a_int, 11> parameters_ = {1, 0, largest_iterations, 1, 0, 0, 3, 0, 0, 0, 0};
  std::array<a_int, 11> pointers_ = {};
};

void fix_sign(Eigen::Ref<ExtendedVector> v) {
  constexpr Extended share = 0.01L;
  const Extended threshold = share * v.cwiseAbs().maxCoeff();
  for (Eigen::Index i = v.size() - 1; i >= 0; --i)
    if (std::abs(v[i]) >= threshold) {
      if (v[i] < 0) v = -v;
      return;
    }
}

// The best approximations of eigenpairs among the combinations of the columns of `basis`.
Eigenpairs rayleigh_ritz(const Operators& operators, const ExtendedMatrix& basis,
                         const std::string& what) {
  const ExtendedMatrix K = basis.transpose() * operators.stiffness_times(basis);
  const ExtendedMatrix M = basis.transpose() * operators.mass_times(basis);
  const Eigen::GeneralizedSelfAdjointEigenSolver<ExtendedMatrix> ritz(K, M);
  if (ritz.info() != Eigen::Success)
    throw SolverError(
        fmt::format("{}: the {} modes ARPACK found are not independent", what, basis.cols()));
  return {ritz.eigenvalues(), basis * ritz.eigenvectors()};
}

// (K + s M)^-1 (K v - lambda M v).
ExtendedMatrix correction_of(const Eigenpairs& pairs, const Operators& operators) {
  const ExtendedMatrix defect = operators.stiffness_times(pairs.vectors) -
                                operators.mass_times(pairs.vectors) * pairs.lambda.asDiagonal();
  return operators.solve(defect);
}

}  // namespace

Eigenpairs lowest_eigenpairs(const GeneralisedEigenproblem& problem, int count, double shift,
                             const std::string& what) {
  const auto size = static_cast<a_int>(problem.E.cols());
  assert(count > 0 && count < size && shift > 0);
  const Operators operators(problem, shift, what);
  const Eigen::MatrixXd found = Lanczos(size, count).run(operators, what);
  Eigenpairs pairs = rayleigh_ritz(operators, found.cast<Extended>(), what);
  double residual = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_corrections && !(residual <= sufficient_residual); ++step) {
    const ExtendedMatrix correction = correction_of(pairs, operators);
    residual = operators.largest_norm(correction);
    pairs = rayleigh_ritz(operators, pairs.vectors - correction, what);
  }
  pairs.worst_residual = residual;
  if (!(pairs.worst_residual <= largest_residual))
    throw SolverError(
        fmt::format("{}: a mode's residual is {:.1e}, more than {:.0e}; take fewer "
                    "elements or ask for fewer modes",
                    what, pairs.worst_residual, largest_residual));
  for (Eigen::Index i = 0; i < count; ++i) fix_sign(pairs.vectors.col(i));
  return pairs;
}

}  // namespace pennon::modes
