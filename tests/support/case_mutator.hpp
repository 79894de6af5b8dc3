/// Wrong case files without end: cases, pieces of TOML and binary data, spoilt at random, the same
/// for the same seed.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace pennon::test {

class CaseMutator {
 public:
  explicit CaseMutator(std::uint64_t seed) : random_(seed) {}

  /// The text of a case file; at most 64 KiB.
  std::string text();
  /// None to three --set assignments.
  std::vector<std::string> overrides();

 private:
  std::size_t below(std::size_t end);
  const std::string& any_of(const std::vector<std::string>& choices);
  std::string random_bytes(std::size_t most);
  std::string nest();
  void spoil(std::string& text);

  std::mt19937_64 random_;
};

}  // namespace pennon::test
