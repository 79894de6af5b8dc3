#include "dns/flag/flag.hpp"

#include <cassert>
#include <set>

namespace pennon::dns {
namespace {

HeldNodes held_nodes(const FlagMesh& mesh) {
  const auto holds = [](Edge edge) { return edge == Edge::pinned || edge == Edge::clamped; };
  const EdgeConditions& edges = mesh.edges();
  std::vector<bool> is_held(static_cast<std::size_t>(mesh.nodes()), false);
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      is_held[static_cast<std::size_t>(mesh.index(i, j))] =
          (j == 0 && holds(edges.leading)) ||
          (j == mesh.chord_nodes() - 1 && holds(edges.trailing)) || (i == 0 && holds(edges.left)) ||
          (i == mesh.stations() - 1 && holds(edges.right));
  return HeldNodes(std::move(is_held));
}

// Pairs of nodes that share a cell (a segment), or a term of the bending energy.
std::vector<std::pair<int, int>> coupled_nodes(const FlagMesh& mesh, const BendingForm& bending) {
  std::set<std::pair<int, int>> pairs;
  const int stations = mesh.stations();
  for (int i = 0; i < stations; ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj) {
          const int other_j = j + dj;
          int other_i = i + di;
          if (other_j < 0 || other_j >= mesh.chord_nodes()) continue;
          if (mesh.is_periodic()) other_i = (other_i + stations) % stations;
          if (other_i < 0 || other_i >= stations) continue;
          pairs.emplace(mesh.index(i, j), mesh.index(other_i, other_j));
        }
  for (int q = 0; q < bending.stiffness.outerSize(); ++q)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(bending.stiffness, q); entry; ++entry)
      pairs.emplace(static_cast<int>(entry.row()), q);
  return {pairs.begin(), pairs.end()};
}

}  // namespace

template <int dim>
Flag<dim>::Flag(FlagMesh mesh, const FlagMaterial& material)
    : mesh_(std::move(mesh)),
      material_(material),
      stretch_(mesh_, material.stretch()),
      bending_(bending_form(mesh_, material.bending())),
      bending_load_(bending_.load.bottomRows<dim>()),
      pressure_(mesh_),
      mass_(mesh_.nodes()),
      held_(held_nodes(mesh_)) {
  assert(mesh_.dimension() == dim);
  for (int i = 0; i < mesh_.stations(); ++i)
    for (int j = 0; j < mesh_.chord_nodes(); ++j)
      mass_[mesh_.index(i, j)] = material.mu * mesh_.area(i, j);
}

template <int dim>
std::unique_ptr<TangentMatrix<dim>> Flag<dim>::tangent_matrix() const {
  return std::make_unique<TangentMatrix<dim>>(held_, coupled_nodes(mesh_, bending_));
}

template <int dim>
FlagEnergies Flag<dim>::energies(const NodeVectors<dim>& x, const NodeVectors<dim>& v,
                                 const FlagLoads<dim>& loads) const {
  FlagEnergies energies;
  energies.kinetic = 0.5 * v.colwise().squaredNorm().dot(mass_);
  if (bends()) {
    Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, x.cols());
    positions.bottomRows<dim>() = x;
    energies.bending = bending_.energy(positions);
  }
  const auto stretch = stretch_.energy(x);
  energies.stretch_2d = stretch.two_d;
  energies.stretch_3d = stretch.three_d;
  energies.gravity = -loads.gravity.dot(x * mass_);
  return energies;
}

template <int dim>
void Flag<dim>::evaluate_load_forces(const FlagStep<dim>& step, const FlagLoads<dim>& loads,
                                     NodeVectors<dim>& forces) const {
  forces.setZero(dim, mesh_.nodes());
  if (loads.pressure.size() > 0) pressure_.add_forces(step, loads.pressure, forces);
  if (loads.node_forces.size() > 0) forces += loads.node_forces;
}

template <int dim>
void Flag<dim>::evaluate_forces(const FlagStep<dim>& step, const FlagLoads<dim>& loads,
                                NodeVectors<dim>& forces) const {
  evaluate_load_forces(step, loads, forces);
  stretch_.add_forces(step, forces);
  if (bends()) {
    const double share = step.share_of_end();
    forces -= bending_load_;
    for (int q = 0; q < bending_.stiffness.outerSize(); ++q)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(bending_.stiffness, q); entry; ++entry)
        forces.col(q) -= entry.value() * (share * step.end.col(entry.row()) +
                                          (1 - share) * step.start.col(entry.row()));
  }
  if (!loads.gravity.isZero(0))
    for (int node = 0; node < mesh_.nodes(); ++node)
      forces.col(node) += mass_[node] * loads.gravity;
}

template <int dim>
NodeVectors<dim> Flag<dim>::load_forces(const FlagStep<dim>& step,
                                        const FlagLoads<dim>& loads) const {
  NodeVectors<dim> result;
  evaluate_load_forces(step, loads, result);
  return result;
}

template <int dim>
NodeVectors<dim> Flag<dim>::forces(const FlagStep<dim>& step, const FlagLoads<dim>& loads) const {
  NodeVectors<dim> result;
  evaluate_forces(step, loads, result);
  return result;
}

template <int dim>
void Flag<dim>::add_tangent(const FlagStep<dim>& step, const FlagLoads<dim>& loads,
                            double mass_factor, TangentMatrix<dim>& tangent) const {
  using Block = Eigen::Matrix<double, dim, dim>;
  stretch_.add_tangent(step, tangent);
  if (loads.pressure.size() > 0) pressure_.add_tangent(step, loads.pressure, tangent);
  const double share = step.share_of_end();
  if (bends())
    for (int q = 0; q < bending_.stiffness.outerSize(); ++q)
      for (Eigen::SparseMatrix<double>::InnerIterator entry(bending_.stiffness, q); entry; ++entry)
        tangent.add(static_cast<int>(entry.row()), q, share * entry.value() * Block::Identity());
  if (mass_factor > 0)
    for (int p = 0; p < mesh_.nodes(); ++p)
      tangent.add(p, p, mass_factor * mass_[p] * Block::Identity());
}

template class Flag<2>;
template class Flag<3>;

}  // namespace pennon::dns
