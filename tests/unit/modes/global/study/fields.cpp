// The fields of a global mode and its wavemaker.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/grid_response.hpp"
#include "modes/global/solve/sensitivity.hpp"
#include "modes/global/study/mode_fields.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;

// A mode with its adjoint, and what it is a mode of.
struct ModeOfGrid {
  dns::OGrid grid;
  double k_x;
  BaseFlow base;
  FlagOperator flag;
  CoupledOperator coupled;
  Eigenpair pair;

  ModeOfGrid(const dns::OGridSettings& settings, double wavenumber, bool with_adjoint)
      : grid(settings),
        k_x(wavenumber),
        base(base_flow(grid, {.Re = 100, .dt_of_pressure = 0.01}, k_x != 0 ? 3 : 2)),
        flag(flag_operator(dns::coupled_chord(grid), dns::Edge::pinned, material, base.forces, k_x,
                           40)),
        coupled(coupled_operator(grid, base, flag, k_x)),
        pair(eigenpair_near(coupled.assembled(), {0, 2.5})) {
    if (with_adjoint) {
      const SparsePencil adjoint = coupled.assembled().adjoint();
      set_adjoint(coupled, eigenpair_near(adjoint, std::conj(pair.lambda) + 1e-5).q, pair);
    }
    normalise(coupled, pair);
  }

  ModeFields fields() const { return fields_of_modes(grid, base, coupled, {pair}).modes.front(); }

  static constexpr dns::FlagMaterial material{.mu = 0.4, .K_B = 2e-3};
};

constexpr dns::OGridSettings small_grid = {
    .n_rho = 10, .n_theta = 24, .R = 3, .wall_spacing = 0.12};

// Of the corners to each of the flag's nodes.
std::vector<Displacement<double>> responses(const dns::OGrid& grid) {
  const int nodes = grid.n_theta() / 2 + 1;
  const MovingCorners corners(Extent{1, grid.n_rho(), grid.n_theta()});
  const Eigen::MatrixXd G = grid_response(grid, nodes);
  std::vector<Displacement<double>> of_nodes;
  of_nodes.reserve(static_cast<std::size_t>(nodes));
  for (int node = 0; node < nodes; ++node) of_nodes.push_back(corners.unpack<double>(G.col(node)));
  return of_nodes;
}

// (d . grad) v_0 of a cell, v_0 the steady flow, where d follows a node of the flag: what is
// carried along with the grid.
class CarriedFlow {
 public:
  CarriedFlow(const dns::OGrid& grid, const BaseFlow& base)
      : equations_(grid, base.parameters, base.q.components()), response_(responses(grid)) {
    PlaneFlow<double> q(base.q), R(base.q);
    equations_.set_inflow(base.is_inflow);
    equations_.evaluate(q, nullptr, R, nullptr);  // for the ghosts
    for (int f = 0; f < q.fields(); ++f) {
      along_y_.emplace_back(q.p.extent());
      along_z_.emplace_back(q.p.extent());
      dns::gradient<double>(equations_.metrics(), 0, q.field(f), nullptr,
                            {nullptr, &along_y_.back(), &along_z_.back()});
    }
  }
  double operator()(int field, int j, int i, std::size_t node) const {
    const auto f = static_cast<std::size_t>(field);
    return mean(response_[node].y, j, i) * along_y_[f].row(0, j)[i] +
           mean(response_[node].z, j, i) * along_z_[f].row(0, j)[i];
  }
  std::size_t nodes() const { return response_.size(); }

 private:
  static double mean(const Field<double>& f, int j, int i) {
    return (f.row(0, j)[i] + f.row(0, j)[i + 1] + f.row(0, j + 1)[i] + f.row(0, j + 1)[i + 1]) / 4;
  }

  PlaneEquations<double> equations_;
  std::vector<Displacement<double>> response_;
  std::vector<Field<double>> along_y_, along_z_;
};

// The steady flow carried along with the grid, as the flag is displaced by y^2.
struct CarriedVorticity {
  double moving, fixed;         // root mean squares of the vorticity, off the flag
  double largest_velocity = 0;  // at fixed points

  CarriedVorticity(int n_rho, int n_theta, double wall_spacing) {
    const dns::OGrid grid(
        {.n_rho = n_rho, .n_theta = n_theta, .R = 3, .wall_spacing = wall_spacing});
    const std::vector<double> chord = dns::coupled_chord(grid);
    const BaseFlow base = base_flow(grid, {.Re = 100, .dt_of_pressure = 0.01}, 2);
    const CoupledOperator coupled = coupled_operator(
        grid, base,
        flag_operator(chord, dns::Edge::pinned, ModeOfGrid::material, base.forces, 0, 1), 0);
    const CarriedFlow carried(grid, base);
    Eigenpair pair{0, Eigen::VectorXcd::Zero(coupled.size())};
    for (std::size_t node = 1; node < carried.nodes(); ++node) {
      const double zeta = chord[node] * chord[node];
      pair.q[coupled.zeta(static_cast<Eigen::Index>(node) - 1)] = zeta;
      coupled.flow().for_each(
          [&](int f, int j, int i, Eigen::Index k) { pair.q[k] += zeta * carried(f, j, i, node); });
    }
    const ModeFields mode = fields_of_modes(grid, base, coupled, {pair}).modes.front();
    const PlaneEquations<double> equations(grid, base.parameters, 2);
    const auto rms = [&](const Field<Complex>& omega) {
      constexpr double first_rho = 0.6, last_rho = 1.8;
      double sum = 0, area = 0;
      for (int j = 0; j < n_rho; ++j) {
        if (grid.rho_centre(j) < first_rho || grid.rho_centre(j) > last_rho) continue;
        for (int i = 0; i < n_theta; ++i) {
          const double volume = equations.metrics().volume.row(0, j)[i];
          sum += volume * std::norm(omega.row(0, j)[i]);
          area += volume;
        }
      }
      return std::sqrt(sum / area);
    };
    moving = rms(mode.moving_vorticity);
    fixed = rms(mode.fixed_vorticity);
    for (const Field<Complex>& u : mode.fixed.u)
      for (int j = 0; j < n_rho; ++j)
        for (int i = 0; i < n_theta; ++i)
          largest_velocity = std::max(largest_velocity, std::abs(u.row(0, j)[i]));
  }
};

TEST(GlobalFields, AFlowCarriedAlongWithTheGridIsNoDisturbanceAtFixedPoints) {
  const CarriedVorticity coarse(20, 48, 0.06), fine(40, 96, 0.03);
  constexpr double rounding = 1e-12;
  EXPECT_LT(fine.largest_velocity, rounding);
  constexpr double of_second_order = 0.35;  // a quarter, and what coarse grids leave
  EXPECT_LT(fine.fixed / fine.moving, of_second_order * coarse.fixed / coarse.moving);
  EXPECT_LT(fine.fixed, 0.01 * fine.moving);
}

TEST(GlobalFields, AreAntisymmetricInTheWholePlane) {
  const ModeOfGrid of(small_grid, 2, true);
  const ModeFields mode = of.fields();
  for (const PlaneFlow<Complex>* q : {&mode.moving, &mode.fixed, &mode.adjoint->p})
    for (int f = 0; f < q->fields(); ++f)
      for (int j = 0; j < of.grid.n_rho(); ++j)
        for (int i = 0; i < of.grid.n_theta() / 2; ++i) {
          const Complex above = q->field(f).row(0, j)[i],
                        below = q->field(f).row(0, j)[of.grid.n_theta() - 1 - i];
          EXPECT_LT(std::abs(above - (f == 1 ? 1.0 : -1.0) * below), 1e-9 * (1 + std::abs(above)));
        }
  double largest = 0;
  for (const Complex& value : mode.zeta) largest = std::max(largest, std::abs(value));
  EXPECT_NEAR(largest, 1, 1e-12);
}

// v' of a cell as a function of the unknowns: the row of a component.
std::vector<Eigen::VectorXcd> fixed_velocity_rows(const ModeOfGrid& of, int j, int i) {
  const CarriedFlow carried(of.grid, of.base);
  std::vector<Eigen::VectorXcd> rows;
  for (int c = 0; c < of.base.q.components(); ++c) {
    Eigen::VectorXcd& row = rows.emplace_back(Eigen::VectorXcd::Zero(of.coupled.size()));
    row[of.coupled.flow().index(c, j, i)] = 1;
    for (Eigen::Index node = 0; node < of.coupled.flag_nodes(); ++node)
      row[of.coupled.zeta(node)] = -carried(c, j, i, static_cast<std::size_t>(node + 1));
  }
  return rows;
}

// d lambda of a feedback C in an upper cell (and in its mirror image), found anew.
Complex change_by_feedback(const ModeOfGrid& of, int j, int i, const Eigen::MatrixXcd& C,
                           double volume) {
  const std::vector<Eigen::VectorXcd> rows = fixed_velocity_rows(of, j, i);
  const auto eigenvalue = [&](double strength) {
    std::vector<Eigen::Triplet<Complex>> entries;
    for (int f = 0; f < C.rows(); ++f)
      for (int g = 0; g < C.cols(); ++g)
        for (Eigen::Index k = 0; k < rows[static_cast<std::size_t>(g)].size(); ++k)
          if (const Complex value = rows[static_cast<std::size_t>(g)][k]; value != 0.0)
            entries.emplace_back(of.coupled.flow().index(f, j, i), k,
                                 strength * volume * C(f, g) * value);
    Matrix change(of.coupled.size(), of.coupled.size());
    change.setFromTriplets(entries.begin(), entries.end());
    SparsePencil changed = of.coupled.assembled();
    changed.matrix_A += change;
    return eigenpair_near(changed, of.pair.lambda).lambda;
  };
  constexpr double strength = 1e-2;
  return (eigenvalue(strength) - eigenvalue(-strength)) / (2 * strength);
}

TEST(GlobalWavemaker, BoundsWhatAFeedbackInOneCellDoesToTheEigenvalue) {
  for (const double k_x : {0.0, 2.0}) {
    const ModeOfGrid of(small_grid, k_x, true);
    const ModeFields mode = of.fields();
    const PlaneEquations<double> equations(of.grid, of.base.parameters, 2);
    const int components = of.base.q.components();
    for (const auto& [j, i] : {std::pair(0, 2), std::pair(4, 1), std::pair(3, 7)}) {
      const double volume = equations.metrics().volume.row(0, j)[i],
                   wavemaker = mode.adjoint->wavemaker.row(0, j)[i];
      Eigen::VectorXcd p(components), v(components);
      for (int c = 0; c < components; ++c) {
        p[c] = mode.adjoint->p.field(c).row(0, j)[i];
        v[c] = mode.fixed.field(c).row(0, j)[i];
      }
      constexpr double both_sides = 2;
      const Complex drag =
          change_by_feedback(of, j, i, -Eigen::MatrixXcd::Identity(components, components), volume);
      EXPECT_LT(std::abs(drag + both_sides * volume * p.dot(v)), 1e-5 * std::abs(drag));
      EXPECT_LT(std::abs(drag), both_sides * volume * wavemaker * (1 + 1e-5));
      const Complex most =
          change_by_feedback(of, j, i, p * v.adjoint() / (p.norm() * v.norm()), volume);
      EXPECT_NEAR(most.real(), both_sides * volume * wavemaker, 1e-5 * std::abs(most));
      EXPECT_NEAR(most.imag(), 0, 1e-5 * std::abs(most));
    }
  }
}

TEST(GlobalWavemaker, OfTheFlagIsTheDerivativeByAMassASpringOrADamperOnAPieceOfIt) {
  const ModeOfGrid of(small_grid, 0, true);
  const FlagFeedback feedback = flag_feedback(of.pair, of.coupled);
  const Eigen::VectorXd lengths = of.flag.mass / ModeOfGrid::material.mu;
  const FlagOf flag_of = [&](const dns::FlagMaterial& material, double) {
    return flag_operator(dns::coupled_chord(of.grid), dns::Edge::pinned, material, of.base.forces,
                         0, 40);
  };
  Complex sum = 0;
  ASSERT_EQ(feedback.mass.size(), static_cast<std::size_t>(lengths.size() + 1));
  for (Eigen::Index node = 0; node < lengths.size(); ++node)
    sum += lengths[node] * feedback.mass[static_cast<std::size_t>(node + 1)];
  const Complex by_mu = sensitivity(of.pair, of.coupled, ModeOfGrid::material, flag_of).mu;
  EXPECT_LT(std::abs(sum - by_mu), 1e-10 * std::abs(by_mu));

  constexpr Eigen::Index node = 6;
  const auto eigenvalue = [&](double stiffness, double damping) {
    SparsePencil changed = of.coupled.assembled();
    Matrix& A = changed.matrix_A;
    const Eigen::Index row = of.coupled.zeta_t(node);
    A.coeffRef(row, of.coupled.zeta(node)) -= stiffness * lengths[node];
    A.coeffRef(row, row) -= damping * lengths[node];
    return eigenpair_near(changed, of.pair.lambda).lambda;
  };
  constexpr double step = 1e-3;
  const Complex by_spring = (eigenvalue(step, 0) - eigenvalue(-step, 0)) / (2 * step),
                by_damper = (eigenvalue(0, step) - eigenvalue(0, -step)) / (2 * step);
  const auto at = static_cast<std::size_t>(node + 1);
  EXPECT_LT(std::abs(by_spring - lengths[node] * feedback.stiffness[at]),
            1e-5 * std::abs(by_spring));
  EXPECT_LT(std::abs(by_damper - lengths[node] * feedback.damping[at]), 1e-5 * std::abs(by_damper));
  EXPECT_NEAR(std::abs(by_damper), lengths[node] * feedback.wavemaker[at],
              1e-5 * std::abs(by_damper));
}

}  // namespace
}  // namespace pennon::modes::global
