/// A linear system without a matrix, by PETSc's Krylov methods: A x = b with a preconditioner M^-1.
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

/// Memory for the vectors of solvers that never run at the same time, taken when it is first
/// written to.
class KrylovSpace {
 public:
  /// For vectors of up to `longest` numbers.
  explicit KrylovSpace(std::size_t longest) : longest_(longest) {}

  /// The k-th of a solver's vectors of `length` numbers.
  double* vector(std::size_t k, std::size_t length);

 private:
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

  /// `unknowns` of this rank. The method is GMRES unless PETSc's options say otherwise.
  /// The method keeps its vectors in `space` where there is one; solvers that share it must not be
  /// called from one another.
  Krylov(std::size_t unknowns, const Settings&, Operator A, Operator inverse_M,
         std::shared_ptr<KrylovSpace> space = nullptr);
  ~Krylov();
  Krylov(const Krylov&) = delete;
  Krylov& operator=(const Krylov&) = delete;

  /// From the guess in x, until the root mean square of M^-1 (b - A x), an estimate of x's error,
  /// is below `tolerance`, or below `relative` times that of x = 0, from
  /// which it starts if `relative` is given. Throws what the operators
  /// throw, and SolverError where PETSc fails; not to converge is no failure here.
  KrylovSummary solve(const double* b, double* x, double tolerance,
                      double relative = least_relative);
  /// There is nothing to gain below rounding.
  static constexpr double least_relative = 1e-13;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pennon::dns
