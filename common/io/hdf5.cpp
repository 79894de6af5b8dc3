#include "common/io/hdf5.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "common/errors.hpp"

namespace pennon::hdf5 {
namespace {

// Every file is closed by its owner. What the library would do besides at the end of the process
// crashes where a file could not be written to its end (a full disk), so it must not be done. This
// must come before any other call of the library, hence before main.
const herr_t has_no_end_of_its_own = H5dont_atexit();

// The innermost line of the library's error stack: its own words for what went wrong.
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

hid_t create_file(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // faults become exceptions, not printed stacks
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

hid_t open_file(const std::filesystem::path& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

void write_attribute(hid_t object, const std::string& name, const Attribute& value,
                     const std::string& what) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const auto write = [&](hid_t type, const void* data) {
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, what);
    check(H5Awrite(attribute, type, data), what);
  };
  if (const auto* text = std::get_if<std::string>(&value)) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
    check(H5Tset_size(type, std::max<std::size_t>(text->size(), 1)), what);
    check(H5Tset_strpad(type, H5T_STR_NULLPAD), what);
    check(H5Tset_cset(type, H5T_CSET_UTF8), what);
    write(type, text->empty() ? "\0" : text->data());
  } else if (const auto* number = std::get_if<double>(&value)) {
    write(H5T_NATIVE_DOUBLE, number);
  } else {
    write(H5T_NATIVE_INT64, &std::get<std::int64_t>(value));
  }
}

hsize_t count(const Shape& shape) {
  hsize_t product = 1;
  for (const hsize_t extent : shape) product *= extent;
  return product;
}

Shape shape_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose, "the shape of an array");
  Shape shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

}  // namespace

Handle::Handle(hid_t id, Closer closer, const std::string& what) : id_(id), closer_(closer) {
  if (id < 0) throw FileError(fmt::format("{}: {}", what, library_words()));
}

Handle::~Handle() {
  if (id_ >= 0) closer_(id_);
}

void Handle::close(const std::string& what) {
  check(closer_(std::exchange(id_, H5I_INVALID_HID)), what);
}

Writer::Writer(const std::filesystem::path& path)
    : target_(path),
      file_(create_file(target_.temporary()), H5Fclose, path.string() + " cannot be written") {}

std::string Writer::says(const std::string& name) const {
  return fmt::format("{} ({}) cannot be written", target_.final_path().string(), name);
}

void Writer::attributes(const Attributes& attributes) {
  for (const auto& [name, value] : attributes) write_attribute(file_, name, value, says(name));
}

Handle Writer::create(const std::string& name, const Shape& shape, const Attributes& attributes) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, says(name));
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, says(name));
  check(H5Pset_create_intermediate_group(links, 1), says(name));
  Handle dataset(
      H5Dcreate2(file_, name.c_str(), H5T_NATIVE_DOUBLE, space, links, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, says(name));
  for (const auto& [key, value] : attributes) write_attribute(dataset, key, value, says(name));
  return dataset;
}

void Writer::declare(const std::string& name, const Shape& shape, const Attributes& attributes) {
  open_.emplace(name, create(name, shape, attributes));
}

void Writer::write(const std::string& name, const Shape& shape, std::span<const double> values,
                   const Attributes& attributes) {
  assert(values.size() == count(shape));
  Handle dataset = create(name, shape, attributes);
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        says(name));
  dataset.close(says(name));
}

void Writer::write_rows(const std::string& name, hsize_t first_row, hsize_t rows,
                        std::span<const double> values) {
  const Handle& dataset = open_.at(name);
  Shape extent = shape_of(dataset);
  Shape start(extent.size(), 0);
  start[0] = first_row;
  extent[0] = rows;
  assert(values.size() == count(extent));
  const Handle in_memory(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                         H5Sclose, says(name));
  const Handle in_file(H5Dget_space(dataset), H5Sclose, says(name));
  check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
        says(name));
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, values.data()),
        says(name));
}

void Writer::finish() {
  for (auto& [name, dataset] : open_) dataset.close(says(name));
  open_.clear();
  check(H5Fflush(file_, H5F_SCOPE_LOCAL), says("all of it"));
  file_.close(says("all of it"));
  target_.finish();
}

Reader::Reader(const std::filesystem::path& path)
    : path_(path.string()), file_([&] {
        if (!std::filesystem::is_regular_file(path))
          throw InputError(path.string(), "there is no such file");
        const hid_t id = open_file(path);
        if (id < 0) throw InputError(path.string(), "is not an HDF5 file");
        return Handle(id, H5Fclose, path.string());
      }()) {}

bool Reader::contains(const std::string& name) const {
  for (std::size_t slash = name.find('/', 1);; slash = name.find('/', slash + 1)) {
    if (H5Lexists(file_, name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    if (slash == std::string::npos) return true;
  }
}

Handle Reader::open(const std::string& name) const {
  const hid_t id = contains(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID;
  if (id < 0) throw InputError(path_, "has no array " + name);
  Handle dataset(id, H5Dclose, path_ + " " + name);
  const Handle type(H5Dget_type(dataset), H5Tclose, path_ + " " + name);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    throw InputError(path_, "has an array " + name + " of something other than numbers");
  return dataset;
}

Shape Reader::shape(const std::string& name) const {
  return shape_of(open(name));
}

Array Reader::read(const std::string& name) const {
  return read_every(name, Shape(shape(name).size(), 1));
}

Array Reader::read_every(const std::string& name, const Shape& strides) const {
  const std::string what = path_ + " " + name + " cannot be read";
  Array array{shape(name), {}};
  assert(strides.size() == array.shape.size());
  for (std::size_t d = 0; d < strides.size(); ++d)
    array.shape[d] = (array.shape[d] + strides[d] - 1) / strides[d];
  array.values.resize(count(array.shape));
  if (array.values.empty()) return array;
  const Handle dataset = open(name);
  const Handle in_file(H5Dget_space(dataset), H5Sclose, what);
  const int rank = static_cast<int>(strides.size());
  const Shape start(strides.size(), 0);
  if (rank > 0)
    check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), strides.data(),
                              array.shape.data(), nullptr),
          what);
  const Handle in_memory(H5Screate_simple(rank, array.shape.data(), nullptr), H5Sclose, what);
  check(H5Dread(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, array.values.data()),
        what);
  return array;
}

std::string Reader::text(const std::string& name, const std::string& attribute,
                         const std::string& fallback) const {
  if (H5Aexists_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0) return fallback;
  const Handle handle(
      H5Aopen_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      path_ + " " + attribute);
  const Handle type(H5Aget_type(handle), H5Tclose, path_ + " " + attribute);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) return fallback;
  std::string value(H5Tget_size(type), '\0');
  check(H5Aread(handle, type, value.data()), path_ + " " + attribute);
  value.resize(std::min(value.find('\0'), value.size()));
  return value;
}

double Reader::number(const std::string& name, const std::string& attribute,
                      double fallback) const {
  if (H5Aexists_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT) <= 0) return fallback;
  const Handle handle(
      H5Aopen_by_name(file_, name.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      path_ + " " + attribute);
  const Handle type(H5Aget_type(handle), H5Tclose, path_ + " " + attribute);
  if (H5Tget_class(type) != H5T_FLOAT && H5Tget_class(type) != H5T_INTEGER) return fallback;
  double value = fallback;
  check(H5Aread(handle, H5T_NATIVE_DOUBLE, &value), path_ + " " + attribute);
  return value;
}

}  // namespace pennon::hdf5
