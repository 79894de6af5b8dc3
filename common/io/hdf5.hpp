/// HDF5 files of named arrays of doubles with attributes, written whole or not at all.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "common/io/atomic_file.hpp"

namespace pennon::hdf5 {

/// Owns one HDF5 identifier; converts to it where the C interface is called.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  /// Throws FileError with `what` and the library's words if `id` says that the call failed.
  Handle(hid_t id, Closer closer, const std::string& what);
  ~Handle();
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(other.closer_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
    return *this;
  }
  operator hid_t() const { return id_; }
  /// Closes now, and throws FileError if that fails (a full disk may show only here).
  void close(const std::string& what);

 private:
  hid_t id_;
  Closer closer_;
};

using Shape = std::vector<hsize_t>;
using Attribute = std::variant<std::string, double, std::int64_t>;
using Attributes = std::map<std::string, Attribute>;

struct Array {
  Shape shape;
  std::vector<double> values;  ///< the last index runs fastest
};

/// Writes a file. It has its final name only after finish(). All members throw FileError.
class Writer {
 public:
  explicit Writer(const std::filesystem::path& path);

  void attributes(const Attributes&);  ///< of the file itself
  void write(const std::string& name, const Shape&, std::span<const double> values,
             const Attributes& = {});

  /// Declares an array to be filled in blocks of rows (along its first index) with write_rows().
  void declare(const std::string& name, const Shape&, const Attributes& = {});
  void write_rows(const std::string& name, hsize_t first_row, hsize_t rows,
                  std::span<const double> values);
  void finish();

 private:
  std::string says(const std::string& name) const;
  Handle create(const std::string& name, const Shape&, const Attributes&);

  AtomicFile target_;
  Handle file_;
  std::map<std::string, Handle> open_;  // what is declared
};

/// Reads a file. All members throw InputError that names the file and what it lacks, and FileError
/// where what is there cannot be read.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path);

  bool contains(const std::string& name) const;
  Array read(const std::string& name) const;
  /// Every strides[d]-th element along each index d, from the first.
  Array read_every(const std::string& name, const Shape& strides) const;
  Shape shape(const std::string& name) const;
  /// Of an array, or with name "/" of the file; `fallback` where there is none.
  std::string text(const std::string& name, const std::string& attribute,
                   const std::string& fallback = {}) const;
  double number(const std::string& name, const std::string& attribute, double fallback) const;

 private:
  Handle open(const std::string& name) const;

  std::string path_;
  Handle file_;
};

}  // namespace pennon::hdf5
