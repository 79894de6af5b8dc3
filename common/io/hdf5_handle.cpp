#include "common/io/hdf5_handle.hpp"

#include <fmt/format.h>

#include <limits>

#include "common/errors.hpp"

namespace pennon::hdf5 {
namespace {

// Every file is closed by its owner. What the library would do besides at the end of the process
// crashes where a file could not be written to its end (a full disk), so it must not be done. This
// must come before any other call of the library, hence before main.
const herr_t has_no_end_of_its_own = H5dont_atexit();

}  // namespace

std::string library_words() {
  std::string words;
  const auto keep_first = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t {
    auto& kept = *static_cast<std::string*>(text);
    if (kept.empty() && error->desc != nullptr) kept = error->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &words);
  return words.empty() ? "HDF5 gave no reason" : words;
}

void check(herr_t status, const std::string& what) {
  if (status < 0) throw FileError(fmt::format("{}: {}", what, library_words()));
}

void silence_library() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hsize_t count(const Shape& shape) {
  hsize_t product = 1;
  for (const hsize_t extent : shape) {
    if (extent > 0 && product > std::numeric_limits<hsize_t>::max() / extent)
      throw FileError("an array has more values than 64 bits can count");
    product *= extent;
  }
  return product;
}

Handle::Handle(hid_t id, Closer closer, const std::string& what) : id_(id), closer_(closer) {
  if (id < 0) throw FileError(fmt::format("{}: {}", what, library_words()));
}

Handle::~Handle() {
  if (id_ >= 0) closer_(id_);
}

void Handle::close(const std::string& what) {
  check(closer_(std::exchange(id_, H5I_INVALID_HID)), what);
}

}  // namespace pennon::hdf5
