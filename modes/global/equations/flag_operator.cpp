#include "modes/global/equations/flag_operator.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "dns/flag/statics.hpp"

namespace pennon::modes::global {
namespace {

// Enough that a node meets each neighbour of the bending's differences once.
constexpr int stations_of_pattern = 5;

// Half of each segment's force to either node.
template <int dim>
dns::NodeVectors<dim> node_forces(const dns::FlagMesh& mesh, const SegmentForces<double>& forces) {
  const double half = (dim == 2 ? 1.0 : mesh.dx()) / 2;
  dns::NodeVectors<dim> at_nodes = dns::NodeVectors<dim>::Zero(dim, mesh.nodes());
  for (int m = 0; m < mesh.stations(); ++m)
    for (int s = 0; s + 1 < mesh.chord_nodes(); ++s)
      for (const int j : {s, s + 1}) {
        at_nodes(dim - 2, mesh.index(m, j)) += half * forces.y[static_cast<std::size_t>(s)];
        if constexpr (dim == 3)
          at_nodes(0, mesh.index(m, j)) += half * forces.x[static_cast<std::size_t>(s)];
      }
  return at_nodes;
}

// Stretched as the chordwise pull alone would have it.
template <int dim>
dns::NodeVectors<dim> stretched(const dns::Flag<dim>& flag, const std::vector<double>& pull) {
  const dns::FlagMesh& mesh = flag.mesh();
  const dns::NodeVectors<dim> rest = flag.rest();
  dns::NodeVectors<dim> x = rest;
  for (int m = 0; m < mesh.stations(); ++m) {
    double tension = 0;
    std::vector<double> strain(pull.size());
    for (std::size_t s = pull.size(); s-- > 0;) {
      strain[s] = (tension + pull[s] / 2) / flag.material().K_S;
      tension += pull[s];
    }
    for (int j = 1; j < mesh.chord_nodes(); ++j) {
      const int node = mesh.index(m, j);
      x.col(node) = x.col(node - 1) + (1 + strain[static_cast<std::size_t>(j - 1)]) *
                                          (rest.col(node) - rest.col(node - 1));
    }
  }
  return x;
}

template <int dim>
FlagOperator reduced(const dns::Flag<dim>& flag, const SegmentForces<double>& forces, double k_x) {
  const dns::FlagMesh& mesh = flag.mesh();
  const double share = dim == 2 ? 1.0 : mesh.dx();
  dns::FlagLoads<dim> loads;
  loads.node_forces = node_forces<dim>(mesh, forces);
  const dns::NodeVectors<dim> x = equilibrium(flag, forces);
  const auto tangent = flag.tangent_matrix();
  flag.add_tangent({x, x}, loads, 0, *tangent);
  const Eigen::SparseMatrix<double> matrix = tangent->matrix();
  const std::vector<int>& free = tangent->free_nodes();
  const int nodes = mesh.chord_nodes(),
            first = nodes - static_cast<int>(free.size()) / mesh.stations();
  FlagOperator result{Eigen::VectorXd(nodes - first),
                      Eigen::MatrixXcd::Zero(nodes - first, nodes - first)};
  for (int j = first; j < nodes; ++j)
    result.mass[j - first] = flag.mass()[mesh.index(0, j)] / share;
  result.nodes.reserve(static_cast<std::size_t>(nodes));
  for (int j = 0; j < nodes; ++j)
    result.nodes.push_back({dim == 2 ? 0.0 : x(0, mesh.index(0, j)), x(dim - 2, mesh.index(0, j))});
  // The rows of the first station; a node m stations away moves with exp(i k_x m dx).
  for (int q = 0; q < matrix.outerSize(); ++q)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, q); entry; ++entry) {
      if (entry.row() % dim != dim - 1 || q % dim != dim - 1) continue;
      const int p_node = free[static_cast<std::size_t>(entry.row() / dim)];
      const int q_node = free[static_cast<std::size_t>(q / dim)];
      if (p_node >= nodes) continue;
      const double x_q = mesh.is_two_d() ? 0 : mesh.x(q_node / nodes);
      const double distance = x_q > mesh.span() / 2 ? x_q - mesh.span() : x_q;
      result.stiffness(p_node - first, q_node % nodes - first) +=
          entry.value() / share * std::polar(1.0, k_x * distance);
    }
  return result;
}

}  // namespace

template <int dim>
dns::NodeVectors<dim> equilibrium(const dns::Flag<dim>& flag, const SegmentForces<double>& forces) {
  dns::FlagLoads<dim> loads;
  loads.node_forces = node_forces<dim>(flag.mesh(), forces);
  dns::NodeVectors<dim> x = stretched<dim>(flag, forces.y);
  find_equilibrium(flag, loads, x);
  return x;
}

template dns::NodeVectors<2> equilibrium(const dns::Flag<2>&, const SegmentForces<double>&);
template dns::NodeVectors<3> equilibrium(const dns::Flag<3>&, const SegmentForces<double>&);

FlagOperator flag_operator(const std::vector<double>& chord, dns::Edge leading_edge,
                           const dns::FlagMaterial& material, const SegmentForces<double>& forces,
                           double k_x, int stations) {
  dns::EdgeConditions edges;
  edges.leading = leading_edge;
  if (k_x == 0) return reduced<2>({dns::FlagMesh(chord, edges), material}, forces, 0);
  const double dx = 2 * std::numbers::pi / (std::abs(k_x) * stations);
  const dns::FlagMesh mesh(chord, stations_of_pattern, stations_of_pattern * dx, edges);
  return reduced<3>({mesh, material}, forces, k_x);
}

}  // namespace pennon::modes::global
