/// Many points at once, as arrays: the same arithmetic as solve() of lsa/dispersion.hpp, in loops
/// that the compiler turns into vector instructions. The results are equal to the last bit.
#pragma once

#include <array>
#include <cstddef>

#include "lsa/dispersion.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa {

/// So many points that the inputs and outputs of a batch fit in the first-level cache.
inline constexpr std::size_t batch_size = 256;

using Lanes = std::array<double, batch_size>;

struct PointBatch {
  Lanes mu, Re, k_x, k_y, nu_s, K_B, U;
  Lanes c_m;  ///< read where the model's added mass is `minami`, else written

  /// Sets all lanes of every parameter to those of the point.
  void fill(const Point&);
};

struct StabilityBatch {
  Lanes c_m, P, omega_r_plus, omega_i_plus, omega_r_minus, omega_i_minus, growth, frequency, mu_cr;
};

/// Solves (4.6) for the first `size` lanes.
void solve(const Model&, PointBatch&, std::size_t size, StabilityBatch&);

}  // namespace pennon::lsa
