#include "modes/global/matrix_free/propagator.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

namespace pennon::dns {
namespace {

// What z -> -z does to a lattice: the cells i and n - 1 - i change places, the corners i and n - i;
// what lives on the flag stays where it is.
enum class Lattice { cells, corners, flag };

// Numbers of all planes: planes x rows x columns, in this order, columns fastest.
struct Block {
  Lattice lattice;
  double sign;  // of a sinuous perturbation under the reflection, on the same point
  Eigen::Index planes, rows, columns;
  Eigen::Index size() const { return planes * rows * columns; }
};

template <class F>
struct FieldPart {
  Block block;
  F* field;
};

// The fields that the next step depends on.
template <class State>
auto fields_of(State& state) {
  using F = std::remove_reference_t<decltype((state.p))>;
  constexpr double odd = -1, even = 1;
  constexpr std::size_t along_z = 1;  // of the velocity's components
  const Extent& extent = state.p.extent();
  const Block cells{Lattice::cells, odd, extent.planes, extent.n_rho, extent.n_theta};
  const Block corners{Lattice::corners, odd, extent.planes, extent.n_rho + 1, extent.n_theta};
  const auto of_sign = [](Block block, double sign) {
    block.sign = sign;
    return block;
  };
  std::vector<FieldPart<F>> parts;
  for (auto* u : {&state.u, &state.u_last})
    for (std::size_t c = 0; c < u->size(); ++c)
      parts.push_back({of_sign(cells, c == along_z ? even : odd), &(*u)[c]});
  parts.push_back({cells, &state.p});
  parts.push_back({cells, &state.p_last});
  for (std::size_t step : {0UL, 1UL}) {
    parts.push_back({corners, &state.grid[step].y});
    parts.push_back({of_sign(corners, even), &state.grid[step].z});
  }
  return parts;
}

// The flag's that it depends on, each with the numbers of its stations one behind the other.
template <int dim, class State, class Visit>
void for_each_flag_part(State& state, const Visit& visit) {
  for (auto* x : {&state.flag.x, &state.flag.v, &state.flag.previous_x, &state.flag.previous_v})
    for (Eigen::Index node = 0; node < x->cols(); ++node) visit((*x)(dim - 1, node));
  for (auto* jump : {&state.jump, &state.previous_jump})
    for (Eigen::Index k = 0; k < jump->size(); ++k) visit(jump->data()[k]);
}

// function(the first of a row's numbers), in order.
template <class F, class Function>
void for_each_row(const FieldPart<F>& part, const Function& function) {
  for (Eigen::Index plane = 0; plane < part.block.planes; ++plane)
    for (Eigen::Index row = 0; row < part.block.rows; ++row)
      function(part.field->row(static_cast<int>(plane), static_cast<int>(row)));
}

void keep_sign(const Block& block, double* q) {
  const Eigen::Index n = block.columns, shift = block.lattice == Lattice::cells ? 1 : 0;
  for (Eigen::Index row = 0; row < block.planes * block.rows; ++row, q += n)
    for (Eigen::Index i = 0; 2 * i <= n; ++i) {
      const Eigen::Index mirrored = (n - shift - i) % n;
      const double mean = 0.5 * (q[i] + block.sign * q[mirrored]);
      q[i] = mean;
      q[mirrored] = block.sign * mean;
    }
}

void take_mean_of_planes_out(const Block& block, double* q) {
  Eigen::Map<Eigen::MatrixXd> by_plane(q, block.rows * block.columns, block.planes);
  const Eigen::VectorXd mean = by_plane.rowwise().mean();
  by_plane.colwise() -= mean;
}

}  // namespace

template <int dim>
Propagator<dim>::Propagator(Coupling<dim>& coupling, CoupledState<dim> base,
                            const PropagatorSettings& settings)
    : coupling_(coupling), base_(std::move(base)), settings_(settings) {
  assert(base_.previous_jump.size() > 0);
  const Eigen::VectorXd whole = packed(base_);
  size_ = whole.size();
  Eigen::VectorXd sinuous = whole;
  keep_sinuous_part(sinuous);
  add(-1, sinuous.data(), base_);
}

template <int dim>
Eigen::VectorXd Propagator<dim>::packed(const CoupledState<dim>& state) const {
  std::vector<double> numbers;
  for (const auto& part : fields_of(state.fluid))
    for_each_row(part, [&](const double* row) {
      numbers.insert(numbers.end(), row, row + part.block.columns);
    });
  for_each_flag_part<dim>(state, [&](double number) { numbers.push_back(number); });
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

template <int dim>
void Propagator<dim>::add(double factor, const double* q, CoupledState<dim>& state) const {
  for (const auto& part : fields_of(state.fluid)) {
    for_each_row(part, [&](double* row) {
      for (Eigen::Index i = 0; i < part.block.columns; ++i) row[i] += factor * *q++;
    });
    for (int plane = 0; plane < part.block.planes; ++plane)
      part.field->wrap_theta(plane, 0, static_cast<int>(part.block.rows));
  }
  for_each_flag_part<dim>(state, [&](double& number) { number += factor * *q++; });
}

template <int dim>
void Propagator<dim>::keep_sinuous_part(Eigen::VectorXd& q) const {
  double* numbers = q.data();
  std::vector<Block> blocks;
  for (const auto& part : fields_of(base_.fluid)) blocks.push_back(part.block);
  const Eigen::Index stations = base_.jump.rows();
  const Block nodes{Lattice::flag, 1, stations, 1, base_.flag.x.cols() / stations};
  const Block segments{Lattice::flag, 1, stations, 1, base_.jump.cols()};
  blocks.insert(blocks.end(), {nodes, nodes, nodes, nodes, segments, segments});
  for (const Block& block : blocks) {
    if (block.lattice != Lattice::flag) keep_sign(block, numbers);
    if constexpr (dim == 3) take_mean_of_planes_out(block, numbers);
    numbers += block.size();
  }
  assert(numbers == q.data() + q.size());
}

template <int dim>
void Propagator<dim>::propagate(const double* in, double* out, int steps) {
  const Eigen::Map<const Eigen::VectorXd> q(in, size_);
  const double scale = settings_.amplitude / q.cwiseAbs().maxCoeff();
  CoupledState<dim> state = base_;
  add(scale, in, state);
  coupling_.forget_tangent();
  for (int step = 0; step < steps; ++step) coupling_.advance(state, settings_.dt);
  Eigen::VectorXd after = packed(state);
  keep_sinuous_part(after);
  Eigen::Map<Eigen::VectorXd>(out, size_) = after / scale;
}

template <int dim>
Eigen::VectorXd Propagator<dim>::thrown_flag() const {
  CoupledState<dim> thrown = base_;
  const Eigen::Index stations = base_.jump.rows(), nodes = base_.flag.x.cols() / stations;
  for (Eigen::Index m = 0; m < stations; ++m)
    for (Eigen::Index j = 0; j < nodes; ++j) {
      const double y = static_cast<double>(j) / static_cast<double>(nodes - 1);
      const double wave = dim == 2 ? 1
                                   : std::cos(2 * std::numbers::pi * static_cast<double>(m) /
                                              static_cast<double>(stations));
      for (auto* v : {&thrown.flag.v, &thrown.flag.previous_v})
        (*v)(dim - 1, m * nodes + j) += wave * y * y;
    }
  return packed(thrown) - packed(base_);
}

template class Propagator<2>;
template class Propagator<3>;

}  // namespace pennon::dns
