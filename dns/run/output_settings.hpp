/// What a run keeps: the tables [dns.probes] and [dns.output].
#pragma once

#include <vector>

#include "common/case/case_reader.hpp"

namespace pennon::dns {

/// Places of the section where the fluid's velocity and pressure are kept, in every plane.
struct ProbeSettings {
  std::vector<double> y, z;
};

struct OutputSettings {
  double history_interval = 0;        ///< 0: every step
  double shape_interval = 0;          ///< 0: none
  std::vector<double> contour_times;  ///< of the shapes whose strain is drawn; empty: six
  double field_interval = 0;          ///< 0: none
  double checkpoint_interval = 0;     ///< in L/V; 0: none at equal times
  double checkpoint_minutes = 5;      ///< of wall time; 0: none as it passes
  double probe_x = 0, probe_y = 1;    ///< at rest: the nearest node's motion is kept
};

void declare(Schema&, ProbeSettings&);
void declare(Schema&, OutputSettings&);
/// `R`: radius of the outer boundary.
void check(const ProbeSettings&, double R, Faults&);

}  // namespace pennon::dns
