/// Where flag and flow start: the table [dns.initial].
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/flag/settings.hpp"

namespace pennon::dns {

struct InitialSettings {
  std::vector<double> A, B;      ///< of (5.1)
  double angle = 0;              ///< of the straight flag about its leading edge, radians
  double plate_mode = 0;         ///< amplitude of sin(pi x/gamma) sin(pi y)
  double mode_amplitude = 0;     ///< of a normal or global mode, at its largest
  std::int64_t n = 0, m = 1;     ///< of that mode: waves along the span, number along the chord
  std::string global_modes;      ///< file of the global mode; empty: a normal mode
  std::int64_t global_mode = 1;  ///< its number in that file, from 1
  double ramp = 0;               ///< time over which the stream rises
  double release = 0;            ///< time until which a flag in the flow is held
  double kick = 0;               ///< momentum per area given to its trailing edge, rho_f V L
  double kick_duration = 0.1;    ///< in L/V
};

void declare(Schema&, InitialSettings&);
/// Starts that contradict each other, or the flag's edges.
void check(const InitialSettings&, const FlagSettings&, const FlagParameters&, Faults&);
/// What a start as a global mode needs; `is_coupled`: whether the flow moves the flag.
void check_global_start(const InitialSettings&, const FlagParameters&, bool is_coupled, Faults&);

}  // namespace pennon::dns
