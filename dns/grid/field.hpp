/// Numbers on one lattice of the O-grid (cell centres, faces across rho or theta, or corners) in
/// all planes x = const of a rank, with two ghosts on each side. theta runs fastest.
///
/// Cell (j, i) lies between the corners (j, i) and (j + 1, i + 1); face (j, i) across rho lies
/// between the cells j - 1 and j, across theta between i - 1 and i.
#pragma once

#include <cstddef>
#include <vector>

namespace pennon::dns {

/// The cells of a field: planes, and cells along rho and theta.
struct Extent {
  int planes = 1;
  int n_rho = 0;
  int n_theta = 0;

  std::size_t cells_of_plane() const {
    return static_cast<std::size_t>(n_rho) * static_cast<std::size_t>(n_theta);
  }
  std::size_t cells() const { return static_cast<std::size_t>(planes) * cells_of_plane(); }
  /// Where the wall's (or the outer) face i of a plane stands among those of all planes.
  std::size_t wall_face(int plane, int i) const {
    return static_cast<std::size_t>(plane) * static_cast<std::size_t>(n_theta) +
           static_cast<std::size_t>(i);
  }
  std::size_t wall_faces() const { return wall_face(planes, 0); }
  bool operator==(const Extent&) const = default;
};

template <class Scalar>
class Field {
 public:
  static constexpr int ghosts = 2;
  // Between the planes: without it, common sizes put the same point of all planes into one set of
  // the cache, and transforms along x run a tenth slower.
  static constexpr std::size_t padding = 72;

  Field() = default;
  explicit Field(const Extent& extent, Scalar value = Scalar(0))
      : extent_(extent),
        row_(static_cast<std::size_t>(extent.n_theta + 2 * ghosts)),
        plane_(static_cast<std::size_t>(extent.n_rho + 2 * ghosts) * row_ + padding),
        values_(static_cast<std::size_t>(extent.planes) * plane_, value) {}

  const Extent& extent() const { return extent_; }
  bool empty() const { return values_.empty(); }

  /// The values (j, 0), (j, 1), ... of a plane; -2 <= j < n_rho + 2, and as many ghosts before and
  /// behind.
  Scalar* row(int plane, int j) { return values_.data() + offset(plane, j); }
  const Scalar* row(int plane, int j) const { return values_.data() + offset(plane, j); }

  /// All values, ghosts among them: for sums of fields.
  std::vector<Scalar>& values() { return values_; }
  const std::vector<Scalar>& values() const { return values_; }

  /// Fills the ghosts along theta of the rows first .. last - 1.
  void wrap_theta(int plane, int first, int last) {
    for (int j = first; j < last; ++j) {
      Scalar* f = row(plane, j);
      for (int g = 1; g <= ghosts; ++g) {
        f[-g] = f[extent_.n_theta - g];
        f[extent_.n_theta + g - 1] = f[g - 1];
      }
    }
  }

 private:
  std::size_t offset(int plane, int j) const {
    return static_cast<std::size_t>(plane) * plane_ + static_cast<std::size_t>(j + ghosts) * row_ +
           ghosts;
  }

  Extent extent_;
  std::size_t row_ = 0, plane_ = 0;
  std::vector<Scalar> values_;
};

}  // namespace pennon::dns
