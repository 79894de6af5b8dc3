#include "modes/global/matrix_free/propagator.hpp"

#include <cassert>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include "dns/coupling/visit_state.hpp"

namespace pennon::dns {
namespace {

// What z -> -z does to a lattice: the cells i and n - 1 - i change places, the corners i and n - i;
// what lives on the flag stays where it is.
enum class Lattice { cells, corners, flag };

// Numbers of all planes: planes x rows x columns, in this order, columns fastest; in the state a
// row's numbers stand `stride` apart.
struct Block {
  Lattice lattice;
  double sign;  // of a sinuous perturbation under the reflection, on the same point
  Eigen::Index planes, rows, columns;
  Eigen::Index stride = 1;
  Eigen::Index size() const { return planes * rows * columns; }
};

constexpr double odd = -1, even = 1;

// Goes through what the next step of a state depends on, up to the solvers' tolerance:
// use(block, row_at, close) with row_at(plane, row) the first of a row's numbers, and close() to be
// called when they have changed.
template <int dim, class Use>
class Parts {
 public:
  Parts(Eigen::Index stations, const Use& use) : stations_(stations), use_(use) {}

  template <class State>
  requires(IsCoupledState<State> || IsFlagState<State> ||
           std::is_same_v<std::remove_const_t<State>, FluidState>) void
  operator()(const MemberInfo&, State& inner) const {
    visit(inner, *this);
  }
  template <class F>
  requires std::is_same_v<std::remove_const_t<F>, std::vector<Field<double>>>
  void operator()(const MemberInfo& info, F& velocity) const {
    if (info.kind == MemberKind::guess) return;
    for (std::size_t c = 0; c < velocity.size(); ++c)
      part(Lattice::cells, c == along_z ? even : odd, velocity[c]);
  }
  template <class F>
  requires std::is_same_v<std::remove_const_t<F>, Field<double>>
  void operator()(const MemberInfo&, F& pressure) const { part(Lattice::cells, odd, pressure); }
  template <class F>
  requires std::is_same_v<std::remove_const_t<F>, std::vector<Displacement<double>>>
  void operator()(const MemberInfo&, F& grids) const {
    for (std::size_t k = 0; k + 1 < grids.size(); ++k) {
      part(Lattice::corners, odd, grids[k].y);
      part(Lattice::corners, even, grids[k].z);
    }
  }
  // Of the nodes their motion along z.
  void operator()(const MemberInfo&, NodeVectors<dim>& nodes) const { part_of_nodes(nodes); }
  void operator()(const MemberInfo&, const NodeVectors<dim>& nodes) const { part_of_nodes(nodes); }
  void operator()(const MemberInfo&, SegmentValues& jump) const {
    of_stations(jump.data(), jump.size(), 1);
  }
  void operator()(const MemberInfo&, const SegmentValues& jump) const {
    of_stations(jump.data(), jump.size(), 1);
  }
  void operator()(const MemberInfo&, const double&) const {}
  void operator()(const MemberInfo&, const std::vector<bool>&) const {}

 private:
  template <class F>
  void part(Lattice lattice, double sign, F& f) const {
    const Extent& extent = f.extent();
    const int rows = extent.n_rho + (lattice == Lattice::corners ? 1 : 0);
    const Block block{lattice, sign, extent.planes, rows, extent.n_theta};
    use_(
        block, [&](int plane, int row) { return f.row(plane, row); },
        [&] {
          if constexpr (!std::is_const_v<F>)
            for (int plane = 0; plane < extent.planes; ++plane) f.wrap_theta(plane, 0, rows);
        });
  }
  template <class Nodes>
  void part_of_nodes(Nodes& nodes) const {
    of_stations(nodes.data() + (dim - 1), nodes.cols(), dim);
  }
  template <class Number>
  void of_stations(Number* first, Eigen::Index count, Eigen::Index stride) const {
    const Block block{Lattice::flag, even, stations_, 1, count / stations_, stride};
    use_(
        block, [&](int station, int) { return first + station * block.columns * stride; }, [] {});
  }

  Eigen::Index stations_;
  const Use& use_;
};

template <int dim, class State, class Use>
void for_each_part(State& state, const Use& use) {
  visit(state, Parts<dim, Use>(state.reduced_jump.rows(), use));
}

// use(number) for each number of a part, in order.
template <class RowAt, class Use>
void for_each_number(const Block& block, const RowAt& row_at, const Use& use) {
  for (int plane = 0; plane < block.planes; ++plane)
    for (int row = 0; row < block.rows; ++row) {
      auto* numbers = row_at(plane, row);
      for (Eigen::Index i = 0; i < block.columns; ++i) use(numbers[i * block.stride]);
    }
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
  assert(base_.previous_reduced_jump.size() > 0);
  const Eigen::VectorXd whole = packed(base_);
  size_ = whole.size();
  Eigen::VectorXd sinuous = whole;
  keep_sinuous_part(sinuous);
  add(-1, sinuous.data(), base_);
}

template <int dim>
Eigen::VectorXd Propagator<dim>::packed(const CoupledState<dim>& state) const {
  std::vector<double> numbers;
  for_each_part<dim>(state, [&](const Block& block, const auto& row_at, const auto&) {
    for_each_number(block, row_at, [&](const double& number) { numbers.push_back(number); });
  });
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

template <int dim>
void Propagator<dim>::add(double factor, const double* q, CoupledState<dim>& state) const {
  for_each_part<dim>(state, [&](const Block& block, const auto& row_at, const auto& close) {
    for_each_number(block, row_at, [&](double& number) { number += factor * *q++; });
    close();
  });
}

template <int dim>
void Propagator<dim>::keep_sinuous_part(Eigen::VectorXd& q) const {
  double* numbers = q.data();
  for_each_part<dim>(base_, [&](const Block& block, const auto&, const auto&) {
    if (block.lattice != Lattice::flag) keep_sign(block, numbers);
    if constexpr (dim == 3) take_mean_of_planes_out(block, numbers);
    numbers += block.size();
  });
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
  const Eigen::Index stations = base_.reduced_jump.rows(), nodes = base_.flag.x.cols() / stations;
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
