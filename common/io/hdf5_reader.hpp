/// Reads HDF5 files that others may have written, or damaged.
#pragma once

#include <complex>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/io/hdf5_handle.hpp"

namespace pennon::hdf5 {

struct Array {
  Shape shape;
  std::vector<double> values;  ///< the last index runs fastest
};

/// In the shape that an array must have: an extent of 1 or more, and one of 0 or more.
inline constexpr hsize_t any = H5S_UNLIMITED;
inline constexpr hsize_t any_or_none = H5S_UNLIMITED - 1;

/// Reads a file. Nothing in it is trusted: an array must be of numbers, have at most eight indices,
/// lie in the file itself (no links to other files, no storage elsewhere), and be no larger than
/// what the file holds of it; all that before memory is asked for. Its checksums must be right. All
/// members throw InputError that names the file and the array or attribute.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path);

  bool contains(const std::string& name) const;

  Array read(const std::string& name) const;
  /// With this shape, in which `any` and `any_or_none` may stand.
  Array read(const std::string& name, const Shape& expected) const;
  /// The values of an array with one index: so many, or one at least.
  std::vector<double> list(const std::string& name, hsize_t expected = any) const;
  /// Every strides[d]-th element along each index d, from the first.
  Array read_every(const std::string& name, const Shape& strides) const;
  /// Of an array of numbers, which may be complex.
  Shape shape(const std::string& name) const;
  Shape shape(const std::string& name, const Shape& expected) const;
  /// Part of an array: `counts` elements along each index from `start` on, so many as `values` has.
  void read_part(const std::string& name, const Shape& start, const Shape& counts,
                 std::span<double> values) const;
  void read_part(const std::string& name, const Shape& start, const Shape& counts,
                 std::span<std::complex<double>> values) const;
  /// Whether the numbers of an array are complex: compounds of two real ones, r and i.
  bool is_complex(const std::string& name) const;
  /// What Writer::write_text() wrote.
  std::string long_text(const std::string& name) const;

  /// Attributes of an array, or with name "/" of the file; `fallback` where there is none. One of
  /// another type, or with more than one value, is a fault.
  std::string text(const std::string& name, const std::string& attribute,
                   const std::string& fallback = {}) const;
  /// A list of texts; empty where there is none.
  std::vector<std::string> texts(const std::string& name, const std::string& attribute) const;
  double number(const std::string& name, const std::string& attribute, double fallback) const;
  /// One that must be there, finite.
  double number(const std::string& name, const std::string& attribute) const;
  /// A whole number from 0, which must be there.
  std::int64_t counted(const std::string& name, const std::string& attribute) const;

  /// Fails where an array is not there that Writer::write_contents() has listed.
  void expect_contents() const;

  const std::filesystem::path& path() const { return path_; }
  /// InputError about this file.
  [[noreturn]] void fail(const std::string& what) const;
  /// Fails at the first value that is not finite.
  void expect_finite(const std::string& name, const std::vector<double>& values) const;

 private:
  Handle open(const std::string& name) const;
  Handle open_numbers(const std::string& name) const;
  void read_part(const std::string& name, const Shape& start, const Shape& counts,
                 const Handle& type_in_memory, void* values) const;
  Shape checked_shape(const Handle& dataset, const std::string& name) const;
  bool has_attribute(const std::string& name, const std::string& attribute) const;
  Handle open_attribute(const std::string& name, const std::string& attribute) const;

  std::filesystem::path path_;
  Handle file_;
};

}  // namespace pennon::hdf5
