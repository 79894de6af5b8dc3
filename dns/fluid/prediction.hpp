/// The first half of a step of the fluid: the velocity without the new pressure,
///
///   D_t v* + ((v - v_g) . grad) v = - grad p^n + 1/Re lap v*,
///
/// D_t the backward difference at fixed grid coordinates. What carries the velocity is extrapolated
/// from the last two steps; the velocity that is carried, and friction, are implicit. Solved for
/// the change from the extrapolated velocity.
#pragma once

#include <memory>
#include <vector>

#include "dns/fluid/equations/momentum.hpp"
#include "dns/fluid/moving_grid.hpp"
#include "dns/fluid/parameters.hpp"
#include "dns/fluid/state.hpp"
#include "dns/fluid/step.hpp"
#include "dns/fluid/velocity_lines.hpp"
#include "dns/grid/span.hpp"
#include "dns/numerics/krylov.hpp"

namespace pennon::dns {

class Prediction {
 public:
  Prediction(const OGrid&, const Span&, const MovingGrid&, const FluidParameters&,
             const FluidTolerances&, const Upwinding&, const Manufactured&, int components,
             FluidScratch&, const std::shared_ptr<KrylovSpace>&);

  /// Writes v* into `velocity`, its difference from the extrapolated velocity into state.u_change,
  /// iterations and the Courant number into the summary. Precondition: state.p has its ghosts.
  /// Throws SolverError where the solver does not converge.
  void predict(const FluidStep&, const WallVelocity&, FluidState&,
               std::vector<Field<double>>& velocity, FluidStepSummary&);

 private:
  struct Components {  // of the velocity, first to end - 1, which are solved for together
    std::size_t first, end;
    std::size_t count() const { return end - first; }
  };
  // What the operator below needs to know, from the beginning of a prediction to its end.
  struct Problem {
    const FluidStep* step = nullptr;
    const FluidState* state = nullptr;
    const std::vector<Field<double>>* velocity = nullptr;  // extrapolated
    FieldLease C_s, C_t;          // what carries the velocity, in cells along s and t
    bool varies_along_x = false;  // whether the change of the velocity does
  };

  void find_convection(const FluidStep&, const std::vector<Field<double>>& velocity,
                       FluidStepSummary&);
  bool must_vary_along_x(const FluidStep&, const Field<double>& u_x) const;
  void find_right_side(const WallVelocity&, const FluidState&, std::size_t component,
                       std::vector<Field<double>>& velocity, double* right);
  void convect(const WallVelocity&, std::size_t component, Field<double>* f_xi,
               std::vector<Field<double>>& velocity, Field<double>& convected);
  void add_force(const FluidState&, std::size_t component, double* right) const;
  void solve(const Components&, const WallVelocity&, FluidState&,
             std::vector<Field<double>>& velocity, FluidStepSummary&);
  void multiply(const Components&, const double* in, double* out);
  const Field<double>* u_x() const;

  const Span& span_;
  const MovingGrid& moving_;
  const FluidParameters& parameters_;
  const FluidTolerances& tolerances_;
  Upwinding upwinding_;
  const Manufactured& manufactured_;
  Extent extent_;
  int components_;
  FluidScratch& scratch_;
  double widening_;
  std::vector<double> at_rest_;  // the velocity of a wall that does not move
  VelocityLines lines_;
  Krylov in_plane_, along_span_;
  Problem problem_;
};

}  // namespace pennon::dns
