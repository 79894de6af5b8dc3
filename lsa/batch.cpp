#include "lsa/batch.hpp"

#include "lsa/added_mass.hpp"

namespace pennon::lsa {
namespace {

template <AddedMass kind>
void fill_added_mass(PointBatch& points, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    points.c_m[i] = closed_form_added_mass<kind>(points.k_x[i], points.k_y[i]);
}

template <Form form, bool bending, bool cross_flow>
void solve_lanes(const Model& model, const PointBatch& points, std::size_t size,
                 StabilityBatch& out) {
  const double tension = tension_times_sqrt_Re(model);
  for (std::size_t i = 0; i < size; ++i) {
    const Point point{points.mu[i],   points.Re[i],  points.k_x[i], points.k_y[i],
                      points.nu_s[i], points.K_B[i], points.U[i]};
    const Stability s =
        solve<form>(coefficients(point, points.c_m[i], tension, bending, cross_flow));
    out.c_m[i] = s.c_m;
    out.P[i] = s.P;
    out.omega_r_plus[i] = s.omega_r_plus;
    out.omega_i_plus[i] = s.omega_i_plus;
    out.omega_r_minus[i] = s.omega_r_minus;
    out.omega_i_minus[i] = s.omega_i_minus;
    out.growth[i] = s.growth;
    out.frequency[i] = s.frequency;
    out.mu_cr[i] = s.mu_cr;
  }
}

// What the model switches off is not computed.
template <Form form>
void solve_lanes(const Model& model, const PointBatch& points, std::size_t size,
                 StabilityBatch& out) {
  if (model.bending && model.cross_flow)
    solve_lanes<form, true, true>(model, points, size, out);
  else if (model.bending)
    solve_lanes<form, true, false>(model, points, size, out);
  else if (model.cross_flow)
    solve_lanes<form, false, true>(model, points, size, out);
  else
    solve_lanes<form, false, false>(model, points, size, out);
}

}  // namespace

void PointBatch::fill(const Point& point) {
  mu.fill(point.mu);
  Re.fill(point.Re);
  k_x.fill(point.k_x);
  k_y.fill(point.k_y);
  nu_s.fill(point.nu_s);
  K_B.fill(point.K_B);
  U.fill(point.U);
}

void solve(const Model& model, PointBatch& points, std::size_t size, StabilityBatch& out) {
  switch (model.added_mass) {
    case AddedMass::two_d:
      fill_added_mass<AddedMass::two_d>(points, size);
      break;
    case AddedMass::wu:
      fill_added_mass<AddedMass::wu>(points, size);
      break;
    case AddedMass::lamb:
      fill_added_mass<AddedMass::lamb>(points, size);
      break;
    case AddedMass::minami:
      break;
  }
  if (model.form == Form::consistent)
    solve_lanes<Form::consistent>(model, points, size, out);
  else
    solve_lanes<Form::as_printed>(model, points, size, out);
}

}  // namespace pennon::lsa
