/// The point in the parameters of flag and flow at which local stability is analysed, and the
/// assumptions of the analysis (the model).
///
/// Scales: chord L, inflow V, fluid density rho_f. Perturbations zeta = A exp(i(k_y y - omega t))
/// cos(k_x x), or with cross-flow the travelling wave A exp(i(k_x x + k_y y - omega t)).
#pragma once

#include <cmath>
#include <optional>

#include "common/boundary_layer.hpp"

namespace pennon::lsa {

struct Point {
  double mu = 0;    ///< mass ratio
  double Re = 0;    ///< Reynolds number
  double k_x = 0;   ///< spanwise wavenumber, 2 pi/gamma; 0 in two dimensions
  double k_y = 0;   ///< streamwise wavenumber
  double nu_s = 0;  ///< Poisson ratio
  double K_B = 0;   ///< bending stiffness; enters only if Model::bending
  double U = 0;     ///< cross-flow; enters only if Model::cross_flow
};

/// The added-mass coefficient c_m = m_a/(rho_f L); see lsa/added_mass.hpp.
enum class AddedMass { two_d, wu, lamb, minami };

/// `as_printed` keeps the misprints of (4.8b), (4.9), (4.10) and (4.11), so that the published
/// curves can be drawn; docs/theory/local-stability.md derives the consistent forms.
enum class Form { consistent, as_printed };

struct Model {
  AddedMass added_mass = AddedMass::wu;
  Form form = Form::consistent;
  bool bending = false;     ///< adds K_B (k_x^2 + k_y^2)^2 to the restoring force
  bool cross_flow = false;  ///< travelling wave in a stream with the spanwise component U
  double tension_coefficient = friction_of_both_faces;
  std::optional<double> tension_at;  ///< y in [0, 1]; none: where the tension is largest
};

/// The chordwise tension times Re^1/2: tension_coefficient times the share of the chord's drag that
/// the section at y carries. By (1.3) the share is 1 - sqrt(y), the drag of all that lies
/// downstream of y; printed above (4.1) is sqrt(y). Both are 1 where they are largest, which is the
/// value that (4.4) and the following take.
inline double tension_times_sqrt_Re(const Model& model) {
  if (!model.tension_at) return model.tension_coefficient;
  const double root = std::sqrt(*model.tension_at);
  return model.tension_coefficient * (model.form == Form::consistent ? 1 - root : root);
}

}  // namespace pennon::lsa
