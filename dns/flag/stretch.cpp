#include "dns/flag/stretch.hpp"

#include <algorithm>
#include <cmath>

namespace pennon::dns {
namespace {

// Weights with which the four nodes of a cell enter twice the mean of its chordwise differences,
// and of its spanwise ones.
constexpr std::array<double, 4> chordwise_signs = {-1, 1, -1, 1};
constexpr std::array<double, 4> spanwise_signs = {-1, -1, 1, 1};

}  // namespace

// The mean slopes of a cell, at the end and as the step pairs them, and the shear.
template <int dim>
struct Stretch<dim>::Shear {
  Vector chordwise, spanwise;  // mean of start and end, or the end
  Vector chordwise_end, spanwise_end;
  double value;  // x_1.x_2, paired
};

template <int dim>
Stretch<dim>::Stretch(const FlagMesh& mesh, const StretchEnergy& energy)
    : of_(energy), span_(mesh.span()) {
  const int stations = mesh.stations();
  const int chord_nodes = mesh.chord_nodes();
  for (int i = 0; i < stations; ++i)
    for (int j = 0; j + 1 < chord_nodes; ++j)
      segments_.push_back({mesh.index(i, j), mesh.index(i, j + 1), true, false, mesh.dy(j),
                           mesh.dy(j) * mesh.span_share(i)});
  if constexpr (dim == 3) {
    const auto chordwise = [&](int i, int j) { return i * (chord_nodes - 1) + j; };
    const int first_spanwise = static_cast<int>(segments_.size());
    const int steps = mesh.is_periodic() ? stations : stations - 1;
    const auto spanwise = [&](int i, int j) { return first_spanwise + i * chord_nodes + j; };
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < chord_nodes; ++j)
        segments_.push_back({mesh.index(i, j), mesh.index((i + 1) % stations, j), false,
                             i + 1 == stations, mesh.dx(), mesh.dx() * mesh.chord_share(j)});
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j + 1 < chord_nodes; ++j) {
        const int next = (i + 1) % stations;
        cells_.push_back(
            {{mesh.index(i, j), mesh.index(i, j + 1), mesh.index(next, j), mesh.index(next, j + 1)},
             {chordwise(i, j), chordwise(next, j), spanwise(i, j), spanwise(i, j + 1)},
             mesh.dx() * mesh.dy(j)});
      }
  }
  states_.resize(segments_.size());
  tensions_.resize(segments_.size());
}

template <int dim>
double Stretch<dim>::stiffness(const Segment& s) const {
  return s.is_chordwise ? of_.stiffness : of_.stiffness * of_.spanwise;
}

template <int dim>
auto Stretch<dim>::difference(const NodeVectors<dim>& x, const Segment& s) const -> Vector {
  Vector d = x.col(s.to) - x.col(s.from);
  if (s.crosses_seam) d[0] += span_;
  return d;
}

template <int dim>
double Stretch<dim>::strain(const NodeVectors<dim>& x, const Segment& s) const {
  return (difference(x, s).norm() - s.h) / s.h;
}

template <int dim>
auto Stretch<dim>::state(const FlagStep<dim>& step, const Segment& s) const -> State {
  const Vector d_end = difference(step.end, s);
  const double length_end = d_end.norm();
  Vector d = d_end;
  double length = length_end;
  if (step.pairing == Pairing::discrete_gradient) {
    const Vector d_start = difference(step.start, s);
    d = (d_start + d_end) / 2;
    length = (d_start.norm() + length_end) / 2;
  }
  State state{d / length, d_end / length_end, (length - s.h) / s.h, length / s.h,
              0,          Vector::Zero()};
  if (of_.damping > 0) add_rate(step, s, state);
  return state;
}

template <int dim>
void Stretch<dim>::add_rate(const FlagStep<dim>& step, const Segment& s, State& state) const {
  if (step.pairing == Pairing::discrete_gradient && step.dt > 0) {
    state.strain_rate = (strain(step.end, s) - strain(step.start, s)) / step.dt;
    state.rate_by_end = state.at_end / step.dt;
  } else if (step.pairing == Pairing::end && step.velocity != nullptr) {
    const Vector relative = step.velocity->col(s.to) - step.velocity->col(s.from);
    const double along = state.at_end.dot(relative);
    state.strain_rate = along / s.h;
    state.rate_by_end = step.velocity_factor * state.at_end +
                        (relative - along * state.at_end) / (s.h * state.relative_length);
  }
}

template <int dim>
auto Stretch<dim>::mean_slope(const FlagStep<dim>& step, const Cell& cell, int first, int second,
                              bool at_end) const -> Vector {
  Vector sum = Vector::Zero();
  for (const int which : {first, second}) {
    const Segment& s =
        segments_[static_cast<std::size_t>(cell.segments[static_cast<std::size_t>(which)])];
    sum += difference(at_end ? step.end : step.start, s) / (2 * s.h);
  }
  return sum;
}

template <int dim>
auto Stretch<dim>::shear(const FlagStep<dim>& step, const Cell& cell) const -> Shear {
  const Vector a = mean_slope(step, cell, 0, 1, true);
  const Vector b = mean_slope(step, cell, 2, 3, true);
  if (step.pairing == Pairing::end) return {a, b, a, b, a.dot(b)};
  const Vector a_start = mean_slope(step, cell, 0, 1, false);
  const Vector b_start = mean_slope(step, cell, 2, 3, false);
  return {(a_start + a) / 2, (b_start + b) / 2, a, b, (a_start.dot(b_start) + a.dot(b)) / 2};
}

// Fills the states and the tensions: d(energy)/d(strain) of each segment, damping included.
template <int dim>
void Stretch<dim>::evaluate(const FlagStep<dim>& step) const {
  for (std::size_t n = 0; n < segments_.size(); ++n) {
    const Segment& s = segments_[n];
    states_[n] = state(step, s);
    tensions_[n] =
        stiffness(s) * s.area * (states_[n].strain + of_.damping * states_[n].strain_rate);
  }
  for (const Cell& cell : cells_) {
    const auto strain = [&](std::size_t k) {
      return states_[static_cast<std::size_t>(cell.segments[k])].strain;
    };
    const double coupling = of_.stiffness * of_.coupling * cell.area / 2;
    const double chordwise = (strain(0) + strain(1)) / 2;
    const double spanwise = (strain(2) + strain(3)) / 2;
    for (const std::size_t k : {0, 1})
      tensions_[static_cast<std::size_t>(cell.segments[k])] += coupling * spanwise;
    for (const std::size_t k : {2, 3})
      tensions_[static_cast<std::size_t>(cell.segments[k])] += coupling * chordwise;
  }
}

template <int dim>
auto Stretch<dim>::energy(const NodeVectors<dim>& x) const -> Energy {
  Energy energy;
  for (const Segment& s : segments_) {
    const double e = strain(x, s);
    (s.is_chordwise ? energy.two_d : energy.three_d) += stiffness(s) / 2 * s.area * e * e;
  }
  const FlagStep<dim> here{x, x};
  for (const Cell& cell : cells_) {
    const auto e = [&](std::size_t k) {
      return strain(x, segments_[static_cast<std::size_t>(cell.segments[k])]);
    };
    const double gamma = shear(here, cell).value;
    energy.three_d +=
        of_.stiffness * cell.area *
        (of_.coupling * (e(0) + e(1)) / 2 * (e(2) + e(3)) / 2 + of_.shear / 2 * gamma * gamma);
  }
  return energy;
}

template <int dim>
void Stretch<dim>::add_forces(const FlagStep<dim>& step, NodeVectors<dim>& forces) const {
  evaluate(step);
  for (std::size_t n = 0; n < segments_.size(); ++n) {
    const Vector pull = tensions_[n] / segments_[n].h * states_[n].direction;
    forces.col(segments_[n].from) += pull;
    forces.col(segments_[n].to) -= pull;
  }
  for (const Cell& cell : cells_) {
    const Shear s = shear(step, cell);
    const double stress = of_.stiffness * of_.shear * cell.area * s.value;
    const double h_1 = 2 * segments_[static_cast<std::size_t>(cell.segments[0])].h;
    const double h_2 = 2 * segments_[static_cast<std::size_t>(cell.segments[2])].h;
    for (std::size_t n = 0; n < 4; ++n)
      forces.col(cell.nodes[n]) -=
          stress * (chordwise_signs[n] / h_1 * s.spanwise + spanwise_signs[n] / h_2 * s.chordwise);
  }
}

template <int dim>
void Stretch<dim>::add_tangent(const FlagStep<dim>& step, TangentMatrix<dim>& tangent) const {
  evaluate(step);
  const double share = step.share_of_end();
  for (std::size_t n = 0; n < segments_.size(); ++n) {
    const Segment& s = segments_[n];
    const State& state = states_[n];
    const Block outer = state.direction * state.at_end.transpose();
    const double spring = stiffness(s) * s.area / (s.h * s.h);
    const double geometric = tensions_[n] / (s.h * s.h * state.relative_length);
    Block block = share * (spring * outer + geometric * (Block::Identity() - outer));
    if (of_.damping > 0)
      block += spring * of_.damping * state.direction * state.rate_by_end.transpose();
    tangent.add(s.from, s.from, block);
    tangent.add(s.to, s.to, block);
    tangent.add(s.from, s.to, -block);
    tangent.add(s.to, s.from, -block);
  }
  for (const Cell& cell : cells_) {
    // Strains of the cell's chordwise and spanwise means by the nodes: as paired, and at the end.
    std::array<Vector, 4> by_chord, by_span, by_chord_end, by_span_end;
    for (std::size_t n = 0; n < 4; ++n)
      by_chord[n] = by_span[n] = by_chord_end[n] = by_span_end[n] = Vector::Zero();
    constexpr std::array<std::array<std::size_t, 2>, 4> ends = {{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto n = static_cast<std::size_t>(cell.segments[k]);
      const Vector paired = states_[n].direction / (2 * segments_[n].h);
      const Vector at_end = states_[n].at_end / (2 * segments_[n].h);
      (k < 2 ? by_chord : by_span)[ends[k][0]] -= paired;
      (k < 2 ? by_chord : by_span)[ends[k][1]] += paired;
      (k < 2 ? by_chord_end : by_span_end)[ends[k][0]] -= at_end;
      (k < 2 ? by_chord_end : by_span_end)[ends[k][1]] += at_end;
    }
    const Shear s = shear(step, cell);
    const double h_1 = 2 * segments_[static_cast<std::size_t>(cell.segments[0])].h;
    const double h_2 = 2 * segments_[static_cast<std::size_t>(cell.segments[2])].h;
    const double poisson = share * of_.stiffness * of_.coupling * cell.area;
    const double rigidity = share * of_.stiffness * of_.shear * cell.area;
    for (std::size_t p = 0; p < 4; ++p) {
      const double a_p = chordwise_signs[p] / h_1;
      const double b_p = spanwise_signs[p] / h_2;
      const Vector by_p = a_p * s.spanwise + b_p * s.chordwise;
      for (std::size_t q = 0; q < 4; ++q) {
        const double a_q = chordwise_signs[q] / h_1;
        const double b_q = spanwise_signs[q] / h_2;
        const Vector by_q = a_q * s.spanwise_end + b_q * s.chordwise_end;
        const Block block = poisson * (by_chord[p] * by_span_end[q].transpose() +
                                       by_span[p] * by_chord_end[q].transpose()) +
                            rigidity * by_p * by_q.transpose() +
                            rigidity * s.value * (a_p * b_q + b_p * a_q) * Block::Identity();
        tangent.add(cell.nodes[p], cell.nodes[q], block);
      }
    }
  }
}

template <int dim>
double Stretch<dim>::dissipated(const NodeVectors<dim>& start, const NodeVectors<dim>& end,
                                double dt) const {
  if (of_.damping == 0) return 0;
  double sum = 0;
  for (const Segment& s : segments_) {
    const double change = strain(end, s) - strain(start, s);
    sum += stiffness(s) * of_.damping * s.area * change * change / dt;
  }
  return sum;
}

template <int dim>
Eigen::Matrix3Xd Stretch<dim>::strains(const NodeVectors<dim>& x) const {
  Eigen::Matrix3Xd strains;
  if constexpr (dim == 2) {
    strains.setZero(3, static_cast<Eigen::Index>(segments_.size()));
    for (std::size_t n = 0; n < segments_.size(); ++n)
      strains(0, static_cast<Eigen::Index>(n)) = strain(x, segments_[n]);
  } else {
    strains.resize(3, static_cast<Eigen::Index>(cells_.size()));
    for (std::size_t n = 0; n < cells_.size(); ++n) {
      const Cell& cell = cells_[n];
      const auto e = [&](std::size_t k) {
        return strain(x, segments_[static_cast<std::size_t>(cell.segments[k])]);
      };
      strains.col(static_cast<Eigen::Index>(n)) << (e(0) + e(1)) / 2, (e(2) + e(3)) / 2,
          shear({x, x}, cell).value;
    }
  }
  return strains;
}

template <int dim>
std::pair<double, double> Stretch<dim>::strain_range(const NodeVectors<dim>& x) const {
  std::pair<double, double> range = {strain(x, segments_.front()), strain(x, segments_.front())};
  for (const Segment& s : segments_) {
    const double e = strain(x, s);
    range = {std::min(range.first, e), std::max(range.second, e)};
  }
  return range;
}

template class Stretch<2>;
template class Stretch<3>;

}  // namespace pennon::dns
