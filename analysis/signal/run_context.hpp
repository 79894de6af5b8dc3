/// What the analysis of a run takes from its case, beside its own settings.
#pragma once

namespace pennon::analysis {

struct RunContext {
  double mu = 0;        ///< mass ratio of the flag; 0: unknown
  double U = 0;         ///< cross-flow, in V
  double ramp = 0;      ///< time over which the stream rises, in L/V
  double release = 0;   ///< until when the flag is held where it starts
  double kick_end = 0;  ///< when the kick after it is over; 0 without one
};

}  // namespace pennon::analysis
