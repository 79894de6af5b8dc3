#include "dns/run/motion_settings.hpp"

#include <fmt/format.h>

#include "common/case/about_key.hpp"

namespace pennon::dns {

void declare(Schema& schema, MotionSettings& motion) {
  schema
      .table("dns.motion",
             "A flag in the flow that moves as prescribed: heave z = A sin(omega t + phase), pitch "
             "by that angle, wave z = A sin(k_y y - omega t + phase), mode z = A sin(omega t + "
             "phase) times a normal mode; times cos(2 pi waves x/gamma). All of the flag moves so: "
             "the "
             "leading edge of a flexible flag is held and cannot be driven.",
             &motion.is_given)
      .key({"kind", choice(motion.kind, {"rigid", "heave", "pitch", "wave", "mode"}),
            "what it does"})
      .key({"amplitude", &motion.amplitude, "A, in L; of pitch in radians", any_sign})
      .key({"frequency", &motion.frequency, "omega/(2 pi), in V/L", not_negative})
      .key({"phase", &motion.phase, "in radians", any_sign})
      .key({"k_y", &motion.k_y, "wavenumber of the wave, in 1/L", any_sign})
      .key({"envelope", choice(motion.envelope, {"uniform", "linear"}),
            "of the wave along the chord: 1 or y"})
      .key({"axis", &motion.axis, "y of the axis of pitch, in L", any_sign})
      .key({"waves", &motion.waves, "waves along the span", Range{0, 1e4}})
      .key({"ramp", &motion.ramp, "time over which the amplitude rises from 0, in L/V",
            not_negative})
      .key({"n", &motion.n, "waves along the span of the mode, of the family of [modes.normal]",
            Range{0, 200}})
      .key({"m", &motion.m, "number along the chord of the mode, from 1", Range{1, 200}});
}

void check(const MotionSettings& motion, std::int64_t n_x, const FlagParameters& flag,
           Faults& faults) {
  if (motion.kind != MotionKind::rigid && motion.waves > 0 && !flag.gamma)
    about_key(faults, "dns.motion.waves",
              "varies along the span, but without flag.gamma there is none");
  if (motion.kind == MotionKind::mode && motion.n > 0 && !flag.gamma)
    about_key(faults, "dns.motion.n",
              "varies along the span, but without flag.gamma there is none");
  if (flag.gamma && 3 * motion.waves >= n_x)
    about_key(faults, "dns.motion.waves",
              fmt::format("= {} needs dns.n_x of at least {}: the upper third of the Fourier "
                          "series is dropped",
                          motion.waves, 3 * motion.waves + 1));
}

}  // namespace pennon::dns
