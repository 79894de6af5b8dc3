#include "dns/flag/bending_form.hpp"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace pennon::dns {
namespace {

const Eigen::Vector3d along_span = Eigen::Vector3d::UnitX();
const Eigen::Vector3d along_chord = Eigen::Vector3d::UnitY();

// The second derivative from three nodes with the spacings before and after the middle one.
LinearVector second_derivative(int before, int middle, int after, double h_before, double h_after) {
  const double mean = (h_before + h_after) / 2;
  return {{{before, 1 / (mean * h_before)},
           {middle, -(1 / h_before + 1 / h_after) / mean},
           {after, 1 / (mean * h_after)}},
          Eigen::Vector3d::Zero()};
}

// The same at an edge whose slope is held: 2/h ((x_in - x_edge)/h - slope), `slope` pointing
// inwards.
LinearVector second_derivative_at_clamp(int edge, int inside, double h,
                                        const Eigen::Vector3d& slope) {
  return {{{edge, -2 / (h * h)}, {inside, 2 / (h * h)}}, -2 / h * slope};
}

std::optional<LinearVector> chordwise_curvature(const FlagMesh& mesh, int i, int j) {
  const int last = mesh.chord_nodes() - 1;
  if (j > 0 && j < last)
    return second_derivative(mesh.index(i, j - 1), mesh.index(i, j), mesh.index(i, j + 1),
                             mesh.dy(j - 1), mesh.dy(j));
  if (j == 0 && mesh.edges().leading == Edge::clamped)
    return second_derivative_at_clamp(mesh.index(i, 0), mesh.index(i, 1), mesh.dy(0), along_chord);
  if (j == last && mesh.edges().trailing == Edge::clamped)
    return second_derivative_at_clamp(mesh.index(i, last), mesh.index(i, last - 1),
                                      mesh.dy(last - 1), -along_chord);
  return std::nullopt;
}

std::optional<LinearVector> spanwise_curvature(const FlagMesh& mesh, int i, int j) {
  const int stations = mesh.stations();
  const double h = mesh.dx();
  if (mesh.is_periodic()) {
    LinearVector curvature =
        second_derivative(mesh.index((i + stations - 1) % stations, j), mesh.index(i, j),
                          mesh.index((i + 1) % stations, j), h, h);
    if (i == 0) curvature.constant -= mesh.span() / (h * h) * along_span;
    if (i == stations - 1) curvature.constant += mesh.span() / (h * h) * along_span;
    return curvature;
  }
  if (i > 0 && i < stations - 1)
    return second_derivative(mesh.index(i - 1, j), mesh.index(i, j), mesh.index(i + 1, j), h, h);
  if (i == 0 && mesh.edges().left == Edge::clamped)
    return second_derivative_at_clamp(mesh.index(0, j), mesh.index(1, j), h, along_span);
  if (i == stations - 1 && mesh.edges().right == Edge::clamped)
    return second_derivative_at_clamp(mesh.index(i, j), mesh.index(i - 1, j), h, -along_span);
  return std::nullopt;
}

LinearVector twist(const FlagMesh& mesh, int i, int j) {
  const int next = (i + 1) % mesh.stations();
  const double w = 1 / (mesh.dx() * mesh.dy(j));
  return {{{mesh.index(i, j), w},
           {mesh.index(i, j + 1), -w},
           {mesh.index(next, j), -w},
           {mesh.index(next, j + 1), w}},
          Eigen::Vector3d::Zero()};  // the period drops out of the difference along the chord
}

class Assembly {
 public:
  explicit Assembly(int nodes) : nodes_(nodes) { form_.load.setZero(3, nodes); }

  // Adds weight a.b to the energy.
  void add(double weight, const LinearVector& a, const LinearVector& b) {
    for (const auto& [p, w_p] : a.terms)
      for (const auto& [q, w_q] : b.terms) {
        entries_.emplace_back(p, q, weight * w_p * w_q);
        entries_.emplace_back(q, p, weight * w_p * w_q);
      }
    for (const auto& [p, w_p] : a.terms) form_.load.col(p) += weight * w_p * b.constant;
    for (const auto& [q, w_q] : b.terms) form_.load.col(q) += weight * w_q * a.constant;
    form_.products.push_back({weight, a, b});
  }

  BendingForm finished() {
    form_.stiffness.resize(nodes_, nodes_);
    form_.stiffness.setFromTriplets(entries_.begin(), entries_.end());
    return std::move(form_);
  }

 private:
  int nodes_;
  BendingForm form_;
  std::vector<Eigen::Triplet<double>> entries_;
};

void add_node(Assembly& assembly, const FlagMesh& mesh, int i, int j, const BendingEnergy& of) {
  const double half = of.stiffness / 2 * mesh.area(i, j);
  const auto along = chordwise_curvature(mesh, i, j);
  if (mesh.is_two_d()) {
    if (along) assembly.add(half, *along, *along);
    return;
  }
  const auto across = spanwise_curvature(mesh, i, j);
  // Where one curvature is free, it takes the value that makes the energy least: of the other's
  // stiffness that leaves less, in an isotropic plate 1 - nu_s^2.
  const double bound = of.coupling * of.coupling;
  if (along) assembly.add(half * (across ? 1 : 1 - bound / of.spanwise), *along, *along);
  if (across) assembly.add(half * (along ? of.spanwise : of.spanwise - bound), *across, *across);
  if (along && across) assembly.add(half * 2 * of.coupling, *along, *across);
}

Eigen::Vector3d value(const LinearVector& vector, const Eigen::Matrix3Xd& x) {
  Eigen::Vector3d sum = vector.constant;
  for (const auto& [node, weight] : vector.terms) sum += weight * x.col(node);
  return sum;
}

}  // namespace

double BendingForm::energy(const Eigen::Matrix3Xd& x) const {
  double sum = 0;
  for (const Product& p : products) sum += p.weight * value(p.a, x).dot(value(p.b, x));
  return sum;
}

BendingForm bending_form(const FlagMesh& mesh, const BendingEnergy& of) {
  Assembly assembly(mesh.nodes());
  if (of.stiffness == 0) return assembly.finished();
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j) add_node(assembly, mesh, i, j, of);
  if (mesh.is_two_d()) return assembly.finished();
  const int cells_along_span = mesh.is_periodic() ? mesh.stations() : mesh.stations() - 1;
  for (int i = 0; i < cells_along_span; ++i)
    for (int j = 0; j + 1 < mesh.chord_nodes(); ++j) {
      const LinearVector x_12 = twist(mesh, i, j);
      assembly.add(of.stiffness / 2 * mesh.dx() * mesh.dy(j) * 2 * of.twist, x_12, x_12);
    }
  return assembly.finished();
}

}  // namespace pennon::dns
