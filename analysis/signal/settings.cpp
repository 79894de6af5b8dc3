#include "analysis/signal/settings.hpp"

#include <fmt/format.h>

namespace pennon::analysis {

void declare(Schema& schema, Settings& settings) {
  schema.table("analysis", "What `pennon analyze` does with the run.", &settings.is_given)
      .key({"from", &settings.from, "begin of the linear phase, in L/V", not_negative, false,
            "sought"})
      .key({"to", &settings.to, "its end, in L/V", not_negative, false, "sought"})
      .key({"probe_y", &settings.probe_y,
            "the shedding frequency is that of the probe nearest to (probe_y, probe_z), in L",
            any_sign})
      .key({"probe_z", &settings.probe_z, "the same, in L", any_sign})
      .key({"periods", &settings.periods,
            "whole periods at the end over which the limit cycle is averaged", Range{3, 1000}});
}

void check(const Settings& settings, Faults& faults) {
  if (settings.from && settings.to && *settings.from >= *settings.to)
    faults.about("analysis.to", fmt::format("analysis.to = {} must be above analysis.from = {}",
                                            *settings.to, *settings.from));
}

}  // namespace pennon::analysis
