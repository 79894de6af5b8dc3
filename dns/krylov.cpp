#include "dns/krylov.hpp"

#include <cmath>

#include "common/petsc.hpp"

namespace pennon::dns {

using petsc::check;

struct Krylov::Implementation {
  Operator A, inverse_M;
  std::exception_ptr caught;
  petsc::Matrix matrix;
  petsc::KrylovMethod method;
  petsc::Vector b, x;
  double root_unknowns = 1;

  static PetscErrorCode apply(const Operator& function, std::exception_ptr& caught, Vec in,
                              Vec out) {
    const double* from = nullptr;
    double* to = nullptr;
    VecGetArrayRead(in, &from);
    VecGetArrayWrite(out, &to);
    const PetscErrorCode code = petsc::guarded(caught, [&] { function(from, to); });
    VecRestoreArrayRead(in, &from);
    VecRestoreArrayWrite(out, &to);
    return code;
  }
  static PetscErrorCode multiply(Mat shell, Vec in, Vec out) {
    Implementation* self = nullptr;
    MatShellGetContext(shell, static_cast<void*>(&self));
    return apply(self->A, self->caught, in, out);
  }
  static PetscErrorCode precondition(PC shell, Vec in, Vec out) {
    Implementation* self = nullptr;
    PCShellGetContext(shell, static_cast<void*>(&self));
    return apply(self->inverse_M, self->caught, in, out);
  }
};

Krylov::Krylov(std::size_t unknowns, const Settings& settings, Operator A, Operator inverse_M)
    : implementation_(std::make_unique<Implementation>()) {
  petsc::start();
  Implementation& self = *implementation_;
  self.A = std::move(A);
  self.inverse_M = std::move(inverse_M);
  const MPI_Comm comm = settings.is_of_one_rank ? PETSC_COMM_SELF : PETSC_COMM_WORLD;
  const auto n = static_cast<PetscInt>(unknowns);
  check(MatCreateShell(comm, n, n, PETSC_DETERMINE, PETSC_DETERMINE, &self, self.matrix.address()));
  check(MatShellSetOperation(self.matrix, MATOP_MULT,
                             reinterpret_cast<void (*)()>(&Implementation::multiply)));
  check(VecCreateMPIWithArray(comm, 1, n, PETSC_DETERMINE, nullptr, self.b.address()));
  check(VecCreateMPIWithArray(comm, 1, n, PETSC_DETERMINE, nullptr, self.x.address()));
  PetscInt total = 0;
  check(VecGetSize(self.b, &total));
  self.root_unknowns = std::sqrt(static_cast<double>(total));
  check(KSPCreate(comm, self.method.address()));
  check(KSPSetOptionsPrefix(self.method, (settings.name + "_").c_str()));
  check(KSPSetOperators(self.method, self.matrix, self.matrix));
  check(KSPSetType(self.method, KSPGMRES));
  check(KSPGMRESSetRestart(self.method, settings.restart));
  check(KSPSetPCSide(self.method, PC_LEFT));
  check(KSPSetNormType(self.method, KSP_NORM_PRECONDITIONED));
  check(KSPSetInitialGuessNonzero(self.method, PETSC_TRUE));
  check(KSPSetTolerances(self.method, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                         settings.most_iterations));
  PC preconditioner = nullptr;
  check(KSPGetPC(self.method, &preconditioner));
  check(PCSetType(preconditioner, PCSHELL));
  check(PCShellSetContext(preconditioner, &self));
  check(PCShellSetApply(preconditioner, &Implementation::precondition));
  check(KSPSetFromOptions(self.method));
}

Krylov::~Krylov() = default;

KrylovSummary Krylov::solve(const double* b, double* x, double tolerance, double relative) {
  Implementation& self = *implementation_;
  check(KSPSetTolerances(self.method, relative, tolerance * self.root_unknowns, PETSC_DEFAULT,
                         PETSC_DEFAULT));
  check(VecPlaceArray(self.b, b));
  check(VecPlaceArray(self.x, x));
  self.caught = nullptr;
  const PetscErrorCode code = KSPSolve(self.method, self.b, self.x);
  check(VecResetArray(self.b));
  check(VecResetArray(self.x));
  if (self.caught) std::rethrow_exception(self.caught);
  check(code);
  KSPConvergedReason reason = KSP_CONVERGED_ITERATING;
  PetscInt iterations = 0;
  PetscReal norm = 0;
  check(KSPGetConvergedReason(self.method, &reason));
  check(KSPGetIterationNumber(self.method, &iterations));
  check(KSPGetResidualNorm(self.method, &norm));
  return {reason > 0, static_cast<int>(iterations), norm / self.root_unknowns};
}

}  // namespace pennon::dns
