#include "common/io/hdf5_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <sstream>

#include "common/errors.hpp"

namespace pennon::hdf5 {
namespace {

constexpr int most_indices = 8;
constexpr std::size_t longest_text = 1 << 20;
// What deflate, the densest of HDF5's own filters, makes of zeros.
constexpr hsize_t densest_filter = 1100;

Handle opened_file(const std::filesystem::path& path) {
  silence_library();
  if (!std::filesystem::exists(path)) throw InputError(path.string(), "there is no such file");
  if (!std::filesystem::is_regular_file(path))
    throw InputError(path.string(), "is no file: it is a folder or a device");
  // Parts of rows that are longer than this are read by themselves, and not with what lies around.
  constexpr std::size_t sieve_bytes = 1 << 14;
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path.string());
  check(H5Pset_sieve_buf_size(access, sieve_bytes), path.string());
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (id < 0)
    throw InputError(path.string(), "is not an HDF5 file, or is damaged: " + library_words());
  return {id, H5Fclose, path.string()};
}

bool is_number(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  return (kind == H5T_FLOAT || kind == H5T_INTEGER) && H5Tget_size(type) <= sizeof(long double);
}

// A compound of two real numbers named r and i, as h5py and MATLAB write complex ones.
bool is_complex_number(hid_t type) {
  if (H5Tget_class(type) != H5T_COMPOUND || H5Tget_nmembers(type) != 2) return false;
  const auto has = [&](unsigned index, const char* name) {
    char* found = H5Tget_member_name(type, index);
    const bool is_it = found != nullptr && std::string_view(found) == name;
    H5free_memory(found);
    const hid_t member = H5Tget_member_type(type, index);
    const bool is_real = member >= 0 && is_number(member) && H5Tget_class(member) == H5T_FLOAT;
    if (member >= 0) H5Tclose(member);
    return is_it && is_real;
  };
  return has(0, "r") && has(1, "i");
}

// How complex numbers lie in memory.
Handle complex_type(const std::string& what) {
  Handle type(H5Tcreate(H5T_COMPOUND, sizeof(std::complex<double>)), H5Tclose, what);
  check(H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE), what);
  check(H5Tinsert(type, "i", sizeof(double), H5T_NATIVE_DOUBLE), what);
  return type;
}

// The bytes that the values of a dataset can have by what the file holds of it.
hsize_t largest_size(hid_t dataset, const Handle& storage) {
  const hsize_t stored = H5Dget_storage_size(dataset);
  bool is_compressed = false;
  if (H5Pget_layout(storage) == H5D_CHUNKED)
    for (int k = 0; k < H5Pget_nfilters(storage); ++k) {
      std::size_t values = 0;
      unsigned flags = 0, how = 0;
      const H5Z_filter_t filter = H5Pget_filter2(storage, static_cast<unsigned>(k), &flags, &values,
                                                 nullptr, 0, nullptr, &how);
      if (filter != H5Z_FILTER_FLETCHER32 && filter != H5Z_FILTER_SHUFFLE) is_compressed = true;
    }
  if (!is_compressed) return stored;
  return stored > std::numeric_limits<hsize_t>::max() / densest_filter ? stored
                                                                       : stored * densest_filter;
}

std::string extent_text(hsize_t extent) {
  if (extent == any) return "n";
  if (extent == any_or_none) return "(none or more)";
  return fmt::format("{}", extent);
}

std::string shape_text(const Shape& shape) {
  std::vector<std::string> texts;
  for (const hsize_t extent : shape) texts.push_back(extent_text(extent));
  return shape.empty() ? "a single number" : fmt::format("{}", fmt::join(texts, " x "));
}

bool fits(hsize_t extent, hsize_t expected) {
  if (expected == any) return extent > 0;
  return expected == any_or_none || extent == expected;
}

}  // namespace

Reader::Reader(const std::filesystem::path& path) : path_(path), file_(opened_file(path)) {}

void Reader::fail(const std::string& what) const {
  throw InputError(path_.string(), what);
}

void Reader::expect_finite(const std::string& name, const std::vector<double>& values) const {
  const auto bad = std::ranges::find_if_not(values, [](double v) { return std::isfinite(v); });
  if (bad != values.end())
    fail(fmt::format("has {} at index {} of {}; every value must be finite", *bad,
                     bad - values.begin(), name));
}

bool Reader::contains(const std::string& name) const {
  for (std::size_t slash = name.find('/', 1);; slash = name.find('/', slash + 1)) {
    const std::string part = name.substr(0, slash);
    if (H5Lexists(file_, part.c_str(), H5P_DEFAULT) <= 0) return false;
    H5L_info_t link;
    if (H5Lget_info(file_, part.c_str(), &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD)
      fail("has a link at " + part + "; an array must stand in the file itself");
    if (slash == std::string::npos) return true;
  }
}

Handle Reader::open(const std::string& name) const {
  const hid_t id = contains(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID;
  if (id < 0) fail("has no array " + name);
  Handle dataset(id, H5Dclose, path_.string() + " " + name);
  const Handle storage(H5Dget_create_plist(dataset), H5Pclose, path_.string() + " " + name);
  const H5D_layout_t layout = H5Pget_layout(storage);
  if (H5Pget_external_count(storage) > 0 ||
      (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED))
    fail("has an array " + name + " whose values stand in another file");
  return dataset;
}

Handle Reader::open_numbers(const std::string& name) const {
  Handle dataset = open(name);
  const Handle type(H5Dget_type(dataset), H5Tclose, path_.string() + " " + name);
  if (!is_number(type)) fail("has an array " + name + " of something other than numbers");
  return dataset;
}

Shape Reader::checked_shape(const Handle& dataset, const std::string& name) const {
  const std::string what = path_.string() + " " + name;
  const Handle space(H5Dget_space(dataset), H5Sclose, what);
  const H5S_class_t kind = H5Sget_simple_extent_type(space);
  const int indices = H5Sget_simple_extent_ndims(space);
  if ((kind != H5S_SIMPLE && kind != H5S_SCALAR) || indices < 0)
    fail("has an array " + name + " without values");
  if (indices > most_indices)
    fail(fmt::format("has an array {} of {} indices; at most {} are read", name, indices,
                     most_indices));
  Shape shape(static_cast<std::size_t>(indices));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), what);

  const Handle type(H5Dget_type(dataset), H5Tclose, what);
  const Handle storage(H5Dget_create_plist(dataset), H5Pclose, what);
  const hsize_t there = largest_size(dataset, storage) / std::max<hsize_t>(H5Tget_size(type), 1);
  hsize_t values = 1;
  for (const hsize_t extent : shape) {
    if (extent > 0 && values > there / extent)
      fail(
          fmt::format("says that {} has {} values, but holds {} of them at most; it is damaged, "
                      "or was not written to its end",
                      name, shape_text(shape), there));
    values *= extent;
  }
  if (values > there)
    fail(
        fmt::format("says that {} has a value, but holds none; it is damaged, or was not written "
                    "to its end",
                    name));
  return shape;
}

Shape Reader::shape(const std::string& name) const {
  return checked_shape(is_complex(name) ? open(name) : open_numbers(name), name);
}

bool Reader::is_complex(const std::string& name) const {
  const Handle dataset = open(name);
  const Handle type(H5Dget_type(dataset), H5Tclose, path_.string() + " " + name);
  return is_complex_number(type);
}

Shape Reader::shape(const std::string& name, const Shape& expected) const {
  Shape found = shape(name);
  if (found.size() != expected.size() || !std::ranges::equal(found, expected, fits))
    fail(fmt::format("has an array {} of {}, where {} is needed", name, shape_text(found),
                     shape_text(expected)));
  return found;
}

Array Reader::read(const std::string& name) const {
  return read_every(name, Shape(shape(name).size(), 1));
}

Array Reader::read(const std::string& name, const Shape& expected) const {
  (void)shape(name, expected);
  return read(name);
}

std::vector<double> Reader::list(const std::string& name, hsize_t expected) const {
  return read(name, {expected}).values;
}

Array Reader::read_every(const std::string& name, const Shape& strides) const {
  const std::string what = path_.string() + " " + name + " cannot be read";
  Array array{shape(name), {}};
  if (strides.size() != array.shape.size())
    fail(fmt::format("has an array {} of {}, where {} indices are needed", name,
                     shape_text(array.shape), strides.size()));
  for (std::size_t d = 0; d < strides.size(); ++d)
    array.shape[d] = (array.shape[d] + strides[d] - 1) / strides[d];
  array.values.resize(count(array.shape));
  if (array.values.empty()) return array;
  const Handle dataset = open_numbers(name);
  const Handle in_file(H5Dget_space(dataset), H5Sclose, what);
  const int rank = static_cast<int>(strides.size());
  const Shape start(strides.size(), 0);
  if (rank > 0)
    check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), strides.data(),
                              array.shape.data(), nullptr),
          what);
  const Handle in_memory(H5Screate_simple(rank, array.shape.data(), nullptr), H5Sclose, what);
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, array.values.data()) < 0)
    fail(fmt::format("has an array {} that cannot be read: {}", name, library_words()));
  return array;
}

void Reader::read_part(const std::string& name, const Shape& start, const Shape& counts,
                       std::span<double> values) const {
  assert(values.size() == count(counts));
  (void)open_numbers(name);
  const Handle type(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose, path_.string());
  read_part(name, start, counts, type, values.data());
}

void Reader::read_part(const std::string& name, const Shape& start, const Shape& counts,
                       std::span<std::complex<double>> values) const {
  assert(values.size() == count(counts));
  if (!is_complex(name)) fail("has an array " + name + " of something other than complex numbers");
  read_part(name, start, counts, complex_type(path_.string()), values.data());
}

void Reader::read_part(const std::string& name, const Shape& start, const Shape& counts,
                       const Handle& type_in_memory, void* values) const {
  const std::string what = path_.string() + " " + name + " cannot be read";
  const Shape whole = shape(name);
  assert(start.size() == whole.size() && counts.size() == whole.size());
  const Handle dataset = open(name);
  const Handle in_file(H5Dget_space(dataset), H5Sclose, what);
  check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr),
        what);
  const Handle in_memory(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr),
                         H5Sclose, what);
  if (H5Dread(dataset, type_in_memory, in_memory, in_file, H5P_DEFAULT, values) < 0)
    fail(fmt::format("has an array {} that cannot be read: {}", name, library_words()));
}

std::string Reader::long_text(const std::string& name) const {
  const Handle dataset = open(name);
  const std::string what = path_.string() + " " + name;
  const Handle type(H5Dget_type(dataset), H5Tclose, what);
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || size > longest_text ||
      checked_shape(dataset, name) != Shape{1})
    fail(fmt::format("has {}, where one text of at most {} bytes is needed", name, longest_text));
  std::string value(size, '\0');
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data()) < 0)
    fail(fmt::format("has a text {} that cannot be read: {}", name, library_words()));
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

void Reader::expect_contents() const {
  std::istringstream names(long_text(contents_text));
  for (std::string name; std::getline(names, name);)
    if (!contains(name)) fail("has no array " + name + ", which was written");
}

bool Reader::has_attribute(const std::string& name, const std::string& attribute) const {
  if (name != "/" && !contains(name)) fail("has no array " + name);
  return H5Aexists_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT) > 0;
}

Handle Reader::open_attribute(const std::string& name, const std::string& attribute) const {
  const hid_t id =
      H5Aopen_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0)
    fail(fmt::format("has an attribute {} of {} that cannot be read: {}", attribute, name,
                     library_words()));
  Handle handle(id, H5Aclose, path_.string());
  const Handle space(H5Aget_space(handle), H5Sclose, path_.string());
  if (H5Sget_simple_extent_npoints(space) != 1)
    fail(fmt::format("has an attribute {} of {} with other than one value", attribute, name));
  return handle;
}

std::string Reader::text(const std::string& name, const std::string& attribute,
                         const std::string& fallback) const {
  if (!has_attribute(name, attribute)) return fallback;
  const Handle handle = open_attribute(name, attribute);
  const Handle type(H5Aget_type(handle), H5Tclose, path_.string());
  const auto cannot = [&] {
    fail(fmt::format("has an attribute {} of {} that cannot be read as a text", attribute, name));
  };
  if (H5Tget_class(type) != H5T_STRING) cannot();
  std::string value;
  if (H5Tis_variable_str(type) > 0) {
    char* pointer = nullptr;
    if (H5Aread(handle, type, &pointer) < 0) cannot();
    if (pointer != nullptr) value = pointer;
    H5free_memory(pointer);
  } else {
    const std::size_t size = H5Tget_size(type);
    if (size > longest_text) cannot();
    value.resize(size);
    if (H5Aread(handle, type, value.data()) < 0) cannot();
    value.resize(std::min(value.find('\0'), value.size()));
  }
  return value;
}

std::vector<std::string> Reader::texts(const std::string& name,
                                       const std::string& attribute) const {
  constexpr hsize_t most_texts = 4096;
  if (!has_attribute(name, attribute)) return {};
  const auto cannot = [&] {
    fail(fmt::format("has an attribute {} of {} that is no list of texts", attribute, name));
  };
  const hid_t id =
      H5Aopen_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0) cannot();
  const Handle handle(id, H5Aclose, path_.string());
  const Handle type(H5Aget_type(handle), H5Tclose, path_.string());
  const Handle space(H5Aget_space(handle), H5Sclose, path_.string());
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || count < 1 || count > static_cast<hssize_t>(most_texts) ||
      H5Sget_simple_extent_ndims(space) > 1 || size > longest_text / most_texts)
    cannot();
  std::vector<std::string> found(static_cast<std::size_t>(count));
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> pointers(found.size(), nullptr);
    if (H5Aread(handle, type, static_cast<void*>(pointers.data())) < 0) cannot();
    for (std::size_t k = 0; k < found.size(); ++k)
      if (pointers[k] != nullptr) found[k] = pointers[k];
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, static_cast<void*>(pointers.data()));
  } else {
    std::string all(found.size() * size, '\0');
    if (H5Aread(handle, type, all.data()) < 0) cannot();
    for (std::size_t k = 0; k < found.size(); ++k) {
      found[k] = all.substr(k * size, size);
      found[k].resize(std::min(found[k].find('\0'), found[k].size()));
    }
  }
  return found;
}

double Reader::number(const std::string& name, const std::string& attribute,
                      double fallback) const {
  if (!has_attribute(name, attribute)) return fallback;
  const Handle handle = open_attribute(name, attribute);
  const Handle type(H5Aget_type(handle), H5Tclose, path_.string());
  double value = fallback;
  if (!is_number(type) || H5Aread(handle, H5T_NATIVE_DOUBLE, &value) < 0)
    fail(fmt::format("has an attribute {} of {} that is no number", attribute, name));
  return value;
}

double Reader::number(const std::string& name, const std::string& attribute) const {
  if (!has_attribute(name, attribute))
    fail(fmt::format("lacks the attribute {} of {}", attribute, name));
  const double value = number(name, attribute, 0);
  if (!std::isfinite(value))
    fail(fmt::format("has {} for the attribute {} of {}; it must be finite", value, attribute,
                     name));
  return value;
}

std::int64_t Reader::counted(const std::string& name, const std::string& attribute) const {
  constexpr double most = 1e15;
  const double value = number(name, attribute);
  if (!(value >= 0 && value <= most && value == std::floor(value)))
    fail(fmt::format("has {} for the attribute {} of {}; it must be a whole number from 0", value,
                     attribute, name));
  return static_cast<std::int64_t>(value);
}

}  // namespace pennon::hdf5
