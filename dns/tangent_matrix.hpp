/// The matrix of Newton's method for a flag: a block of dim x dim for each pair of coupled nodes.
/// Held nodes have no unknowns. The pattern is analysed once; filling, factoring and solving reuse
/// it.
///
/// Chordwise nodes alone (dim = 2) make a narrow band, solved by LAPACK; a flag with a span (dim =
/// 3) a sparse matrix, solved by UMFPACK. Both take any regular matrix: a buckling flag's is not
/// definite, and that of the discrete gradient not symmetric.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <utility>
#include <vector>

namespace pennon::dns {

template <int dim>
class TangentMatrix {
 public:
  using Block = Eigen::Matrix<double, dim, dim>;

  /// `is_held` for each node; `coupled`: ordered pairs of nodes, each once, (p, p) among them.
  TangentMatrix(const std::vector<bool>& is_held, const std::vector<std::pair<int, int>>& coupled);
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

  /// Factors what add() gave. False if it is singular to working precision.
  bool factor();
  /// Solves for the unknowns in place: dim x nodes, held nodes are left as they are. Precondition:
  /// the last factor() succeeded.
  void solve(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors);

 private:
  class Band;
  class Sparse;
  using Storage = std::conditional_t<dim == 2, Band, Sparse>;

  std::vector<int> number_;                   // of each node among the free ones, or -1
  std::vector<int> free_;                     // their nodes
  std::vector<std::pair<int, int>> coupled_;  // by rank among the free nodes
  std::unique_ptr<Storage> storage_;
  Eigen::VectorXd unknowns_;
};

}  // namespace pennon::dns
