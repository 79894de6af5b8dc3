#include "tests/support/hdf5_mutator.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using Engine = std::mt19937_64;

std::size_t one_of(std::size_t count, Engine& engine) {
  return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine);
}
template <class List>
auto one_of(const List& list, Engine& engine) {
  return list[one_of(list.size(), engine)];
}

constexpr std::array<double, 12> numbers = {
    0,        -1,        1e300,
    -1e300,   0.5,       1e15,
    1e18,     2e-308,    std::numeric_limits<double>::quiet_NaN(),
    HUGE_VAL, -HUGE_VAL, 4294967296.0};

struct Extents {
  int count = 0;
  std::array<hsize_t, 12> sizes{};
};

Extents some_extents(hid_t dataset, Engine& engine) {
  Extents extents;
  const hid_t space = H5Dget_space(dataset);
  extents.count = std::max(0, H5Sget_simple_extent_ndims(space));
  if (extents.count <= 10) H5Sget_simple_extent_dims(space, extents.sizes.data(), nullptr);
  H5Sclose(space);
  switch (one_of(std::size_t{6}, engine)) {
    case 0:  // one index more, or less
      extents.sizes[static_cast<std::size_t>(extents.count++)] = 1 + one_of(std::size_t{3}, engine);
      break;
    case 1:
      extents.count = std::max(0, extents.count - 1);
      break;
    case 2:  // an extent more, less or none
      if (extents.count > 0)
        ++extents.sizes[one_of(static_cast<std::size_t>(extents.count), engine)];
      break;
    case 3:
      if (extents.count > 0) {
        hsize_t& extent = extents.sizes[one_of(static_cast<std::size_t>(extents.count), engine)];
        extent = extent > 0 ? extent - 1 : 0;
      }
      break;
    case 4:
      if (extents.count > 0)
        extents.sizes[one_of(static_cast<std::size_t>(extents.count), engine)] = 0;
      break;
    default:  // as many values with the indices in another order
      if (extents.count > 1) std::swap(extents.sizes[0], extents.sizes[1]);
  }
  return extents;
}

// A dataset with these extents, filled if it is small.
void make_dataset(hid_t file, const std::string& name, hid_t type, const Extents& extents,
                  Engine& engine) {
  const hid_t space = extents.count == 0
                          ? H5Screate(one_of(std::size_t{2}, engine) == 0 ? H5S_SCALAR : H5S_NULL)
                          : H5Screate_simple(extents.count, extents.sizes.data(), nullptr);
  const hid_t made =
      H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  const hssize_t values = H5Sget_simple_extent_npoints(space);
  if (made >= 0 && values > 0 && values < 1'000'000) {
    std::vector<double> data(static_cast<std::size_t>(values));
    for (double& value : data)
      value = one_of(std::size_t{20}, engine) == 0
                  ? one_of(numbers, engine)
                  : std::uniform_real_distribution<double>(-1, 1)(engine);
    H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
  }
  if (made >= 0) H5Dclose(made);
  H5Sclose(space);
}

std::string change_dataset(hid_t file, const std::string& name, Engine& engine) {
  const hid_t dataset = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  if (dataset < 0) return name + " is gone already";
  const Extents extents = some_extents(dataset, engine);
  const std::size_t what = one_of(std::size_t{9}, engine);
  if (what == 0) {  // values in place
    const hid_t space = H5Dget_space(dataset);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    H5Sclose(space);
    const hid_t type = H5Dget_type(dataset);
    const bool is_number = H5Tget_class(type) == H5T_FLOAT;
    H5Tclose(type);
    if (is_number && count > 0 && count < 10'000'000) {
      std::vector<double> values(static_cast<std::size_t>(count));
      H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
      values[one_of(values.size(), engine)] = one_of(numbers, engine);
      H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    }
    H5Dclose(dataset);
    return "a value of " + name;
  }
  H5Dclose(dataset);
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  switch (what) {
    case 1:
      return name + " deleted";
    case 2:
      H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      return name + " a group";
    case 3:
      make_dataset(file, name, H5T_NATIVE_INT, extents, engine);
      return name + " integers of another shape";
    case 4:
      make_dataset(file, name, H5T_C_S1, extents, engine);
      return name + " text";
    case 5: {  // more than there is memory for, never written
      const std::array<hsize_t, 3> huge = {1ULL << 31, 1ULL << 31, 3}, chunk = {64, 64, 3};
      const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
      const int indices = static_cast<int>(1 + one_of(std::size_t{3}, engine));
      H5Pset_chunk(storage, indices, chunk.data());
      const hid_t space = H5Screate_simple(indices, huge.data(), nullptr);
      const hid_t made = H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                    storage, H5P_DEFAULT);
      if (made >= 0) H5Dclose(made);
      H5Sclose(space);
      H5Pclose(storage);
      return name + " huge";
    }
    case 6:
      H5Lcreate_soft(name.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      return name + " a link to itself";
    default:
      make_dataset(file, name, H5T_NATIVE_DOUBLE, extents, engine);
      return name + " of another shape";
  }
}

std::string change_attribute(hid_t file, const std::string& object, const std::string& name,
                             Engine& engine) {
  if (H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) < 0)
    return "an attribute that is gone";
  const std::size_t what = one_of(std::size_t{6}, engine);
  if (what == 0) return fmt::format("attribute {} of {} deleted", name, object);
  const hid_t owner = H5Oopen(file, object.c_str(), H5P_DEFAULT);
  const std::array<hsize_t, 1> many = {1000};
  const hid_t space = what == 1   ? H5Screate_simple(1, many.data(), nullptr)
                      : what == 2 ? H5Screate(H5S_NULL)
                                  : H5Screate(H5S_SCALAR);
  hid_t type = H5Tcopy(H5T_NATIVE_DOUBLE);
  std::vector<double> values(1000, one_of(numbers, engine));
  const char* pointer = "variable";
  const void* data = values.data();
  if (what == 4) {
    H5Tclose(type);
    type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, 1 + one_of(std::size_t{400}, engine));
  } else if (what == 5) {
    H5Tclose(type);
    type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    data = &pointer;
  }
  const hid_t made = H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
  if (made >= 0) {
    if (what != 2) H5Awrite(made, type, data);
    H5Aclose(made);
  }
  H5Tclose(type);
  H5Sclose(space);
  H5Oclose(owner);
  return fmt::format("attribute {} of {} in another way ({})", name, object, what);
}

}  // namespace

Hdf5Mutator::Hdf5Mutator(const std::filesystem::path& original) : bytes_(read_text(original)) {
  const hid_t file = H5Fopen(original.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* self) -> herr_t {
    auto& mutator = *static_cast<Hdf5Mutator*>(self);
    if (info->type == H5O_TYPE_DATASET) mutator.datasets_.push_back(std::string("/") + name);
    return 0;
  };
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, add, this);
  std::vector<std::string> owners = datasets_;
  owners.push_back("/");
  for (const std::string& owner : owners) {
    const hid_t object = H5Oopen(file, owner.c_str(), H5P_DEFAULT);
    struct Found {
      Hdf5Mutator* self;
      const std::string* owner;
    } found{this, &owner};
    const auto keep = [](hid_t, const char* name, const H5A_info_t*, void* data) -> herr_t {
      const auto& [self, of] = *static_cast<Found*>(data);
      self->attributes_.push_back({*of, name});
      return 0;
    };
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &found);
    H5Oclose(object);
  }
  H5Fclose(file);
}

std::string Hdf5Mutator::write(std::uint64_t seed, const std::filesystem::path& copy) const {
  Engine engine(seed);
  const std::size_t changes = 1 + one_of(std::size_t{3}, engine);
  std::string said;
  if (one_of(std::size_t{4}, engine) == 0) {
    std::string bytes = bytes_;
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t at = one_of(bytes.size(), engine);
      bytes[at] = static_cast<char>(one_of(std::size_t{256}, engine));
      said += fmt::format("byte {}; ", at);
    }
    if (one_of(std::size_t{8}, engine) == 0) {
      bytes.resize(one_of(bytes.size(), engine));
      said += fmt::format("cut to {} bytes", bytes.size());
    }
    write_text(copy, bytes);
    return said;
  }
  write_text(copy, bytes_);
  const hid_t file = H5Fopen(copy.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  for (std::size_t k = 0; k < changes; ++k) {
    if (datasets_.empty() || (one_of(std::size_t{3}, engine) == 0 && !attributes_.empty())) {
      const Attribute& attribute = attributes_[one_of(attributes_.size(), engine)];
      said += change_attribute(file, attribute.object, attribute.name, engine) + "; ";
    } else {
      said += change_dataset(file, one_of(datasets_, engine), engine) + "; ";
    }
  }
  H5Fclose(file);
  return said;
}

}  // namespace pennon::test
