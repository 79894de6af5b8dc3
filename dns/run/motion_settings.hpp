/// How a flag in the flow moves whatever the fluid does: the table [dns.motion]. What each kind
/// means stands in dns/run/prescribed_motion.hpp.
#pragma once

#include <cstdint>
#include <numbers>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"

namespace pennon::dns {

enum class MotionKind { rigid, heave, pitch, wave, mode };
enum class Envelope { uniform, linear };

struct MotionSettings {
  bool is_given = false;
  MotionKind kind = MotionKind::rigid;
  double amplitude = 0;  ///< A, in L or radians
  double frequency = 1;  ///< omega/(2 pi), in V/L
  double phase = 0;
  double k_y = 2 * std::numbers::pi;
  Envelope envelope = Envelope::linear;
  double axis = 0;            ///< y of the axis of pitch
  std::int64_t waves = 0;     ///< along the span
  double ramp = 0;            ///< time over which the amplitude rises
  std::int64_t n = 0, m = 1;  ///< of the mode: waves along the span, number along the chord
};

void declare(Schema&, MotionSettings&);
/// `n_x`: planes along the span.
void check(const MotionSettings&, std::int64_t n_x, const FlagParameters&, Faults&);

}  // namespace pennon::dns
