/// The roots of (4.6), P, mu_cr and c_m in double precision against 50 digits, over the whole range
/// of parameters, for each added mass and with everything switched on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "lsa/evaluate.hpp"
#include "tests/support/lsa_oracle.hpp"

namespace pennon::lsa {
namespace {

using oracle::Real;

constexpr double ulp = std::numeric_limits<double>::epsilon();
// What the roundings of the formulas add up to, in units in the last place of the operands.
constexpr double allowed_ulps = 10;
// "Away from the double root" (and from the root at zero): D and s keep at least a quarter of the
// terms they are the difference of.
constexpr double away = 0.25;

std::size_t sample_count() {
  const char* asked = std::getenv("PENNON_LSA_SAMPLES");
  return asked != nullptr ? std::strtoull(asked, nullptr, 10) : 250'000;  // of each of four models
}

struct Worst {
  double c_m = 0, P = 0, mu_cr = 0, omega = 0;  // errors over the bounds for one ulp
  double omega_away_from_double_root = 0;  // relative error in ulps, where D and s do not cancel
  std::size_t unstable = 0, wrong_signs = 0, not_finite = 0;
};

double as_double(const Real& r) {
  return static_cast<double>(r);
}

// The error of a root over what one ulp in each operand makes of it.
double root_error(const oracle::Exact& e, const oracle::Conditioning& bound, int sign, double re,
                  double im) {
  const Real exact_re = e.omega_r(sign);
  const Real exact_im = e.omega_i(sign);
  const Real error = sqrt((Real(re) - exact_re) * (Real(re) - exact_re) +
                          (Real(im) - exact_im) * (Real(im) - exact_im));
  const Real size = sqrt(exact_re * exact_re + exact_im * exact_im);
  // A small real root is s/q: it inherits the relative error of s and of q.
  const double total = as_double(e.total_mass);
  double allowed = ulp * as_double(size) + (bound.drift + bound.root_of_D) / total;
  const bool is_small = e.D > 0 && (e.drift >= 0) == (sign < 0);
  if (is_small) {
    const double q = std::abs(as_double(e.drift)) + as_double(e.root_of_D);
    const double through_q =
        ulp * as_double(size) + (bound.s + as_double(size) * (bound.drift + bound.root_of_D)) / q;
    allowed = std::min(allowed, through_q);
  }
  return as_double(error) / allowed;
}

Worst worst_over(const Model& model, std::uint64_t seed) {
  oracle::Sampler sampler(seed);
  const Theory theory{model, {}};
  Worst worst;
  for (std::size_t i = 0; i < sample_count(); ++i) {
    const oracle::Sample sample = sampler();
    const oracle::Exact e = oracle::solve(sample, model);
    const oracle::Conditioning bound = oracle::conditioning(sample, model, e, ulp);
    const Stability found = solve(sample.point, theory);

    worst.c_m = std::max(worst.c_m, as_double(abs(found.c_m / e.c_m - 1)) / ulp);
    const double D_size = std::abs(as_double(e.D));
    const double drift = std::abs(as_double(e.drift));
    const double P_bound =
        std::abs(as_double(e.P)) * (ulp + 2 * bound.drift / drift) + bound.D / (drift * drift);
    worst.P = std::max(worst.P, as_double(abs(found.P - e.P)) / P_bound);
    if (found.is_unstable() != (e.D < 0) && D_size > allowed_ulps * bound.D) ++worst.wrong_signs;
    worst.unstable += e.D < 0 ? 1 : 0;

    const double s_size = std::abs(as_double(e.s));
    const bool s_is_certain = s_size > allowed_ulps * bound.s;
    if (s_is_certain) {
      if (std::isnan(found.mu_cr) == e.mu_cr.has_value()) ++worst.wrong_signs;
      if (e.mu_cr && !std::isnan(found.mu_cr))
        worst.mu_cr = std::max(
            worst.mu_cr, as_double(abs(found.mu_cr / *e.mu_cr - 1)) / (ulp + bound.s / s_size));
    }
    for (const int sign : {1, -1}) {
      const double re = sign > 0 ? found.omega_r_plus : found.omega_r_minus;
      const double im = sign > 0 ? found.omega_i_plus : found.omega_i_minus;
      if (!std::isfinite(re) || !std::isfinite(im)) ++worst.not_finite;
      worst.omega = std::max(worst.omega, root_error(e, bound, sign, re, im));
      if (D_size < away * bound.D / ulp || s_size < away * bound.s / ulp) continue;
      const Real size = sqrt(e.omega_r(sign) * e.omega_r(sign) + e.omega_i(sign) * e.omega_i(sign));
      const Real error = sqrt((re - e.omega_r(sign)) * (re - e.omega_r(sign)) +
                              (im - e.omega_i(sign)) * (im - e.omega_i(sign)));
      worst.omega_away_from_double_root =
          std::max(worst.omega_away_from_double_root, as_double(error / size) / ulp);
    }
    if (!std::isfinite(found.P) || !std::isfinite(found.c_m)) ++worst.not_finite;
  }
  std::printf(
      "worst in ulps: c_m %.2f; over conditioning: P %.2f, mu_cr %.2f, omega %.2f; omega away "
      "from the double root %.2f; %zu of %zu unstable\n",
      worst.c_m, worst.P, worst.mu_cr, worst.omega, worst.omega_away_from_double_root,
      worst.unstable, sample_count());
  return worst;
}

void expect_accurate(const Worst& worst) {
  EXPECT_LE(worst.c_m, allowed_ulps);
  EXPECT_LE(worst.P, allowed_ulps);
  EXPECT_LE(worst.mu_cr, allowed_ulps);
  EXPECT_LE(worst.omega, allowed_ulps);
  EXPECT_LE(worst.omega_away_from_double_root, allowed_ulps);
  EXPECT_EQ(worst.wrong_signs, 0U);
  EXPECT_EQ(worst.not_finite, 0U);
  EXPECT_GT(worst.unstable, sample_count() / 20) << "the samples must reach the unstable side";
}

Model with(AddedMass added_mass) {
  Model model;
  model.added_mass = added_mass;
  return model;
}

TEST(LocalStabilityAccuracy, HoldsWithTheAddedMassOfWu) {
  expect_accurate(worst_over(with(AddedMass::wu), 1));
}

TEST(LocalStabilityAccuracy, HoldsWithTheAddedMassOfLamb) {
  expect_accurate(worst_over(with(AddedMass::lamb), 2));
}

TEST(LocalStabilityAccuracy, HoldsWithTheTwoDimensionalAddedMass) {
  expect_accurate(worst_over(with(AddedMass::two_d), 3));
}

TEST(LocalStabilityAccuracy, HoldsWithBendingAndCrossFlow) {
  Model model = with(AddedMass::lamb);
  model.bending = true;
  model.cross_flow = true;
  expect_accurate(worst_over(model, 4));
}

}  // namespace
}  // namespace pennon::lsa
