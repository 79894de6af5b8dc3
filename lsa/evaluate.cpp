#include "lsa/evaluate.hpp"

#include "lsa/added_mass.hpp"

namespace pennon::lsa {

Coefficients coefficients(const Point& point, const Theory& theory) {
  const Model& model = theory.model;
  const double c_m = added_mass(model.added_mass, theory.minami, point.k_x, point.k_y);
  return coefficients(point, c_m, tension_times_sqrt_Re(model), model.bending, model.cross_flow);
}

Stability solve(const Point& point, const Theory& theory) {
  return solve(coefficients(point, theory), theory.model.form);
}

}  // namespace pennon::lsa
