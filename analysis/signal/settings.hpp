/// What a case asks of the analysis of its run: the table [analysis].
#pragma once

#include <cstdint>
#include <optional>

#include "common/case/case_reader.hpp"
#include "common/case/schema.hpp"

namespace pennon::analysis {

struct Settings {
  bool is_given = false;
  std::optional<double> from, to;      ///< of the linear phase, in L/V; none: it is sought
  double probe_y = 2, probe_z = 0.25;  ///< where f_v is taken: at the probe nearest to it
  std::int64_t periods = 5;            ///< at the end, over which a limit cycle is averaged
};

void declare(Schema&, Settings&);

/// The fault between keys: a window that ends before it begins.
void check(const Settings&, Faults&);

}  // namespace pennon::analysis
