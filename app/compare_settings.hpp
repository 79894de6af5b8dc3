/// What a case asks of `pennon compare`: the table [compare].
#pragma once

#include <cstdint>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"

namespace pennon::app {

struct CompareSettings {
  bool is_given = false;
  std::vector<std::int64_t> waves;  ///< along the span; empty: 0, 1, 2, in two dimensions 0
};

void declare(Schema&, CompareSettings&);
/// The fault between keys: waves along a span that is not there.
void check(const CompareSettings&, const FlagParameters&, Faults&);
/// With its default.
std::vector<std::int64_t> waves_of(const CompareSettings&, const FlagParameters&);

}  // namespace pennon::app
