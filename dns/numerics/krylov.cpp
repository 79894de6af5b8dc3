#include "dns/numerics/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "common/parallel/interrupted_step.hpp"
#include "common/petsc/petsc.hpp"

namespace pennon::dns {

using petsc::check;

double* KrylovSpace::vector(std::size_t k, std::size_t length) {
  const std::size_t vectors_of_block = longest_ / length, block = k / vectors_of_block;
  while (blocks_.size() <= block)  // left uninitialised, see KrylovSpace
    blocks_.push_back(std::make_unique_for_overwrite<double[]>(longest_));
  return blocks_[block].get() + (k % vectors_of_block) * length;
}

namespace {

// How PETSc is made to keep a solver's vectors in a KrylovSpace. A vector of the solver carries, as
// a composed object of this name, a Hold on its place in the space. VecDuplicate is replaced by
// duplicate_in_space(), which takes a free place for the new vector; the Hold gives it back when
// PETSc destroys the vector.
constexpr const char* space_of_vector = "pennon_krylov_space";

// The space of a solver, and which of its places the solver's vectors take.
struct SharedVectors {
  std::shared_ptr<KrylovSpace> space;
  std::vector<bool> is_taken;

  std::size_t take() {
    const auto free = std::ranges::find(is_taken, false);
    const auto place = static_cast<std::size_t>(free - is_taken.begin());
    if (free == is_taken.end())
      is_taken.push_back(true);
    else
      *free = true;
    return place;
  }
};

// The place of a vector. The right side and the solution of a solver, from which PETSc duplicates
// the others, have none: their numbers belong to the caller of solve().
struct Hold {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  SharedVectors* vectors;
  std::size_t place;
};

PetscErrorCode release(void* hold) {
  const std::unique_ptr<Hold> owned(static_cast<Hold*>(hold));
  if (owned->place != Hold::none) owned->vectors->is_taken[owned->place] = false;
  return 0;
}

PetscErrorCode duplicate_in_space(Vec like, Vec* vector);

// Attaches the hold to the vector, and makes duplicates of the vector be made in the space.
void keep_in_space(Vec vector, std::unique_ptr<Hold> hold) {
  petsc::Handle<PetscContainer, PetscContainerDestroy> container;
  const auto object = reinterpret_cast<PetscObject>(vector);
  check(PetscContainerCreate(PetscObjectComm(object), container.address()));
  check(PetscContainerSetUserDestroy(container, &release));
  check(PetscContainerSetPointer(container, hold.release()));
  check(PetscObjectCompose(object, space_of_vector,
                           reinterpret_cast<PetscObject>(static_cast<PetscContainer>(container))));
  check(
      VecSetOperation(vector, VECOP_DUPLICATE, reinterpret_cast<void (*)()>(&duplicate_in_space)));
}

// VecDuplicate for the vectors of a solver.
PetscErrorCode duplicate_in_space(Vec like, Vec* vector) {
  std::exception_ptr caught;  // dropped: PETSc's error code becomes an exception in solve()
  return petsc::guarded(caught, [&] {
    PetscObject container = nullptr;
    void* pointer = nullptr;
    PetscInt local = 0, total = 0;
    const auto object = reinterpret_cast<PetscObject>(like);
    check(PetscObjectQuery(object, space_of_vector, &container));
    check(PetscContainerGetPointer(reinterpret_cast<PetscContainer>(container), &pointer));
    check(VecGetLocalSize(like, &local));
    check(VecGetSize(like, &total));
    SharedVectors* vectors = static_cast<Hold*>(pointer)->vectors;
    auto hold = std::make_unique<Hold>(Hold{vectors, vectors->take()});
    double* array = vectors->space->vector(hold->place, static_cast<std::size_t>(local));
    check(VecCreateMPIWithArray(PetscObjectComm(object), 1, local, total, array, vector));
    keep_in_space(*vector, std::move(hold));
  });
}

}  // namespace

struct Krylov::Implementation {
  Operator A, inverse_M;
  std::exception_ptr caught;
  SharedVectors shared;  // outlives the vectors
  petsc::Matrix matrix;
  petsc::KrylovMethod method;
  petsc::Vector b, x;
  double root_unknowns = 1;
  bool is_of_one_rank = false;
  int iterations = 0;  // of the solution at work, as the preconditioner counts them

  // Ranks that share the work agree on it, all in the same iterations.
  void look_for_interrupt() {
    constexpr int iterations_between = 8;
    ranks::stop_if_interrupted_alone();
    if (++iterations % iterations_between == 0 && !is_of_one_rank) ranks::stop_if_interrupted();
  }

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
    return apply(
        [self](const double* from, double* to) {
          self->look_for_interrupt();
          self->inverse_M(from, to);
        },
        self->caught, in, out);
  }
};

Krylov::Krylov(std::size_t unknowns, const Settings& settings, Operator A, Operator inverse_M,
               std::shared_ptr<KrylovSpace> space)
    : implementation_(std::make_unique<Implementation>()) {
  petsc::start();
  Implementation& self = *implementation_;
  self.A = std::move(A);
  self.inverse_M = std::move(inverse_M);
  self.is_of_one_rank = settings.is_of_one_rank;
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
  check(KSPSetTolerances(self.method, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT,
                         settings.most_iterations));
  PC preconditioner = nullptr;
  check(KSPGetPC(self.method, &preconditioner));
  check(PCSetType(preconditioner, PCSHELL));
  check(PCShellSetContext(preconditioner, &self));
  check(PCShellSetApply(preconditioner, &Implementation::precondition));
  check(KSPSetFromOptions(self.method));
  if (!space || unknowns == 0) return;
  self.shared.space = std::move(space);
  for (const Vec vector : {static_cast<Vec>(self.b), static_cast<Vec>(self.x)})
    keep_in_space(vector, std::make_unique<Hold>(Hold{&self.shared, Hold::none}));
}

Krylov::~Krylov() = default;

KrylovSummary Krylov::solve(const double* b, double* x, double tolerance, double relative) {
  Implementation& self = *implementation_;
  check(KSPSetTolerances(self.method, relative, tolerance * self.root_unknowns, PETSC_DEFAULT,
                         PETSC_DEFAULT));
  // A tolerance relative to x = 0 needs the residual there; starting there gives it for nothing.
  check(
      KSPSetInitialGuessNonzero(self.method, relative > least_relative ? PETSC_FALSE : PETSC_TRUE));
  check(VecPlaceArray(self.b, b));
  check(VecPlaceArray(self.x, x));
  self.caught = nullptr;
  self.iterations = 0;
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
