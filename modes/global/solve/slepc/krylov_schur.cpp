#include "modes/global/solve/slepc/krylov_schur.hpp"

#include <slepceps.h>

#include <algorithm>
#include <functional>

#include "common/petsc/petsc.hpp"

#ifndef PETSC_USE_COMPLEX
#error "pennon-global needs PETSc with complex numbers"
#endif

namespace pennon::modes::global {
namespace {

using petsc::check;
using Complex = std::complex<double>;
using Solver = petsc::Handle<EPS, EPSDestroy>;
static_assert(sizeof(PetscScalar) == sizeof(Complex));

Eigen::VectorXcd copy_of(Vec vector) {
  PetscInt size = 0;
  const PetscScalar* values = nullptr;
  check(VecGetSize(vector, &size));
  check(VecGetArrayRead(vector, &values));
  Eigen::VectorXcd copy = Eigen::Map<const Eigen::VectorXcd>(values, size);
  check(VecRestoreArrayRead(vector, &values));
  return copy;
}

// A linear map of vectors as a matrix of PETSc's.
class MapMatrix {
 public:
  using Map = std::function<Eigen::VectorXcd(const Eigen::VectorXcd&)>;

  MapMatrix(Eigen::Index size, Map map) : size_(size), map_(std::move(map)) {
    const auto n = static_cast<PetscInt>(size);
    check(MatCreateShell(PETSC_COMM_SELF, n, n, n, n, this, handle_.address()));
    check(MatShellSetOperation(handle_, MATOP_MULT, reinterpret_cast<void (*)()>(multiply)));
  }
  MapMatrix(const MapMatrix&) = delete;
  MapMatrix& operator=(const MapMatrix&) = delete;
  ~MapMatrix() = default;

  operator Mat() const { return handle_; }
  Eigen::Index size() const { return size_; }
  /// What the map threw inside PETSc is thrown again.
  void rethrow() const {
    if (caught_) std::rethrow_exception(caught_);
  }

 private:
  static PetscErrorCode multiply(Mat shell, Vec from, Vec to) {
    MapMatrix* self = nullptr;
    PetscCall(MatShellGetContext(shell, &self));
    return petsc::guarded(self->caught_, [&] {
      const Eigen::VectorXcd image = self->map_(copy_of(from));
      PetscScalar* values = nullptr;
      check(VecGetArrayWrite(to, &values));
      std::copy_n(image.data(), image.size(), values);
      check(VecRestoreArrayWrite(to, &values));
    });
  }

  Eigen::Index size_;
  Map map_;
  petsc::Matrix handle_;
  std::exception_ptr caught_;
};

constexpr double tolerance = 1e-12;         // of SLEPc
constexpr double greatest_residual = 1e-6;  // of what counts as converged
constexpr int most_restarts = 300;

// Of Krylov's space. The damped modes lie close together: with SLEPc's usual 25 vectors ten of them
// take 340 products with T, with 100 of them 149.
int dimension(int pairs, Eigen::Index size) {
  constexpr int least = 16, vectors_of_pair = 10, more = 150;
  const int wanted = std::max(least, std::min(vectors_of_pair * pairs, 2 * pairs + more));
  return static_cast<int>(std::min<Eigen::Index>(size, wanted));
}

// use(theta, vector) for the pairs of largest |theta| that converged, `most` at the most.
template <class Use>
void for_each_eigenpair(const MapMatrix& map, int most, const Use& use) {
  Solver solver;
  check(EPSCreate(PETSC_COMM_SELF, solver.address()));
  check(EPSSetOperators(solver, map, nullptr));
  check(EPSSetProblemType(solver, EPS_NHEP));
  check(EPSSetWhichEigenpairs(solver, EPS_LARGEST_MAGNITUDE));
  check(EPSSetDimensions(solver, most, dimension(most, map.size()), PETSC_DEFAULT));
  check(EPSSetTolerances(solver, tolerance, most_restarts));
  check(EPSSetOptionsPrefix(solver, "global_"));
  check(EPSSetFromOptions(solver));
  const PetscErrorCode failed = EPSSolve(solver);
  map.rethrow();
  check(failed);
  PetscInt converged = 0;
  check(EPSGetConverged(solver, &converged));
  petsc::Vector vector;
  check(MatCreateVecs(map, vector.address(), nullptr));
  for (PetscInt k = 0; k < std::min(converged, PetscInt{most}); ++k) {
    PetscScalar theta = 0;
    check(EPSGetEigenpair(solver, k, &theta, nullptr, vector, nullptr));
    use(theta, copy_of(vector));
  }
}

// Gives each pair its adjoint, and takes out those for which there is none: those of T^H =
// B^H (A - target B)^-H are B^H p.
void find_adjoints(const Pencil& pencil, const ShiftedInverse& inverse, Complex target,
                   std::vector<Eigenpair>& pairs) {
  const MapMatrix adjoint(pencil.size(), [&](const Eigen::VectorXcd& c) {
    return pencil.B_adjoint(inverse.solve_adjoint(c));
  });
  for_each_eigenpair(adjoint, static_cast<int>(pairs.size()), [&](Complex theta, const auto& c) {
    const Complex lambda = target + 1.0 / std::conj(theta);
    for (Eigenpair& pair : pairs)
      if (are_same(lambda, pair.lambda)) set_adjoint(pencil, inverse.solve_adjoint(c), pair);
  });
  std::erase_if(pairs, [](const Eigenpair& pair) {
    return pair.p.size() == 0 || !(pair.adjoint_residual < greatest_residual);
  });
}

}  // namespace

SlepcSession::SlepcSession() {
  check(SlepcInitializeNoArguments());
}

SlepcSession::~SlepcSession() {
  SlepcFinalize();
}

Spectrum eigenpairs_near(const Pencil& pencil, const ShiftedInverse& inverse, Complex target,
                         int n_modes, bool with_adjoints) {
  const MapMatrix T(pencil.size(),
                    [&](const Eigen::VectorXcd& q) { return inverse.solve(pencil.B(q)); });
  std::vector<Eigenpair> pairs;
  for_each_eigenpair(T, n_modes, [&](Complex theta, const Eigen::VectorXcd& q) {
    // T q once more takes out what q has of the null space of B, which A makes large (Meerbergen &
    // Spence 1997).
    Eigenpair pair{.lambda = target + 1.0 / theta, .q = inverse.solve(pencil.B(q))};
    pair.residual = residual_of(pencil, pair);
    if (pair.residual < greatest_residual) pairs.push_back(std::move(pair));
  });
  if (with_adjoints && !pairs.empty()) find_adjoints(pencil, inverse, target, pairs);
  for (Eigenpair& pair : pairs) normalise(pencil, pair);
  Spectrum spectrum;
  spectrum.requested = n_modes;
  merge(std::move(pairs), spectrum);
  return spectrum;
}

Spectrum coupled_eigenpairs_near(const CoupledOperator& coupled, Complex target, int n_modes,
                                 bool with_adjoints,
                                 const std::shared_ptr<SparseFactors>& factors) {
  return eigenpairs_near(coupled, ShiftedCoupled(coupled, target, factors), target, n_modes,
                         with_adjoints);
}

EigenSolver coupled_eigensolver(std::shared_ptr<SparseFactors> factors) {
  return [factors = std::move(factors)](const CoupledOperator& coupled, Complex target, int n_modes,
                                        bool with_adjoints) {
    return coupled_eigenpairs_near(coupled, target, n_modes, with_adjoints, factors);
  };
}

}  // namespace pennon::modes::global
