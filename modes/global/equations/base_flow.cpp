#include "modes/global/equations/base_flow.hpp"

#include <fmt/format.h>

#include <Eigen/UmfPackSupport>
#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "modes/global/equations/jacobian.hpp"

namespace pennon::modes::global {
namespace {

constexpr double first_Re = 10;
constexpr double widest_step = 10;  // ratio of the Reynolds numbers of two solutions
constexpr double least_step = 1.05;
constexpr int most_iterations = 25;
constexpr double near = 0.03;               // changes of an unknown with which factors serve on
constexpr double shrinking = 0.1;           // of one change to the next while they do
constexpr double change_on_the_way = 1e-2;  // at which a Reynolds number before the last is left
// Of a velocity or the pressure by an iteration, the last one: with factors from nearby the next
// would be a hundred times smaller, rounding.
constexpr double last_change = 1e-11;

double largest_over_volume(const PlaneFlow<double>& R, const Field<double>& volume) {
  double largest = 0;
  for (int f = 0; f < R.fields(); ++f)
    for (int j = 0; j < volume.extent().n_rho; ++j)
      for (int i = 0; i < volume.extent().n_theta; ++i)
        largest = std::max(largest, std::abs(R.field(f).row(0, j)[i]) / volume.row(0, j)[i]);
  return largest;
}

// Newton's method at one Reynolds number. Near the solution the last factors serve on: the change
// then shrinks by about the change at which they were made, in a tenth of the time.
class Newton {
 public:
  Newton(const OGrid& grid, const PlaneParameters& parameters, int components)
      : equations_(grid, parameters, components),
        complex_equations_(grid, parameters, components),
        unknowns_(equations_.extent(), components, Symmetry::symmetric),
        R_(equations_.extent(), components) {
    // Half the entries, and solutions that the next iteration corrects anyway.
    factors_.umfpackControl()(UMFPACK_ORDERING) = UMFPACK_ORDERING_METIS;
    factors_.umfpackControl()(UMFPACK_STRATEGY) = UMFPACK_STRATEGY_SYMMETRIC;
    factors_.umfpackControl()(UMFPACK_IRSTEP) = 0;
  }

  // Whether q and is_inflow became a solution, to the last change of an unknown.
  bool solve(double enough, PlaneFlow<double>& q, std::vector<bool>& is_inflow, BaseFlow& found) {
    double change = 1;
    bool do_factors_serve = false;
    for (int iteration = 0;; ++iteration) {
      equations_.set_inflow(is_inflow);
      equations_.evaluate(q, nullptr, R_, nullptr);
      found.residual = largest_over_volume(R_, equations_.metrics().volume);
      const std::vector<bool> last = std::exchange(is_inflow, find_inflow());
      if (change < enough && last == is_inflow) break;
      if (iteration == most_iterations || !std::isfinite(found.residual)) return false;
      if ((!do_factors_serve || last != is_inflow) && !factor(q, last)) return false;
      const double before = std::exchange(change, step(q));
      do_factors_serve = change < near && change < shrinking * before;
      ++found.iterations;
      stop_if_interrupted("nothing is written before the modes are found");
    }
    found.forces = equations_.forces();
    return true;
  }

 private:
  std::vector<bool> find_inflow() const {
    std::vector<bool> is_inflow(equations_.extent().wall_faces());
    for (std::size_t i = 0; i < is_inflow.size(); ++i)
      is_inflow[i] = equations_.outer_flux()[i] < 0;
    return is_inflow;
  }

  // Whether the matrix is regular, as it is not at a fold of the flow over the Reynolds number.
  bool factor(const PlaneFlow<double>& q, const std::vector<bool>& is_inflow) {
    complex_equations_.set_inflow(is_inflow);
    J_ = jacobian(complex_equations_, q, unknowns_, false).in_plane;
    factors_.compute(J_);
    if (factors_.umfpackFactorizeReturncode() == UMFPACK_ERROR_out_of_memory)
      throw SolverError(
          fmt::format("there is not enough memory for the factors of {} unknowns of the "
                      "steady flow; a smaller modes.global.n_rho or n_theta needs less",
                      J_.rows()));
    return factors_.info() == Eigen::Success;
  }

  // The largest change of an unknown.
  double step(PlaneFlow<double>& q) {
    const Eigen::VectorXd change = factors_.solve(unknowns_.pack(R_));
    unknowns_.unpack<double>(unknowns_.pack(q) - change, q);
    return change.lpNorm<Eigen::Infinity>();
  }

  PlaneEquations<double> equations_;
  PlaneEquations<std::complex<double>> complex_equations_;
  HalfPlane unknowns_;
  PlaneFlow<double> R_;
  Eigen::SparseMatrix<double> J_;  // the factors refer to it
  Eigen::UmfPackLU<Eigen::SparseMatrix<double>> factors_;
};

// Where the uniform stream enters.
std::vector<bool> inflow_of_stream(const OGrid& grid, const PlaneParameters& parameters) {
  const PlaneEquations<double> equations(grid, parameters, 2);
  const Extent& extent = equations.extent();
  std::vector<bool> is_inflow(extent.wall_faces());
  for (int i = 0; i < extent.n_theta; ++i)
    is_inflow[static_cast<std::size_t>(i)] =
        equations.metrics().rho_faces.area_y.row(0, extent.n_rho)[i] < 0;
  return is_inflow;
}

void find_tension(BaseFlow& base) {
  const std::vector<double>& pull = base.forces.y;
  base.tension.assign(pull.size() + 1, 0);
  for (std::size_t s = pull.size(); s-- > 0;) base.tension[s] = base.tension[s + 1] + pull[s];
  base.drag_coefficient = 2 * base.tension.front();
}

}  // namespace

BaseFlow base_flow(const OGrid& grid, const PlaneParameters& parameters, int components) {
  const Extent extent{1, grid.n_rho(), grid.n_theta()};
  BaseFlow base{parameters, PlaneFlow<double>(extent, components), {}, {}, {}};
  std::ranges::fill(base.q.u[dns::along_y].values(), 1.0);
  if (components > 2) std::ranges::fill(base.q.u[dns::along_x].values(), parameters.U);
  base.is_inflow = inflow_of_stream(grid, parameters);
  double solved_Re = 0, step = widest_step;
  while (solved_Re != parameters.Re) {
    PlaneParameters now = parameters;
    now.Re = std::min(parameters.Re, solved_Re == 0 ? first_Re : solved_Re * step);
    PlaneFlow<double> q = base.q;
    std::vector<bool> is_inflow = base.is_inflow;
    const double enough = now.Re == parameters.Re ? last_change : change_on_the_way;
    if (Newton(grid, now, components).solve(enough, q, is_inflow, base)) {
      base.q = std::move(q);
      base.is_inflow = std::move(is_inflow);
      solved_Re = now.Re;
      continue;
    }
    step = std::sqrt(step);
    if (solved_Re == 0 || step < least_step)
      throw SolverError(fmt::format(
          "the steady flow past the flat flag was not found at Re = {:.6g}: Newton's method left a "
          "residual of {:.3g}; a larger modes.global.R or a finer grid may help",
          now.Re, base.residual));
  }
  find_tension(base);
  return base;
}

BaseFlow base_flow(const OGrid& grid, const PlaneParameters& parameters, int components,
                   const BaseFlow& nearby) {
  BaseFlow base{parameters, PlaneFlow<double>(nearby.q.p.extent(), components), {}, {}, {}};
  const int common = std::min(components, nearby.q.components());
  for (int c = 0; c < components; ++c) {
    if (c < common)
      base.q.field(c) = nearby.q.field(c);
    else
      std::ranges::fill(base.q.field(c).values(), parameters.U);
  }
  base.q.p = nearby.q.p;
  base.is_inflow = nearby.is_inflow;
  if (!Newton(grid, parameters, components).solve(last_change, base.q, base.is_inflow, base))
    return base_flow(grid, parameters, components);
  find_tension(base);
  return base;
}

double largest_residual(const OGrid& grid, const PlaneParameters& parameters, PlaneFlow<double> q,
                        const std::vector<bool>& is_inflow) {
  PlaneEquations<double> equations(grid, parameters, q.components());
  PlaneFlow<double> R(equations.extent(), q.components());
  equations.set_inflow(is_inflow);
  equations.evaluate(q, nullptr, R, nullptr);
  return largest_over_volume(R, equations.metrics().volume);
}

}  // namespace pennon::modes::global
