#include "modes/normal/chordwise_problem.hpp"

#include <cassert>

#include "modes/normal/gauss_legendre.hpp"

namespace pennon::modes {
namespace {

// Which of the space's functions meet the conditions at held edges: a run of them.
struct Admitted {
  Eigen::Index first, count;
};

Admitted admitted_by(const ChordwiseProblem& problem, const SplineSpace& space) {
  const bool is_clamped = problem.leading_edge == LeadingEdge::clamped && problem.K_B > 0;
  const Eigen::Index first = is_clamped ? 2 : 1;
  const Eigen::Index last = space.size() - (problem.is_held_at_trailing_edge ? 1 : 0);
  return {first, last - first};
}

// What the energy is made of at a point: Y, Y' and Y''.
constexpr int derivatives = 3;
using Density = Eigen::Matrix<Extended, derivatives, derivatives>;

// The energy at y as a quadratic form in Y, Y' and Y''.
Density energy_density(const ChordwiseProblem& problem, double y) {
  const Extended k_2 = static_cast<Extended>(problem.k_x) * problem.k_x;
  const Extended nu_s = problem.nu_s;
  Density density;
  density << k_2 * k_2, 0, -nu_s * k_2,  //
      0, 2 * (1 - nu_s) * k_2, 0,        //
      -nu_s * k_2, 0, 1;
  density *= problem.K_B;
  density(0, 0) += problem.spanwise(y);
  density(1, 1) += problem.tension(y);
  return density;
}

using Triplets = std::vector<Eigen::Triplet<Extended>>;

ExtendedSparse sparse(Eigen::Index rows, Eigen::Index columns, const Triplets& entries) {
  ExtendedSparse matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Three rows for each quadrature point.
GeneralisedEigenproblem assemble(const ChordwiseProblem& problem, const SplineSpace& space,
                                 const Admitted& admitted) {
  Triplets E, S, R;
  Eigen::Index row = 0;
  for (const QuadraturePoint& point : gauss_legendre(space.breaks())) {
    const SplineSpace::Local local = space.at(point.y);
    const Density density = point.weight * energy_density(problem, point.y);
    R.emplace_back(row, row, point.weight * problem.weight(point.y));
    for (int i = 0; i < derivatives; ++i) {
      for (int j = 0; j < derivatives; ++j) S.emplace_back(row + i, row + j, density(i, j));
      for (int j = 0; j < SplineSpace::functions_per_element; ++j) {
        const Eigen::Index column = local.first + j - admitted.first;
        if (column >= 0 && column < admitted.count)
          E.emplace_back(row + i, column, local.values(i, j));
      }
    }
    row += derivatives;
  }
  return {sparse(row, admitted.count, E), sparse(row, row, S), sparse(row, row, R)};
}

}  // namespace

ChordwiseShapes solve(const ChordwiseProblem& problem, const SplineSpace& space, int count,
                      const std::string& what) {
  const Admitted admitted = admitted_by(problem, space);
  assert(count < admitted.count);
  const Eigenpairs pairs =
      lowest_eigenpairs(assemble(problem, space, admitted), count, problem.scale, what);
  ChordwiseShapes shapes{{}, {}, pairs.worst_residual};
  for (Eigen::Index i = 0; i < count; ++i) {
    shapes.lambda.push_back(static_cast<double>(pairs.lambda[i]));
    ExtendedVector coefficients = ExtendedVector::Zero(space.size());
    coefficients.segment(admitted.first, admitted.count) = pairs.vectors.col(i);
    shapes.coefficients.push_back(std::move(coefficients));
  }
  return shapes;
}

}  // namespace pennon::modes
