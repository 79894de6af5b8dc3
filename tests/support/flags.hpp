/// Flags for tests: random shapes, plates, linear frequencies about an equilibrium.
#pragma once

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "dns/flag/flag.hpp"

namespace pennon::test {

using namespace pennon::dns;

inline EdgeConditions all_edges(Edge edge) {
  return {edge, edge, edge, edge};
}

/// Uniform random numbers up to `size` for each node.
template <int dim>
NodeVectors<dim> noise(const Flag<dim>& flag, double size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  NodeVectors<dim> vectors(dim, flag.mesh().nodes());
  for (double& value : vectors.reshaped()) value = uniform(random);
  return vectors;
}

template <int dim>
NodeVectors<dim> at_free_nodes(const Flag<dim>& flag, NodeVectors<dim> vectors) {
  flag.clear_held(vectors);
  return vectors;
}

/// A load per area along one component, as node forces.
template <int dim>
NodeVectors<dim> uniform_load(const Flag<dim>& flag, int component, double q) {
  NodeVectors<dim> forces = NodeVectors<dim>::Zero(dim, flag.mesh().nodes());
  forces.row(component) = q / flag.material().mu * flag.mass().transpose();
  return forces;
}

/// Angular frequencies and shapes of small motions about `x`, increasing: K v = omega^2 M v.
struct LinearModes {
  Eigen::VectorXd omega;
  Eigen::MatrixXd shapes;  ///< columns over the unknowns: the components of the free nodes in turn
};
template <int dim>
LinearModes linear_modes(const Flag<dim>& flag, const NodeVectors<dim>& x,
                         const FlagLoads<dim>& loads) {
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({x, x}, loads, 0, *tangent);
  const Eigen::MatrixXd stiffness = tangent->matrix();
  Eigen::VectorXd mass(stiffness.rows());
  for (std::size_t n = 0; n < tangent->free_nodes().size(); ++n)
    mass.segment<dim>(static_cast<Eigen::Index>(dim * n))
        .setConstant(flag.mass()[tangent->free_nodes()[n]]);
  const Eigen::VectorXd scale = mass.cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * stiffness *
                                                              scale.asDiagonal());
  return {solver.eigenvalues().cwiseMax(0).cwiseSqrt(), scale.asDiagonal() * solver.eigenvectors()};
}

/// The same of a flat flag across itself, which its motion in the plane does not touch: shapes over
/// the free nodes.
template <int dim>
LinearModes transverse_modes(const Flag<dim>& flag, const NodeVectors<dim>& x,
                             const FlagLoads<dim>& loads) {
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({x, x}, loads, 0, *tangent);
  const Eigen::MatrixXd all = tangent->matrix();
  const auto nodes = static_cast<Eigen::Index>(tangent->free_nodes().size());
  const auto across = Eigen::seqN(dim - 1, nodes, Eigen::fix<dim>);
  Eigen::VectorXd scale(nodes);
  for (Eigen::Index n = 0; n < nodes; ++n)
    scale[n] = 1 / std::sqrt(flag.mass()[tangent->free_nodes()[static_cast<std::size_t>(n)]]);
  const Eigen::MatrixXd stiffness = all(across, across);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * stiffness *
                                                              scale.asDiagonal());
  return {solver.eigenvalues().cwiseMax(0).cwiseSqrt(), scale.asDiagonal() * solver.eigenvectors()};
}

/// Order of convergence from errors on two grids whose spacing differs by `ratio` > 1.
inline double order(double coarse_error, double fine_error, double ratio) {
  return std::log(std::abs(coarse_error / fine_error)) / std::log(ratio);
}

}  // namespace pennon::test
