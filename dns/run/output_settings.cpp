#include "dns/run/output_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/case/about_key.hpp"

namespace pennon::dns {

void declare(Schema& schema, ProbeSettings& probes) {
  schema
      .table("dns.probes",
             "Places (y, z) where the fluid's velocity and pressure are kept with the history, in "
             "every plane along the span: y[0] with z[0], and so on.")
      .key({"y", &probes.y, "in L", any_sign})
      .key({"z", &probes.z, "in L", any_sign});
}

void declare(Schema& schema, OutputSettings& output) {
  schema.table("dns.output", "What is kept, and how often.")
      .key({"history_interval", &output.history_interval,
            "between rows of the history, in L/V; 0: every step", not_negative})
      .key({"shape_interval", &output.shape_interval, "between shapes of the flag, in L/V; 0: none",
            not_negative})
      .key({"field_interval", &output.field_interval,
            "between fields of the fluid, in L/V; 0: none", not_negative})
      .key({"contour_times", &output.contour_times,
            "times at which the strain is drawn on the flag, in L/V: on the kept shape nearest to "
            "each; empty: on six shapes at equal intervals",
            not_negative})
      .key({"checkpoint_interval", &output.checkpoint_interval,
            "between checkpoints, in L/V; 0: none at equal times; there is always one at the end",
            not_negative})
      .key({"checkpoint_minutes", &output.checkpoint_minutes,
            "between checkpoints, in minutes that pass by the clock; 0: none", not_negative})
      .key({"probe_x", &output.probe_x,
            "x at rest of the place whose motion is kept; the nearest node is taken", not_negative})
      .key({"probe_y", &output.probe_y, "y at rest of that place", Range{0, 1}});
}

void check(const ProbeSettings& probes, double R, Faults& faults) {
  if (probes.y.size() != probes.z.size())
    about_key(faults, "dns.probes.z",
              fmt::format("has {} numbers and dns.probes.y has {}; each probe has one of each",
                          probes.z.size(), probes.y.size()));
  for (std::size_t k = 0; k < std::min(probes.y.size(), probes.z.size()); ++k)
    if (std::hypot(probes.y[k] - 0.5, probes.z[k]) >= R)
      about_key(faults, "dns.probes.y",
                fmt::format("[{}] lies outside the outer boundary, at the distance dns.R = {} from "
                            "mid-chord",
                            k, R));
}

}  // namespace pennon::dns
