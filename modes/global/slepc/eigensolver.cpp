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

// T^H = B^H (A - target B)^-H, whose eigenvectors are those of T = (A - target B)^-1 B from the
// left.
class AdjointOperator {
 public:
  AdjointOperator(EPS direct, Mat B) : B_(B) {
    ST transformation = nullptr;
    check(EPSGetST(direct, &transformation));
    check(STGetKSP(transformation, &factors_));
    check(MatCreateVecs(B, work_.address(), nullptr));
    PetscInt n = 0;
    check(VecGetSize(work_, &n));
    check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, this, shell_.address()));
    check(MatShellSetOperation(shell_, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  }

  operator Mat() const { return shell_; }

  /// to = (A - target B)^-H from.
  PetscErrorCode solve(Vec from, Vec to) const {
    PetscCall(VecCopy(from, work_));
    PetscCall(VecConjugate(work_));
    PetscCall(KSPSolveTranspose(factors_, work_, to));
    return VecConjugate(to);
  }

 private:
  static PetscErrorCode multiply(Mat shell, Vec from, Vec to) {
    AdjointOperator* self = nullptr;
    PetscCall(MatShellGetContext(shell, &self));
    PetscCall(self->solve(from, to));
    PetscCall(VecCopy(to, self->work_));
    return MatMultHermitianTranspose(self->B_, self->work_, to);
  }

  Mat B_;
  KSP factors_ = nullptr;
  petsc::Vector work_;
  petsc::Matrix shell_;
};

Eigen::VectorXcd copy_of(Vec vector) {
  PetscInt size = 0;
  const PetscScalar* values = nullptr;
  check(VecGetSize(vector, &size));
  check(VecGetArrayRead(vector, &values));
  Eigen::VectorXcd copy = Eigen::Map<const Eigen::VectorXcd>(values, size);
  check(VecRestoreArrayRead(vector, &values));
  return copy;
}

// The next pairs of a solver that has been set up.
template <class Use>
void for_each_solution(EPS solver, Mat like, int most, const Use& use) {
  check(EPSSolve(solver));
  PetscInt converged = 0;
  check(EPSGetConverged(solver, &converged));
  petsc::Vector vector;
  check(MatCreateVecs(like, vector.address(), nullptr));
  for (PetscInt k = 0; k < std::min(converged, PetscInt{most}); ++k) {
    PetscScalar value = 0;
    check(EPSGetEigenpair(solver, k, &value, nullptr, vector, nullptr));
    use(value, vector);
  }
}

constexpr double tolerance = 1e-12;        // of SLEPc
constexpr double largest_residual = 1e-6;  // of what counts as converged
constexpr int most_restarts = 300;

// Gives each pair its adjoint, and takes out those for which there is none.
void find_adjoints(EPS direct, Mat shared_B, const Eigen::SparseMatrix<Complex>& A,
                   const Eigen::SparseMatrix<Complex>& B, Complex target,
                   std::vector<Eigenpair>& pairs) {
  const AdjointOperator adjoint(direct, shared_B);
  Solver solver;
  check(EPSCreate(PETSC_COMM_SELF, solver.address()));
  check(EPSSetOperators(solver, adjoint, nullptr));
  check(EPSSetProblemType(solver, EPS_NHEP));
  check(EPSSetWhichEigenpairs(solver, EPS_LARGEST_MAGNITUDE));
  check(
      EPSSetDimensions(solver, static_cast<PetscInt>(pairs.size()), PETSC_DEFAULT, PETSC_DEFAULT));
  check(EPSSetTolerances(solver, tolerance, most_restarts));
  petsc::Vector p;
  check(MatCreateVecs(shared_B, p.address(), nullptr));
  for_each_solution(solver, shared_B, static_cast<int>(pairs.size()), [&](Complex theta, Vec w) {
    const Complex lambda = target + 1.0 / std::conj(theta);
    for (Eigenpair& pair : pairs)
      if (are_same(lambda, pair.lambda)) {
        check(adjoint.solve(w, p));
        set_adjoint(A, B, copy_of(p), pair);
      }
  });
  std::erase_if(pairs, [](const Eigenpair& pair) {
    return pair.p.size() == 0 || !(pair.adjoint_residual < largest_residual);
  });
}

}  // namespace

SlepcSession::SlepcSession() {
  check(SlepcInitializeNoArguments());
}

SlepcSession::~SlepcSession() {
  SlepcFinalize();
}

Spectrum eigenpairs_near(const Eigen::SparseMatrix<Complex>& A,
                         const Eigen::SparseMatrix<Complex>& B, Complex target, int requested,
                         bool with_adjoints) {
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
  std::vector<Eigenpair> pairs;
  for_each_solution(solver, shared_A, requested, [&](Complex lambda, Vec q) {
    Eigenpair pair{.lambda = lambda, .q = copy_of(q)};
    pair.residual = residual_of(A, B, pair);
    if (pair.residual < largest_residual) pairs.push_back(std::move(pair));
  });
  if (with_adjoints && !pairs.empty()) find_adjoints(solver, shared_B, A, B, target, pairs);
  for (Eigenpair& pair : pairs) normalise(B, pair);
  Spectrum spectrum;
  spectrum.requested = requested;
  merge(std::move(pairs), spectrum);
  return spectrum;
}

}  // namespace pennon::modes::global
