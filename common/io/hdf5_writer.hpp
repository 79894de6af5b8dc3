/// Writes HDF5 files of named arrays of doubles with attributes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "common/io/atomic_file.hpp"
#include "common/io/hdf5_handle.hpp"

namespace pennon::hdf5 {

using Attribute = std::variant<std::string, double, std::int64_t>;
using Attributes = std::map<std::string, Attribute>;

/// Writes a file. It has its final name only after finish(). Arrays and the library's own records
/// carry checksums (Fletcher's of 32 bits; HDF5 1.10 and later read such files), so that a reader
/// finds a damaged file. All members throw FileError.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path);

  void attributes(const Attributes&);  ///< of the file itself
  void write(const std::string& name, const Shape&, std::span<const double> values,
             const Attributes& = {});
  /// A text of any length, as a dataset of one string.
  void write_text(const std::string& name, const std::string& text);

  /// Declares an array to be filled in blocks of rows (along its first index) with write_rows().
  void declare(const std::string& name, const Shape&, const Attributes& = {});
  void write_rows(const std::string& name, hsize_t first_row, hsize_t rows,
                  std::span<const double> values);
  /// Part of a declared array: `counts` elements along each index from `start` on.
  void write_part(const std::string& name, const Shape& start, const Shape& counts,
                  std::span<const double> values);
  /// The names of all arrays so far as the text /arrays, by which a reader sees whether one was
  /// lost (Reader::expect_contents()).
  void write_contents();
  void finish();

 private:
  std::string says(const std::string& name) const;
  Handle create(const std::string& name, hid_t type, const Shape&, const Attributes&);

  AtomicFile target_;
  Handle file_;
  std::map<std::string, Handle> open_;  // what is declared
  std::vector<std::string> names_;
};

}  // namespace pennon::hdf5
