/// Whatever a case file holds, it is either read or refused in words: no crash, no hang, nothing
/// else thrown. The environment may ask for more inputs than the ordinary tests try:
///
///   PENNON_FUZZ_INPUTS=1000000 build-sanitize/tests/test_common --gtest_filter='CaseFuzz.*'
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "tests/support/case_mutator.hpp"
#include "tests/support/every_type_case.hpp"

namespace pennon::test {
namespace {

constexpr std::uint64_t ordinary_inputs = 20000;
constexpr std::uint64_t first_seed = 1;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

// Reads one input, and what it resolves to again; returns whether it was read, not refused.
bool is_read(const std::string& text, const std::vector<std::string>& overrides) {
  EveryTypeCase found;
  try {
    found.read(text, overrides);
  } catch (const InputError& error) {
    EXPECT_FALSE(error.faults().empty());
    for (const InputFault& fault : error.faults()) EXPECT_NE(fault.what, "");
    return false;
  }
  const std::string resolved = resolved_text(found.schema());
  EveryTypeCase again;
  EXPECT_NO_THROW(again.read(resolved)) << resolved;
  EXPECT_EQ(resolved_text(again.schema()), resolved);
  return true;
}

TEST(CaseFuzz, EveryInputIsReadOrRefusedInWords) {
  using Clock = std::chrono::steady_clock;
  const std::uint64_t inputs = from_environment("PENNON_FUZZ_INPUTS", ordinary_inputs);
  const std::uint64_t seed = from_environment("PENNON_FUZZ_SEED", first_seed);
  std::uint64_t read = 0;
  Clock::duration slowest{};
  for (std::uint64_t i = 0; i < inputs; ++i) {
    CaseMutator mutator(seed + i);  // so that PENNON_FUZZ_SEED repeats any single input
    const std::string text = mutator.text();
    const std::vector<std::string> overrides = mutator.overrides();
    const auto begin = Clock::now();
    ASSERT_NO_THROW(read += is_read(text, overrides) ? 1 : 0) << "seed " << seed + i;
    slowest = std::max(slowest, Clock::now() - begin);
    ASSERT_FALSE(HasFailure()) << "seed " << seed + i << ", text:\n" << text;
  }
  EXPECT_LT(slowest, std::chrono::seconds(5));
  EXPECT_GT(read, inputs / 20) << "too few inputs get through to the later checks";
  RecordProperty("inputs_read", std::to_string(read));
}

}  // namespace
}  // namespace pennon::test
