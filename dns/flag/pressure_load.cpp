#include "dns/flag/pressure_load.hpp"

#include <Eigen/Geometry>
#include <utility>

namespace pennon::dns {
namespace {

// Where a node is for the step: at the mean or the end position.
template <int dim>
Eigen::Matrix<double, dim, 1> position(const FlagStep<dim>& step, int node) {
  if (step.pairing == Pairing::end) return step.end.col(node);
  return (step.start.col(node) + step.end.col(node)) / 2;
}

Eigen::Vector2d turned(const Eigen::Vector2d& d) {
  return {-d[1], d[0]};
}

// Of a cell: from 00 to 11 and from 10 to 01; `period` lies between 0x and 1x.
std::pair<Eigen::Vector3d, Eigen::Vector3d> diagonals(const FlagStep<3>& step,
                                                      const std::array<int, 4>& nodes,
                                                      double period) {
  const Eigen::Vector3d shift = period * Eigen::Vector3d::UnitX();
  return {position(step, nodes[3]) - position(step, nodes[0]) + shift,
          position(step, nodes[1]) - position(step, nodes[2]) - shift};
}

// a x b as a matrix acting on b.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

}  // namespace

template <int dim>
PressureLoad<dim>::PressureLoad(const FlagMesh& mesh) : span_(mesh.span()) {
  const int last = mesh.chord_nodes() - 1;
  if constexpr (dim == 2) {
    for (int j = 0; j < last; ++j) elements_.push_back({{j, j + 1}, false});
  } else {
    const int steps = mesh.is_periodic() ? mesh.stations() : mesh.stations() - 1;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < last; ++j) {
        const int next = (i + 1) % mesh.stations();
        elements_.push_back(
            {{mesh.index(i, j), mesh.index(i, j + 1), mesh.index(next, j), mesh.index(next, j + 1)},
             next == 0});
      }
  }
}

template <int dim>
void PressureLoad<dim>::add_forces(const FlagStep<dim>& step, const Eigen::VectorXd& p,
                                   NodeVectors<dim>& forces) const {
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const auto& [nodes, crosses_seam] = elements_[n];
    Vector area;
    if constexpr (dim == 2) {
      area = turned(position(step, nodes[1]) - position(step, nodes[0]));
    } else {
      const auto [d_1, d_2] = diagonals(step, nodes, crosses_seam ? span_ : 0.0);
      area = d_1.cross(d_2) / 2;
    }
    const Vector share = p[static_cast<Eigen::Index>(n)] / static_cast<double>(corners) * area;
    for (const int node : nodes) forces.col(node) += share;
  }
}

template <int dim>
void PressureLoad<dim>::add_tangent(const FlagStep<dim>& step, const Eigen::VectorXd& p,
                                    TangentMatrix<dim>& tangent) const {
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const auto& [nodes, crosses_seam] = elements_[n];
    const double share =
        step.share_of_end() * p[static_cast<Eigen::Index>(n)] / static_cast<double>(corners);
    // d(area)/d(node) for each corner.
    std::array<Eigen::Matrix<double, dim, dim>, corners> by;
    if constexpr (dim == 2) {
      by[1] << 0, -1, 1, 0;
      by[0] = -by[1];
    } else {
      const auto [d_1, d_2] = diagonals(step, nodes, crosses_seam ? span_ : 0.0);
      by[3] = -cross_matrix(d_2) / 2;
      by[0] = -by[3];
      by[1] = cross_matrix(d_1) / 2;
      by[2] = -by[1];
    }
    for (const int row : nodes)
      for (std::size_t c = 0; c < corners; ++c) tangent.add(row, nodes[c], -share * by[c]);
  }
}

template class PressureLoad<2>;
template class PressureLoad<3>;

}  // namespace pennon::dns
