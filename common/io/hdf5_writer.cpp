#include "common/io/hdf5_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "common/errors.hpp"

namespace pennon::hdf5 {
namespace {

// Checksums are of chunks. A chunk is read and written whole, and the library keeps 1 MiB of them.
constexpr hsize_t chunk_bytes = 1 << 19;

Handle created_file(const std::filesystem::path& temporary, const std::string& what) {
  silence_library();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, what);
  // Since version 1.10 all of the library's own records have checksums.
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_LATEST), what);
  return {H5Fcreate(temporary.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access), H5Fclose, what};
}

// Whole rows of about chunk_bytes, or a part of one row.
Shape chunk_of(const Shape& shape) {
  Shape chunk = shape;
  hsize_t bytes = count(shape) * sizeof(double);
  for (hsize_t& extent : chunk) {
    if (bytes <= chunk_bytes) break;
    const hsize_t each = bytes / extent;
    extent = std::clamp<hsize_t>(chunk_bytes / each, 1, extent);
    bytes = each * extent;
  }
  return chunk;
}

Handle type_of_text(std::size_t size, const std::string& what) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type, std::max<std::size_t>(size, 1)), what);
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), what);
  check(H5Tset_cset(type, H5T_CSET_UTF8), what);
  return type;
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
    const Handle type = type_of_text(text->size(), what);
    write(type, text->empty() ? "\0" : text->data());
  } else if (const auto* number = std::get_if<double>(&value)) {
    write(H5T_NATIVE_DOUBLE, number);
  } else {
    write(H5T_NATIVE_INT64, &std::get<std::int64_t>(value));
  }
}

Shape shape_of(hid_t dataset, const std::string& what) {
  const Handle space(H5Dget_space(dataset), H5Sclose, what);
  Shape shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  check(H5Sget_simple_extent_dims(space, shape.data(), nullptr), what);
  return shape;
}

}  // namespace

Writer::Writer(const std::filesystem::path& path)
    : target_(path),
      file_(created_file(target_.temporary(), path.string() + " cannot be written")) {}

std::string Writer::says(const std::string& name) const {
  return fmt::format("{} ({}) cannot be written", target_.final_path().string(), name);
}

void Writer::attributes(const Attributes& attributes) {
  for (const auto& [name, value] : attributes) write_attribute(file_, name, value, says(name));
}

Handle Writer::create(const std::string& name, hid_t type, const Shape& shape,
                      const Attributes& attributes) {
  const std::string what = says(name);
  names_.push_back(name);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose, what);
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, what);
  check(H5Pset_create_intermediate_group(links, 1), what);
  const Handle storage(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  if (!shape.empty() && count(shape) > 0) {
    const Shape chunk = chunk_of(shape);
    check(H5Pset_chunk(storage, static_cast<int>(chunk.size()), chunk.data()), what);
    check(H5Pset_fletcher32(storage), what);
  }
  Handle dataset(H5Dcreate2(file_, name.c_str(), type, space, links, storage, H5P_DEFAULT),
                 H5Dclose, what);
  for (const auto& [key, value] : attributes) write_attribute(dataset, key, value, what);
  return dataset;
}

void Writer::declare(const std::string& name, const Shape& shape, const Attributes& attributes) {
  open_.emplace(name, create(name, H5T_NATIVE_DOUBLE, shape, attributes));
}

void Writer::write(const std::string& name, const Shape& shape, std::span<const double> values,
                   const Attributes& attributes) {
  assert(values.size() == count(shape));
  Handle dataset = create(name, H5T_NATIVE_DOUBLE, shape, attributes);
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
        says(name));
  dataset.close(says(name));
}

void Writer::write_text(const std::string& name, const std::string& text) {
  const Handle type = type_of_text(text.size(), says(name));
  Handle dataset = create(name, type, {1}, {});
  check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.empty() ? "\0" : text.data()),
        says(name));
  dataset.close(says(name));
}

void Writer::write_rows(const std::string& name, hsize_t first_row, hsize_t rows,
                        std::span<const double> values) {
  Shape counts = shape_of(open_.at(name), says(name));
  Shape start(counts.size(), 0);
  start[0] = first_row;
  counts[0] = rows;
  write_part(name, start, counts, values);
}

void Writer::write_part(const std::string& name, const Shape& start, const Shape& counts,
                        std::span<const double> values) {
  assert(values.size() == count(counts));
  const Handle& dataset = open_.at(name);
  const Handle in_memory(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr),
                         H5Sclose, says(name));
  const Handle in_file(H5Dget_space(dataset), H5Sclose, says(name));
  check(H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, counts.data(), nullptr),
        says(name));
  check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, values.data()),
        says(name));
}

void Writer::write_contents() {
  write_text(contents_text, fmt::format("{}", fmt::join(names_, "\n")));
}

void Writer::finish() {
  for (auto& [name, dataset] : open_) dataset.close(says(name));
  open_.clear();
  check(H5Fflush(file_, H5F_SCOPE_LOCAL), says("all of it"));
  file_.close(says("all of it"));
  target_.finish();
}

}  // namespace pennon::hdf5
