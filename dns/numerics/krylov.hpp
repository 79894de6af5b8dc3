/// A linear system without a matrix, by PETSc's Krylov methods: A x = b with a preconditioner M^-1.
///
/// GMRES keeps a basis of up to `restart` + 2 vectors as long as the solver lives. The fluid has
/// three solvers that never run at the same time; kept apart, their bases would take twice the
/// memory. So solvers may share a KrylovSpace, in which they keep these vectors one after the
/// other: PETSc creates a vector of a solver by duplicating another one, and here the duplicate
/// takes its numbers from the space instead of the heap (krylov.cpp). PETSc has no setting for
/// that. To free the vectors after each solution (KSPReset) would need no space of our own, but
/// would allocate and clear them anew in each time step.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pennon::dns {

struct KrylovSummary {
  bool converged = false;
  int iterations = 0;
  double residual = 0;  ///< root mean square of M^-1 (b - A x)
};

/// Memory for the vectors of solvers that never run at the same time. It grows with the vectors
/// that are asked for; pages that no solver has written to take no physical memory.
class KrylovSpace {
 public:
  /// For vectors of up to `longest` numbers.
  explicit KrylovSpace(std::size_t longest) : longest_(longest) {}

  /// Where the k-th of a solver's vectors of `length` numbers lies, `length` <= longest. Solvers
  /// with equal k and length get the same place.
  double* vector(std::size_t k, std::size_t length);

 private:
  // Blocks of `longest` numbers, each of which holds as many vectors as fit.
  std::size_t longest_;
  std::vector<std::unique_ptr<double[]>> blocks_;
};

class Krylov {
 public:
  using Operator = std::function<void(const double* in, double* out)>;

  struct Settings {
    std::string name;  ///< also the prefix of PETSc's options, as -pressure_ksp_type
    int most_iterations = 100;
    int restart = 30;
    bool is_of_one_rank = false;  ///< every rank solves a system of its own
  };

  /// `unknowns` are those of this rank. The method is GMRES unless PETSc's options say otherwise.
  /// It keeps its vectors in `space` where there is one; of the solvers that share a space none may
  /// be called while another one solves.
  Krylov(std::size_t unknowns, const Settings&, Operator A, Operator inverse_M,
         std::shared_ptr<KrylovSpace> space = nullptr);
  ~Krylov();
  Krylov(const Krylov&) = delete;
  Krylov& operator=(const Krylov&) = delete;

  /// Iterates until the root mean square of M^-1 (b - A x), an estimate of the error of x, is below
  /// `tolerance`, or below `relative` times its value at x = 0. The first guess is x, or 0 where
  /// `relative` is given. Throws what the operators throw, and SolverError where PETSc fails. A
  /// solution that does not converge does not throw: the summary says so.
  KrylovSummary solve(const double* b, double* x, double tolerance,
                      double relative = least_relative);
  static constexpr double least_relative = 1e-13;  ///< smaller residuals are rounding

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pennon::dns
