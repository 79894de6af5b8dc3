/// Snapshots band by band, as every method sees them: at equally spaced times, their mean removed
/// or kept, with their weights, in bounded memory. MPI ranks share the values of a snapshot.
#pragma once

#include <functional>

#include "analysis/decomposition/snapshots.hpp"
#include "analysis/decomposition/times.hpp"

namespace pennon::decomposition {

template <class Scalar>
struct BandOfData {
  Band band;
  DenseMatrix<Scalar> A;  ///< W^1/2 q, values x M: its plain squares add up to the norm
  Eigen::VectorXd mean_weight;
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> mean;  ///< of q, whether removed or not

  /// Modes of A as modes of q, in place: divides by the root of the mean weight; 0 where that is 0.
  void take_weight_from(Eigen::MatrixXd& modes) const;
  void take_weight_from(Eigen::MatrixXcd& modes) const;
};

/// How the data are prepared.
struct Preparation {
  bool removes_mean = true;
  bool is_weighted = true;  ///< else W = 1
  /// Weights that change with time are replaced by their mean: for methods that compare snapshots,
  /// so that what moves is q and not the weight.
  bool has_mean_weight = false;
  double memory = 1e9;  ///< bytes, of all ranks together
};

template <class Scalar>
class Bands {
 public:
  Bands(const Snapshots& snapshots, Preparation preparation);

  const Layout& layout() const { return snapshots_.layout(); }
  const TimeGrid& times() const { return times_; }
  Eigen::Index snapshots() const { return static_cast<Eigen::Index>(times_.t.size()); }
  bool removes_mean() const { return preparation_.removes_mean; }

  /// Calls `use` with each band of this rank, in order; equally often on every rank, so the last
  /// band may be empty. A method that needs `bytes_per_value` of its own for each value of a band,
  /// and `bytes` beside, says so: the bands are so narrow that all ranks together stay within the
  /// memory. Throws InputError where not even one value does.
  using Use = std::function<void(const BandOfData<Scalar>&)>;
  void for_each(double bytes_per_value, double bytes, const Use& use) const;

  /// The values of this rank.
  Band mine() const;

 private:
  void read(Band, BandOfData<Scalar>&) const;
  void apply_weights(BandOfData<Scalar>&) const;

  const Snapshots& snapshots_;
  Preparation preparation_;
  TimeGrid times_;
};

extern template struct BandOfData<double>;
extern template struct BandOfData<std::complex<double>>;
extern template class Bands<double>;
extern template class Bands<std::complex<double>>;

}  // namespace pennon::decomposition
