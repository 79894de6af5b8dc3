#include "modes/global/slepc/eigensolver.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <algorithm>
#include <chrono>

#include "common/errors.hpp"
#include "common/petsc.hpp"

#ifndef PETSC_USE_COMPLEX
#error "pennon-global needs PETSc with complex numbers"
#endif

namespace pennon::modes::global {
namespace {

using petsc::check;
using Complex = std::complex<double>;
using EigenSolver = petsc::Handle<EPS, EPSDestroy>;
static_assert(sizeof(PetscInt) == sizeof(int) && sizeof(PetscScalar) == sizeof(Complex));

// A matrix of PETSc's on the numbers of one of Eigen's, which must outlive it.
class SharedMatrix {
 public:
  explicit SharedMatrix(const Eigen::SparseMatrix<Complex>& matrix) : rows_(matrix) {
    rows_.makeCompressed();
    check(MatCreateSeqAIJWithArrays(PETSC_COMM_SELF, static_cast<PetscInt>(rows_.rows()),
                                    static_cast<PetscInt>(rows_.cols()), rows_.outerIndexPtr(),
                                    rows_.innerIndexPtr(), rows_.valuePtr(), handle_.address()));
  }
  operator Mat() const { return handle_; }

 private:
  Eigen::SparseMatrix<Complex, Eigen::RowMajor> rows_;
  petsc::Matrix handle_;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Shift and invert, by factors of MUMPS.
void set_transformation(EPS solver) {
  ST transformation = nullptr;
  KSP linear = nullptr;
  PC factors = nullptr;
  check(EPSGetST(solver, &transformation));
  check(STSetType(transformation, STSINVERT));
  check(STGetKSP(transformation, &linear));
  check(KSPSetType(linear, KSPPREONLY));
  check(KSPGetPC(linear, &factors));
  check(PCSetType(factors, PCLU));
  check(PCFactorSetMatSolverType(factors, MATSOLVERMUMPS));
}

Eigen::VectorXcd copy_of(Vec vector) {
  PetscInt size = 0;
  const PetscScalar* values = nullptr;
  check(VecGetSize(vector, &size));
  check(VecGetArrayRead(vector, &values));
  Eigen::VectorXcd copy = Eigen::Map<const Eigen::VectorXcd>(values, size);
  check(VecRestoreArrayRead(vector, &values));
  return copy;
}

}  // namespace

Spectrum eigenpairs_near(const Eigen::SparseMatrix<Complex>& A,
                         const Eigen::SparseMatrix<Complex>& B, const EigenSettings& settings) {
  const SharedMatrix shared_A(A), shared_B(B);
  EigenSolver solver;
  check(EPSCreate(PETSC_COMM_SELF, solver.address()));
  check(EPSSetOperators(solver, shared_A, shared_B));
  check(EPSSetProblemType(solver, EPS_GNHEP));
  check(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE));
  check(EPSSetTarget(solver, settings.target));
  check(EPSSetDimensions(solver, settings.requested, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(solver, settings.tolerance, settings.most_iterations));
  set_transformation(solver);
  check(EPSSetOptionsPrefix(solver, "global_"));
  check(EPSSetFromOptions(solver));
  Spectrum spectrum;
  spectrum.requested = settings.requested;
  auto begin = std::chrono::steady_clock::now();
  check(EPSSetUp(solver));
  spectrum.factor_seconds = seconds_since(begin);
  begin = std::chrono::steady_clock::now();
  check(EPSSolve(solver));
  PetscInt converged = 0;
  check(EPSGetConverged(solver, &converged));
  petsc::Vector real, imaginary;
  check(MatCreateVecs(shared_A, real.address(), nullptr));
  check(MatCreateVecs(shared_A, imaginary.address(), nullptr));
  for (PetscInt k = 0; k < converged; ++k) {
    PetscScalar lambda = 0, unused = 0;
    check(EPSGetEigenpair(solver, k, &lambda, &unused, real, imaginary));
    Eigenpair pair{lambda, copy_of(real), 0};
    const Eigen::VectorXcd Aq = A * pair.q, Bq = B * pair.q;
    pair.residual = (Aq - lambda * Bq).norm() / (Aq.norm() + std::abs(lambda) * Bq.norm());
    spectrum.pairs.push_back(std::move(pair));
  }
  spectrum.solve_seconds = seconds_since(begin);
  spectrum.converged = static_cast<int>(spectrum.pairs.size());
  std::ranges::sort(spectrum.pairs, [](const Eigenpair& a, const Eigenpair& b) {
    return a.lambda.real() > b.lambda.real();
  });
  return spectrum;
}

}  // namespace pennon::modes::global
