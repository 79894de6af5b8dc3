/// Anderson's acceleration of a fixed-point iteration x <- x + f(x) (Anderson 1965; type II of
/// Walker & Ni 2011). Among the affine combinations of the last iterates it takes the one for which
/// the same combination of their f has the least norm, and adds that f to it.
#pragma once

#include <Eigen/Core>

namespace pennon::dns {

class Anderson {
 public:
  /// The size up to which the small least-squares problem has its memory on the stack.
  static constexpr int most_depth = 30;

  /// Keeps the differences to `depth` earlier iterates of n numbers, to most_depth at most.
  Anderson(Eigen::Index n, int depth);

  /// Forgets the earlier iterates.
  void restart() {
    kept_ = 0;
    has_last_ = false;
  }
  /// Overwrites x, for which f = f(x) was found, with the next iterate; n numbers each.
  void advance(Eigen::Ref<Eigen::VectorXd> x, const Eigen::Ref<const Eigen::VectorXd>& f);

 private:
  Eigen::MatrixXd next_differences_, f_differences_;  // of x + f and f; the oldest is replaced
  Eigen::MatrixXd products_;                          // of the columns of f_differences_
  Eigen::VectorXd last_next_, last_f_;
  Eigen::VectorXd right_, last_right_;  // products of those columns and f
  int kept_ = 0, next_ = 0;
  bool has_last_ = false;
};

}  // namespace pennon::dns
