/// One HDF5 identifier with its owner, and the library's words where a call of it failed.
#pragma once

#include <hdf5.h>

#include <string>
#include <utility>
#include <vector>

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

/// The extents of an array along its indices, of which the last runs fastest.
using Shape = std::vector<hsize_t>;

/// The number of values in an array of that shape. Throws FileError where no 64 bits count them.
hsize_t count(const Shape&);

/// The text that Writer::write_contents() leaves.
inline constexpr const char* contents_text = "/arrays";

/// Throws FileError with `what` and the library's words where a call failed.
void check(herr_t status, const std::string& what);

/// The innermost line of the library's stack of errors: its own words for what went wrong.
std::string library_words();

/// From now on faults of the library become exceptions and are not printed.
void silence_library();

}  // namespace pennon::hdf5
