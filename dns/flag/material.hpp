/// What a flag is made of, told by its energies. The equations ask a material for nothing but its
/// mass ratio, stretch() and bending(): another kind of material is another struct with these
/// three.
#pragma once

namespace pennon::dns {

/// With the strains e_1 along the chord, e_2 along the span and the shear x_1.x_2
///
///   E_s = stiffness/2 int int e_1^2 + spanwise e_2^2 + 2 coupling e_1 e_2 + shear (x_1.x_2)^2
///
/// and the tension of each segment grows by its stiffness times damping de/dt (Kelvin-Voigt).
struct StretchEnergy {
  double stiffness = 0;  ///< along the chord, > 0, in rho_f V^2 L
  double spanwise = 1;   ///< along the span, over that along the chord
  double coupling = 0;
  double shear = 0;
  double damping = 0;  ///< retardation time, in L/V
};

/// With the curvatures x_11, x_22 and the twist x_12
///
///   E_b = stiffness/2 int int |x_11|^2 + spanwise |x_22|^2 + 2 coupling x_11.x_22 + 2 twist
///   |x_12|^2
struct BendingEnergy {
  double stiffness = 0;  ///< along the chord, >= 0, in rho_f V^2 L^3
  double spanwise = 1;   ///< along the span, over that along the chord
  double coupling = 0;
  double twist = 0;
};

/// The isotropic plate of section 3.2.
struct FlagMaterial {
  double mu = 1;       ///< mass ratio rho_s h/(rho_f L)
  double K_B = 0;      ///< bending stiffness EI/(rho_f V^2 L^3)
  double K_S = 500;    ///< extensional stiffness Eh/((1 - nu_s^2) rho_f V^2 L)
  double nu_s = 0.3;   ///< Poisson ratio
  double damping = 0;  ///< retardation time of the stretch, in L/V

  StretchEnergy stretch() const {
    return {.stiffness = K_S, .coupling = nu_s, .shear = (1 - nu_s) / 2, .damping = damping};
  }
  BendingEnergy bending() const { return {.stiffness = K_B, .coupling = nu_s, .twist = 1 - nu_s}; }
};

}  // namespace pennon::dns
