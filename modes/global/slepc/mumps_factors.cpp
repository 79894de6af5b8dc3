#include "modes/global/slepc/mumps_factors.hpp"

#include <fmt/format.h>
#include <petscmat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "common/errors.hpp"
#include "common/petsc.hpp"

#ifndef PETSC_USE_COMPLEX
#error "the factors of the global modes need PETSc with complex numbers"
#endif

namespace pennon::modes::global {
namespace {

using petsc::check;
using Rows = Eigen::SparseMatrix<std::complex<double>, Eigen::RowMajor>;
static_assert(sizeof(PetscInt) == sizeof(int) &&
              sizeof(PetscScalar) == sizeof(std::complex<double>));

// Of this machine, in MB; none where the system does not say.
std::optional<double> available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  double kilobytes = 0;
  while (file >> word)
    if (word == "MemAvailable:" && file >> kilobytes) return kilobytes / 1024;
  return std::nullopt;
}

// MUMPS's numbers, by its manual.
constexpr int info_of_error = 1, estimated_megabytes = 17;
constexpr int not_enough_workspace = -9, workspace_limited = -19, no_memory = -13;

bool is_for_want_of_memory(PetscInt error) {
  constexpr std::array errors = {-8, not_enough_workspace, no_memory, workspace_limited};
  return std::ranges::find(errors, error) != errors.end();
}

class MumpsFactors final : public SparseFactors {
 public:
  void factor(const Matrix& matrix) override {
    Rows rows = matrix;
    rows.makeCompressed();
    if (has_pattern_of(rows))
      std::copy_n(rows.valuePtr(), rows.nonZeros(), rows_.valuePtr());
    else
      analyse(std::move(rows));
    check(MatLUFactorNumeric(factors_, shared_, nullptr));
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(MatFactorGetError(factors_, &error));
    if (error == MAT_FACTOR_NOERROR) return;
    const PetscInt of_mumps = info(info_of_error);
    if (error == MAT_FACTOR_OUTMEMORY || is_for_want_of_memory(of_mumps)) refuse(std::nullopt);
    rows_ = {};
    throw SolverError(fmt::format("the matrix is singular (MUMPS says {})", of_mumps));
  }

  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const override {
    Eigen::MatrixXcd solution(right.rows(), right.cols());
    petsc::Matrix from, to;
    share(right, from);
    share(solution, to);
    check(MatMatSolve(factors_, from, to));
    return solution;
  }

  // A^H x = b is A^T conj(x) = conj(b).
  Eigen::MatrixXcd solve_adjoint(const Eigen::MatrixXcd& right) const override {
    const Eigen::MatrixXcd conjugate = right.conjugate();
    Eigen::MatrixXcd solution(right.rows(), right.cols());
    petsc::Matrix from, to;
    share(conjugate, from);
    share(solution, to);
    check(MatMatSolveTranspose(factors_, from, to));
    return solution.conjugate();
  }

 private:
  bool has_pattern_of(const Rows& rows) const {
    return rows.rows() == rows_.rows() && rows.nonZeros() == rows_.nonZeros() &&
           std::equal(rows.outerIndexPtr(), rows.outerIndexPtr() + rows.rows() + 1,
                      rows_.outerIndexPtr()) &&
           std::equal(rows.innerIndexPtr(), rows.innerIndexPtr() + rows.nonZeros(),
                      rows_.innerIndexPtr());
  }

  void analyse(Rows rows) {
    rows_ = std::move(rows);
    const auto n = static_cast<PetscInt>(rows_.rows());
    shared_ = {};
    factors_ = {};
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, n, n, rows_.outerIndexPtr(),
                                    rows_.innerIndexPtr(), rows_.valuePtr(), shared_.address()));
    check(MatSetOptionsPrefix(shared_, "global_"));
    check(MatGetFactor(shared_, MATSOLVERMUMPS, MAT_FACTOR_LU, factors_.address()));
    check(MatLUFactorSymbolic(factors_, shared_, nullptr, nullptr, nullptr));
    const std::optional<double> available = available_memory();
    if (available && info(estimated_megabytes) > *available) refuse(available);
  }

  PetscInt info(int number) const {
    PetscInt value = 0;
    check(MatMumpsGetInfog(factors_, number, &value));
    return value;
  }

  [[noreturn]] void refuse(const std::optional<double>& available) {
    const double needed = info(estimated_megabytes);
    std::string sentence = fmt::format("the factors of {} unknowns need about {:.0f} MB of memory",
                                       rows_.rows(), needed);
    rows_ = {};  // the analysis is not to be used again
    if (available) {
      // A grid's factors grow a little faster than its unknowns.
      const double share = std::sqrt(*available / needed);
      sentence += fmt::format(
          ", and {:.0f} MB are free: with modes.global.n_rho and n_theta {:.2f} times what they "
          "are "
          "they would fit",
          *available, std::floor(90 * share) / 100);
    } else {
      sentence += ", which MUMPS could not get; a smaller modes.global.n_rho or n_theta needs less";
    }
    throw SolverError(sentence);
  }

  // A dense matrix of PETSc's on the numbers of one of Eigen's.
  static void share(const Eigen::MatrixXcd& matrix, petsc::Matrix& handle) {
    check(MatCreateSeqDense(PETSC_COMM_SELF, static_cast<PetscInt>(matrix.rows()),
                            static_cast<PetscInt>(matrix.cols()),
                            const_cast<PetscScalar*>(matrix.data()), handle.address()));
  }

  Rows rows_;
  petsc::Matrix shared_, factors_;
};

}  // namespace

std::shared_ptr<SparseFactors> mumps_factors() {
  return std::make_shared<MumpsFactors>();
}

}  // namespace pennon::modes::global
