// Lift and moment of a plate that plunges and pitches, over frequency and Reynolds number.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/oscillating_plate.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

double degrees(Complex number) {
  return std::arg(number) * 180 / std::numbers::pi;
}

// The difference from Theodorsen falls with every fourfold Re, in plunge and pitch and at every
// frequency, in lift as in moment.
TEST(Theodorsen, IsTheLimitOfLargeReynoldsNumbers) {
  const std::vector<double> omegas = {1, 2, 4, 10};
  std::vector<std::vector<double>> rows;
  for (const bool pitches : {false, true}) {
    std::vector<Complex> last_lift, last_moment;
    for (const double Re : {1000.0, 4000.0, 16000.0}) {
      const Ratios found = measure(oscillating_plate(Re, Re < 1e4 ? 60 : 90), omegas,
                                   2 * std::numbers::pi, 0.01, pitches);
      for (std::size_t k = 0; k < omegas.size(); ++k) {
        rows.push_back({Re, pitches ? 1.0 : 0.0, omegas[k] / 2, std::abs(found.lift[k]),
                        degrees(found.lift[k]), std::abs(found.moment[k]),
                        degrees(found.moment[k])});
        if (last_lift.empty()) continue;
        EXPECT_LT(std::abs(found.lift[k] - 1.0), 0.9 * std::abs(last_lift[k] - 1.0))
            << Re << ' ' << pitches << ' ' << omegas[k];
        EXPECT_LT(std::abs(found.moment[k] - 1.0), 0.9 * std::abs(last_moment[k] - 1.0))
            << Re << ' ' << pitches << ' ' << omegas[k];
      }
      last_lift = found.lift;
      last_moment = found.moment;
    }
  }
  expect_reference("fluid_theodorsen.csv",
                   "plate of chord 1 that plunges or (pitches = 1) pitches about mid-chord, "
                   "amplitudes of 1 % of the stream, k = omega/2: amplitude and phase lead of lift "
                   "and of the moment about mid-chord over Theodorsen's; R = 8, 60 x 120 (90 x 180 "
                   "at Re = 16000), dt = 0.01; tests/validation/dns/fluid/theodorsen.cpp",
                   {"Re", "pitches", "k", "lift", "lift_phase_deg", "moment", "moment_phase_deg"},
                   rows, 1e-3);
}

}  // namespace
}  // namespace pennon::dns
