#include "modes/global/solve/slepc/mumps_factors.hpp"

#include <fmt/format.h>
#include <petscmat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "common/available_memory.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "common/petsc/petsc.hpp"

#ifndef PETSC_USE_COMPLEX
#error "the factors of the global modes need PETSc with complex numbers"
#endif

namespace pennon::modes::global {
namespace {

using petsc::check;
using Rows = Eigen::SparseMatrix<std::complex<double>, Eigen::RowMajor>;
static_assert(sizeof(PetscInt) == sizeof(int) &&
              sizeof(PetscScalar) == sizeof(std::complex<double>));

// MUMPS's numbers, by its manual.
constexpr int info_of_error = 1, megabytes_of_rank = 16, megabytes_of_all = 17;

// A rank's part in the factors of one matrix. All ranks call each function together; the rows are
// the leading one's.
class Part {
 public:
  void analyse(const Rows& rows, PetscInt size) {
    rows_ = rows;
    size_ = size;
    matrix_ = {};
    factors_ = {};
    if (ranks::count() == 1)
      check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, size_, size_, rows_.outerIndexPtr(),
                                      rows_.innerIndexPtr(), rows_.valuePtr(), matrix_.address()));
    else
      check(MatCreateMPIAIJWithArrays(PETSC_COMM_WORLD, mine(), mine(), size_, size_,
                                      ranks::is_leading() ? rows_.outerIndexPtr() : no_rows.data(),
                                      rows_.innerIndexPtr(), rows_.valuePtr(), matrix_.address()));
    check(MatSetOptionsPrefixFactor(matrix_, "global_"));
    check(MatGetFactor(matrix_, MATSOLVERMUMPS, MAT_FACTOR_LU, factors_.address()));
    check(MatLUFactorSymbolic(factors_, matrix_, nullptr, nullptr, nullptr));
  }

  // Other values in the same pattern.
  void update(const Rows& rows) {
    if (ranks::is_leading()) std::copy_n(rows.valuePtr(), rows.nonZeros(), rows_.valuePtr());
    if (ranks::count() > 1) check(MatUpdateMPIAIJWithArray(matrix_, rows_.valuePtr()));
  }

  MatFactorError factor() {
    check(MatLUFactorNumeric(factors_, matrix_, nullptr));
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(MatFactorGetError(factors_, &error));
    return error;
  }

  // With the matrix or its transpose.
  void solve(const Eigen::MatrixXcd& right, Eigen::MatrixXcd& solution, PetscInt columns,
             bool transposed) {
    petsc::Matrix from, to;
    share(right, columns, from);
    share(solution, columns, to);
    check(transposed ? MatMatSolveTranspose(factors_, from, to) : MatMatSolve(factors_, from, to));
  }

  const Rows& rows() const { return rows_; }
  PetscInt info(int number) const {
    PetscInt value = 0;
    check(MatMumpsGetInfog(factors_, number, &value));
    return value;
  }

 private:
  static constexpr std::array<PetscInt, 1> no_rows = {0};

  PetscInt mine() const { return ranks::is_leading() ? size_ : 0; }

  // A dense matrix of PETSc's on the numbers of one of Eigen's.
  void share(const Eigen::MatrixXcd& matrix, PetscInt columns, petsc::Matrix& handle) const {
    check(MatCreateDense(PETSC_COMM_WORLD, mine(), PETSC_DECIDE, size_, columns,
                         const_cast<PetscScalar*>(matrix.data()), handle.address()));
  }

  PetscInt size_ = 0;
  Rows rows_;
  petsc::Matrix matrix_, factors_;
};

// What the leading rank has the others do with which factors.
enum class Task { analyse, update, factor, solve, solve_transposed, discard, end };

struct Order {
  Task task;
  int factors = 0;
  PetscInt count = 0;  // of unknowns or columns
};

Order exchanged(Order order) {
  std::array<int, 3> numbers = {static_cast<int>(order.task), order.factors, order.count};
  if (ranks::count() > 1) MPI_Bcast(numbers.data(), 3, MPI_INT, 0, PETSC_COMM_WORLD);
  return {static_cast<Task>(numbers[0]), numbers[1], numbers[2]};
}

// As MUMPS counts; none where the system does not say.
std::optional<double> available_megabytes() {
  constexpr double megabyte = 1 << 20;
  const std::optional<double> bytes = available_memory();
  return bytes ? std::optional(*bytes / megabyte) : std::nullopt;
}

class MumpsFactors final : public SparseFactors {
 public:
  MumpsFactors() : number_(next_number++) {}
  MumpsFactors(const MumpsFactors&) = delete;
  MumpsFactors& operator=(const MumpsFactors&) = delete;
  ~MumpsFactors() override { exchanged({Task::discard, number_}); }

  void factor(const Matrix& matrix) override {
    Rows rows = matrix;
    rows.makeCompressed();
    if (!is_good_ || !have_same_pattern(rows, part_.rows()))
      analyse(rows);
    else
      update(rows);
    exchanged({Task::factor, number_});
    const MatFactorError error = part_.factor();
    is_good_ = error == MAT_FACTOR_NOERROR;
    if (is_good_) return;
    const PetscInt of_mumps = part_.info(info_of_error);
    if (error == MAT_FACTOR_OUTMEMORY || is_for_want_of_memory(of_mumps)) refuse(std::nullopt);
    throw SolverError(fmt::format("the matrix is singular (MUMPS says {})", of_mumps));
  }

  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const override {
    return solved(right, Task::solve);
  }

  // A^H x = b is A^T conj(x) = conj(b).
  Eigen::MatrixXcd solve_adjoint(const Eigen::MatrixXcd& right) const override {
    return solved(right.conjugate(), Task::solve_transposed).conjugate();
  }

 private:
  static bool is_for_want_of_memory(PetscInt error) {
    constexpr std::array errors = {-8, -9, -11, -13, -19};
    return std::ranges::find(errors, error) != errors.end();
  }

  void analyse(const Rows& rows) {
    const auto size = static_cast<PetscInt>(rows.rows());
    exchanged({Task::analyse, number_, size});
    part_.analyse(rows, size);
    const std::optional<double> available = available_megabytes();
    is_good_ = !available || part_.info(megabytes_of_all) < *available;
    if (!is_good_) refuse(available);
  }

  void update(const Rows& rows) {
    exchanged({Task::update, number_});
    part_.update(rows);
  }

  Eigen::MatrixXcd solved(const Eigen::MatrixXcd& right, Task task) const {
    const auto columns = static_cast<PetscInt>(right.cols());
    Eigen::MatrixXcd solution(right.rows(), columns);
    exchanged({task, number_, columns});
    part_.solve(right, solution, columns, task == Task::solve_transposed);
    return solution;
  }

  [[noreturn]] void refuse(const std::optional<double>& available) const {
    const double needed = part_.info(megabytes_of_all);
    std::string sentence = fmt::format("the factors of {} unknowns need about {:.0f} MB of memory",
                                       part_.rows().rows(), needed);
    if (available)
      // A little less, for factors grow faster than unknowns.
      sentence += fmt::format(
          ", and {:.0f} MB are free: with modes.global.n_rho and n_theta {:.2f} times what they "
          "are "
          "they would fit",
          *available, std::floor(90 * std::sqrt(*available / needed)) / 100);
    else
      sentence += ", which MUMPS could not get; a smaller modes.global.n_rho or n_theta needs less";
    throw SolverError(sentence);
  }

  static inline int next_number = 0;

  int number_;
  bool is_good_ = false;  // whether the analysis may serve again
  mutable Part part_;     // PETSc's solutions count as changes
};

}  // namespace

std::shared_ptr<SparseFactors> mumps_factors() {
  return std::make_shared<MumpsFactors>();
}

void serve_mumps_factors() {
  std::map<int, Part> parts;
  Eigen::MatrixXcd nothing;
  for (;;) {
    const Order order = exchanged({Task::end});
    switch (order.task) {
      case Task::analyse:
        parts[order.factors].analyse({}, order.count);
        break;
      case Task::update:
        parts[order.factors].update({});
        break;
      case Task::factor:
        parts[order.factors].factor();
        break;
      case Task::solve:
      case Task::solve_transposed:
        parts[order.factors].solve(nothing, nothing, order.count,
                                   order.task == Task::solve_transposed);
        break;
      case Task::discard:
        parts.erase(order.factors);
        break;
      case Task::end:
        return;
    }
  }
}

MumpsRanks::~MumpsRanks() {
  exchanged({Task::end});
}

}  // namespace pennon::modes::global
