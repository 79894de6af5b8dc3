/// The matrix of Newton's method for a flag: a block of dim x dim for each pair of coupled nodes.
/// Held nodes have no unknowns. The pattern is analysed once; filling, factoring and solving reuse
/// it.
///
/// Chordwise nodes alone (dim = 2) make a narrow band, solved by LAPACK; a flag with a span (dim =
/// 3) a sparse matrix, solved by CHOLMOD where its symmetric part is positive definite and by
/// UMFPACK elsewhere. Both take any regular matrix: a buckling flag's is not definite, and those of
/// the discrete gradient, of damping and of a follower pressure are not symmetric.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

#include "dns/flag/held_nodes.hpp"

namespace pennon::dns {

/// A matrix that was factored, and the kind of its factors. Checkpoints keep it in place of the
/// factors, which follow from it again to the last bit.
struct TangentFactors {
  bool is_definite = false;     ///< Cholesky's factors of the symmetric part; else LU factors
  std::vector<double> entries;  ///< of the matrix, in an order of its own
};

template <int dim>
class TangentMatrix {
 public:
  using Block = Eigen::Matrix<double, dim, dim>;
  /// The relative error of solve(). Newton's method with the tangent of an earlier iteration leaves
  /// a larger share of its error in each iteration, so that this one costs it none.
  static constexpr double solution_error = 1e-3;

  /// `coupled`: ordered pairs of nodes, each once, (p, p) among them.
  TangentMatrix(HeldNodes, const std::vector<std::pair<int, int>>& coupled);
  ~TangentMatrix();
  TangentMatrix(const TangentMatrix&) = delete;
  TangentMatrix& operator=(const TangentMatrix&) = delete;

  void set_zero();
  /// Adds to the rows of node p and the columns of node q; nothing where one of them is held.
  void add(int p, int q, const Block& block);
  /// What add() gave, for eigenproblems and tests: unknowns are the components of the free nodes in
  /// turn.
  Eigen::SparseMatrix<double> matrix() const;
  const std::vector<int>& free_nodes() const { return free_; }
  /// Sets the vectors of the held nodes to zero.
  void clear_held(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) const {
    held_.clear(vectors);
  }

  /// Factors what add() gave. False if it is singular to working precision.
  bool factor();
  /// The same if the symmetric part is positive definite: the displacement that answers a force
  /// then does positive work with it. False, and nothing factored, if not.
  bool factor_if_definite();
  /// The matrix of the present factors; without entries for dim = 2, where they are not kept.
  TangentFactors factors() const;
  /// Sets the matrix to these entries and factors it. False, and nothing factored, where the
  /// entries are not those of a matrix with this pattern, or the matrix is singular.
  bool factor_again(const TangentFactors&);
  /// Solves for the unknowns in place: dim x nodes, held nodes are left as they are. Precondition:
  /// the last factoring succeeded. Exact but for rounding where the matrix is symmetric or dim = 2,
  /// else to about `solution_error` in the norm of the inverse of its symmetric part; NaN if LU
  /// factors became necessary for that and the matrix is singular.
  void solve(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors);
  /// The same by the factors at hand alone: where they are of the symmetric part, with that part
  /// instead of the matrix, at a fraction of the cost.
  void solve_roughly(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors);
  /// Multiplies by what add() gave, in place; held nodes are left as they are.
  void multiply(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) const;

 private:
  class Band;
  class Sparse;
  using Storage = std::conditional_t<dim == 2, Band, Sparse>;

  HeldNodes held_;
  std::vector<int> number_;                   // of each node among the free ones, or -1
  std::vector<int> free_;                     // their nodes
  std::vector<std::pair<int, int>> coupled_;  // by number among the free nodes
  std::unique_ptr<Storage> storage_;
  template <class Change>
  void change_unknowns(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors, const Change&) const;
  mutable Eigen::VectorXd unknowns_;
};

}  // namespace pennon::dns
