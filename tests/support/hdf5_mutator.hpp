/// Damages HDF5 files as a careless or malicious hand would: whole objects are deleted, replaced by
/// others of another type, rank or size, attributes turned into arrays, texts into numbers, and
/// single bytes changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pennon::test {

class Hdf5Mutator {
 public:
  /// Reads which objects the file has.
  explicit Hdf5Mutator(const std::filesystem::path& original);

  /// Writes a copy with one to three changes, the same for the same seed; says what they are.
  std::string write(std::uint64_t seed, const std::filesystem::path& copy) const;

 private:
  struct Attribute {
    std::string object, name;
  };

  std::string bytes_;
  std::vector<std::string> datasets_;
  std::vector<Attribute> attributes_;
};

}  // namespace pennon::test
