#include "modes/global/slepc/eigensolver.hpp"

#include <fmt/format.h>
#include <slepceps.h>

#include <algorithm>

#include "common/errors.hpp"
#include "common/petsc.hpp"

#ifndef PETSC_USE_COMPLEX
#error "pennon-global needs PETSc with complex numbers"
#endif

namespace pennon::modes::global {
namespace {

using petsc::check;
using Complex = std::complex<double>;
using Solver = petsc::Handle<EPS, EPSDestroy>;
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
  // The columns of the flag's nodes are dense. Approximate minimum degree (0) takes a third of the
  // time of the orderings by dissection for such a matrix.
  constexpr const char* ordering = "-global_st_mat_mumps_icntl_7";
  PetscBool is_given = PETSC_FALSE;
  check(PetscOptionsHasName(nullptr, nullptr, ordering, &is_given));
  if (is_given == PETSC_FALSE) check(PetscOptionsSetValue(nullptr, ordering, "0"));
}

// Factors at last; what PETSc says of it becomes a sentence.
void set_up(EPS solver, const Eigen::SparseMatrix<Complex>& A) {
  try {
    check(EPSSetUp(solver));
  } catch (const SolverError& fault) {
    throw SolverError(fmt::format(
        "the global modes' matrix of {} unknowns could not be factored, perhaps for want of memory "
        "({}); a smaller modes.global.n_rho or n_theta needs less",
        A.rows(), fault.what()));
  }
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

SlepcSession::SlepcSession() {
  check(SlepcInitializeNoArguments());
}

SlepcSession::~SlepcSession() {
  SlepcFinalize();
}

Spectrum eigenpairs_near(const Eigen::SparseMatrix<Complex>& A,
                         const Eigen::SparseMatrix<Complex>& B, Complex target, int requested) {
  constexpr double tolerance = 1e-10;      // of SLEPc
  constexpr double largest_residual = 1e-6;  // of a pair that counts as converged
  constexpr int most_restarts = 300;
  const SharedMatrix shared_A(A), shared_B(B);
  Solver solver;
  check(EPSCreate(PETSC_COMM_SELF, solver.address()));
  check(EPSSetOperators(solver, shared_A, shared_B));
  check(EPSSetProblemType(solver, EPS_GNHEP));
  check(EPSSetWhichEigenpairs(solver, EPS_TARGET_MAGNITUDE));
  check(EPSSetTarget(solver, target));
  check(EPSSetDimensions(solver, requested, PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(solver, tolerance, most_restarts));
  set_transformation(solver);
  check(EPSSetOptionsPrefix(solver, "global_"));
  check(EPSSetFromOptions(solver));
  set_up(solver, A);
  check(EPSSolve(solver));
  PetscInt converged = 0;
  check(EPSGetConverged(solver, &converged));
  petsc::Vector q;
  check(MatCreateVecs(shared_A, q.address(), nullptr));
  Spectrum spectrum;
  spectrum.requested = requested;
  std::vector<Eigenpair> pairs;
  for (PetscInt k = 0; k < std::min(converged, PetscInt{requested}); ++k) {
    PetscScalar lambda = 0;
    check(EPSGetEigenpair(solver, k, &lambda, nullptr, q, nullptr));
    Eigenpair pair{lambda, copy_of(q), 0};
    pair.residual = residual_of(A, B, pair);
    if (pair.residual < largest_residual) pairs.push_back(std::move(pair));
  }
  merge(std::move(pairs), spectrum);
  return spectrum;
}

}  // namespace pennon::modes::global
