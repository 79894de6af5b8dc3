#include "common/case/parameters.hpp"

namespace pennon {

void declare(Schema& schema, FlagParameters& flag) {
  schema.table("flag", "The flag, scaled by the chord L, the inflow V and the fluid density rho_f.")
      .key({"mu", &flag.mu, "mass ratio rho_s h/(rho_f L)", ranges::mu, true})
      .key({"K_B", &flag.K_B, "bending stiffness EI/(rho_f V^2 L^3)", ranges::K_B})
      .key({"K_S", &flag.K_S, "extensional stiffness Eh/((1 - nu_s^2) rho_f V^2 L)", positive})
      .key({"nu_s", &flag.nu_s, "Poisson ratio", ranges::nu_s})
      .key({"damping", &flag.damping,
            "retardation time of the stretch (Kelvin-Voigt): tension K_S (e + damping de/dt), in "
            "L/V",
            not_negative})
      .key({"gravity", &flag.gravity, "body acceleration g L/V^2 along x (span), y (chord), z",
            any_sign})
      .key({"leading_edge", choice(flag.leading_edge, {"pinned", "clamped"}),
            "how the edge y = 0 is held"})
      .key({"gamma", &flag.gamma, "span S/L of one period", ranges::gamma, false,
            "none: two dimensions"});
}

void declare(Schema& schema, FlowParameters& flow, bool& is_given) {
  schema.table("flow", "The stream.", &is_given)
      .key({"Re", &flow.Re, "Reynolds number V L/nu", ranges::Re, true})
      .key({"U", &flow.U, "cross-flow U/V along the span", ranges::U});
}

}  // namespace pennon
