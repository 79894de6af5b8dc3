#include "dns/coupling/added_mass.hpp"
#include "common/parallel/interrupted_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/flat_pressure.hpp"
#include "dns/grid/span.hpp"

namespace pennon::dns {
namespace {

using std::numbers::pi;

// Rows: the cosines and sines of the periodic stations, orthonormal; their numbers of waves.
Eigen::MatrixXd real_fourier(int stations, std::vector<int>& waves) {
  Eigen::MatrixXd rows(stations, stations);
  waves.resize(static_cast<std::size_t>(stations));
  for (int k = 0; k < stations; ++k) {
    const int n = std::min(k, stations - k);
    waves[static_cast<std::size_t>(k)] = n;
    const double norm = std::sqrt((n == 0 || 2 * n == stations ? 1.0 : 2.0) / stations);
    for (int m = 0; m < stations; ++m) {
      const double angle = 2 * pi * (static_cast<double>(n) * m) / stations;
      rows(k, m) = norm * (2 * k <= stations ? std::cos(angle) : std::sin(angle));
    }
  }
  return rows;
}

// E M^-1 E^T of the flat flag, its leading edge held.
Eigen::MatrixXd flat_compliance(const FlagMesh& mesh, double mu) {
  const int segments = mesh.chord_nodes() - 1;
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(segments, segments + 1);
  Eigen::VectorXd inverse_mass(segments + 1);
  for (int s = 0; s < segments; ++s) E(s, s) = E(s, s + 1) = mesh.dy(s) / 2;
  for (int j = 0; j <= segments; ++j) inverse_mass[j] = 1 / (mu * mesh.chord_share(j));
  inverse_mass[0] = 0;
  return E * inverse_mass.asDiagonal() * E.transpose();
}

}  // namespace

Eigen::MatrixXd flat_jump_response(const OGrid& grid, double k) {
  const int n_theta = grid.n_theta(), segments = n_theta / 2;
  FlatPressure flat(grid, k);
  Eigen::MatrixXd response(segments, segments);
  std::vector<double> p(static_cast<std::size_t>(grid.n_rho()) * static_cast<std::size_t>(n_theta));
  for (int s = 0; s < segments; ++s) {
    // lap p = -d/dt div v: what comes through the wall into the cell above leaves the one below.
    ranks::stop_if_interrupted_alone();
    std::ranges::fill(p, 0.0);
    p[static_cast<std::size_t>(upper_face(n_theta, s))] = -1;
    p[static_cast<std::size_t>(lower_face(n_theta, s))] = 1;
    flat.solve(p.data());
    const auto at_wall = [&](int face) {
      const double* f = p.data() + face;
      return wall_value(f[0], f[n_theta], f[2 * static_cast<std::ptrdiff_t>(n_theta)]);
    };
    for (int other = 0; other < segments; ++other)
      response(other, s) =
          at_wall(upper_face(n_theta, other)) - at_wall(lower_face(n_theta, other));
  }
  return response;
}

template <int dim>
AddedMass<dim>::AddedMass(const OGrid& grid, const FlagMesh& mesh, double mu)
    : stations_(mesh.stations()),
      segments_(mesh.chord_nodes() - 1),
      share_(mesh.is_two_d() ? 1.0 : mesh.dx()),
      to_waves_(real_fourier(stations_, waves_)),
      inverse_mass_(mesh.nodes()),
      krylov_(
          static_cast<std::size_t>(dim) * static_cast<std::size_t>(mesh.nodes()),
          {.name = "added_mass", .most_iterations = 100, .restart = 50, .is_of_one_rank = true},
          [this](const double* in, double* out) { multiply(in, out); },
          [this](const double* in, double* out) { precondition(in, out); }) {
  for (int m = 0; m < stations_; ++m)
    for (int j = 0; j <= segments_; ++j)
      inverse_mass_[mesh.index(m, j)] = j == 0 ? 0.0 : 1 / (mu * mesh.area(m, j));
  const Eigen::MatrixXd compliance = flat_compliance(mesh, mu);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(segments_, segments_);
  for (int waves = 0; 2 * waves <= stations_; ++waves) {
    const bool is_dropped = stations_ > 1 && 2 * waves == stations_;  // from the fluid's pressure
    const double k = Span::wavenumber(waves, stations_, mesh.span());
    Eigen::MatrixXd response = Eigen::MatrixXd::Zero(segments_, segments_);
    if (!is_dropped) response = flat_jump_response(grid, k);
    preconditioner_.push_back((one + response * compliance).inverse().transpose());
    response_.push_back(response.transpose());
  }
}

// Each wave along the span times its matrix (transposed), in place.
template <int dim>
void AddedMass<dim>::multiply_waves(const std::vector<Eigen::MatrixXd>& matrices,
                                    SegmentValues& values) const {
  coefficients_.noalias() = to_waves_ * values;
  products_.resize(stations_, segments_);
  for (int k = 0; k < stations_; ++k)
    products_.row(k).noalias() =
        coefficients_.row(k) *
        matrices[static_cast<std::size_t>(waves_[static_cast<std::size_t>(k)])];
  values.noalias() = to_waves_.transpose() * products_;
}

template <int dim>
void AddedMass<dim>::find_flux(const NodeVectors<dim>& acceleration, SegmentValues& flux) const {
  flux.resize(stations_, segments_);
  for (int m = 0; m < stations_; ++m)
    for (int s = 0; s < segments_; ++s) {
      const int node = m * (segments_ + 1) + s;
      flux(m, s) =
          0.5 *
          areas_.col(m * segments_ + s).dot(acceleration.col(node) + acceleration.col(node + 1));
    }
}

template <int dim>
void AddedMass<dim>::find_response(const NodeVectors<dim>& acceleration,
                                   SegmentValues& response) const {
  find_flux(acceleration, response);
  multiply_waves(response_, response);
}

template <int dim>
void AddedMass<dim>::add_force(const SegmentValues& jump, NodeVectors<dim>& forces) const {
  for (int m = 0; m < stations_; ++m)
    for (int s = 0; s < segments_; ++s) {
      const int node = m * (segments_ + 1) + s;
      const auto half = 0.5 * share_ * jump(m, s) * areas_.col(m * segments_ + s);
      forces.col(node) += half;
      forces.col(node + 1) += half;
    }
}

template <int dim>
void AddedMass<dim>::subtract_force(const NodeVectors<dim>& acceleration,
                                    NodeVectors<dim>& forces) const {
  SegmentValues jump;
  find_response(acceleration, jump);
  jump = -jump;
  add_force(jump, forces);
}

template <int dim>
int AddedMass<dim>::solve(TangentMatrix<dim>& K, double mass_factor, NodeVectors<dim>& r) {
  tangent_ = &K;
  mass_factor_ = mass_factor;
  NodeVectors<dim> x = NodeVectors<dim>::Zero(dim, r.cols());
  const KrylovSummary solved = krylov_.solve(r.data(), x.data(), 0, solution_error);
  r = x;
  return solved.iterations;
}

template <int dim>
void AddedMass<dim>::multiply(const double* in, double* out) {
  const Eigen::Index nodes = Eigen::Index{stations_} * (segments_ + 1);
  const Eigen::Map<const NodeVectors<dim>> x(in, dim, nodes);
  vectors_ = -mass_factor_ * x;
  NodeVectors<dim> result = x;
  tangent_->multiply(result);
  subtract_force(vectors_, result);
  tangent_->clear_held(result);
  Eigen::Map<NodeVectors<dim>>(out, dim, nodes) = result;
}

template <int dim>
void AddedMass<dim>::precondition(const double* in, double* out) {
  const Eigen::Index nodes = Eigen::Index{stations_} * (segments_ + 1);
  NodeVectors<dim> r = Eigen::Map<const NodeVectors<dim>>(in, dim, nodes);
  vectors_ = r * inverse_mass_.asDiagonal();
  SegmentValues jump;
  find_response(vectors_, jump);
  multiply_waves(preconditioner_, jump);
  jump = -jump;
  add_force(jump, r);
  tangent_->clear_held(r);
  tangent_->solve_roughly(r);
  Eigen::Map<NodeVectors<dim>>(out, dim, nodes) = r;
}

template class AddedMass<2>;
template class AddedMass<3>;

}  // namespace pennon::dns
