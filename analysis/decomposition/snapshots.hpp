/// Snapshots: a quantity q at times t_m, m = 0 ... M - 1, as what is to be decomposed. They may lie
/// in files that are larger than the memory, so they are read in bands: some of the values of a
/// snapshot, at all times.
///
/// The values of a snapshot are its components one behind the other, each at all points: value i =
/// c N + p is component c at point p of N. A complex quantity has complex values.
///
/// The inner product of two snapshots (Towne, Schmidt & Colonius 2018, equation 2.6, discretised)
///
///     <a, b> = sum_i w_i conj(a_i) b_i
///
/// has weights that belong to the data: pieces of the flag, volumes of cells, or what the file
/// gives. On a grid that moves they change with time.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/linear_algebra/svd.hpp"

namespace pennon::decomposition {

/// Where the points lie along a span of the period S: station by station, so that point p is the
/// station p / points_of_station. The stations are equally spaced from x = 0.
struct Stations {
  double span = 1;  ///< S, in L
  std::size_t count = 1;
};

struct Layout {
  std::string name;                     ///< of the file or folder, for messages
  std::string quantity;                 ///< what is decomposed: "z of the flag, in L"
  std::vector<double> t;                ///< increasing
  std::size_t points = 0;               ///< N
  std::vector<std::string> components;  ///< their names
  bool is_complex = false;
  bool has_changing_weights = false;
  std::optional<Stations> stations = {};  ///< none in two dimensions, and where nothing says
  std::vector<double> y = {};  ///< of each point along the chord; empty where nothing says
  /// Of each point, `dimensions` numbers; empty where nothing says.
  std::vector<double> coordinates = {};
  std::size_t dimensions = 0;

  std::size_t values() const { return points * components.size(); }
  std::size_t snapshots() const { return t.size(); }
};

/// Some of the values of a snapshot: the first, and how many.
struct Band {
  std::size_t first = 0, count = 0;
};

class Snapshots {
 public:
  virtual ~Snapshots() = default;
  Snapshots(const Snapshots&) = delete;
  Snapshots& operator=(const Snapshots&) = delete;

  const Layout& layout() const { return layout_; }

  /// The values of a band into a matrix of count x M, a column for each time. Throws InputError
  /// where they cannot be read. Of a complex quantity the real read is a bug.
  virtual void read(Band, Eigen::MatrixXd& values) const = 0;
  virtual void read_complex(Band, Eigen::MatrixXcd& values) const;

  /// Its weights, each 0 or more: count x 1, or count x M where they change with time.
  virtual Eigen::MatrixXd weights(Band) const = 0;

 protected:
  explicit Snapshots(Layout layout) : layout_(std::move(layout)) {}

 private:
  Layout layout_;
};

/// The values as real or complex numbers.
inline void read_values(const Snapshots& snapshots, Band band, Eigen::MatrixXd& values) {
  snapshots.read(band, values);
}
inline void read_values(const Snapshots& snapshots, Band band, Eigen::MatrixXcd& values) {
  snapshots.read_complex(band, values);
}

/// Throws InputError that names the first time of a value that is not finite; `from`: which value
/// the first row is.
template <class Scalar>
void expect_finite(const Layout&, const DenseMatrix<Scalar>& values, std::size_t from);

}  // namespace pennon::decomposition
