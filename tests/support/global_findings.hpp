/// Findings of the global modes as no computation makes them: each member has a value of its own.
#pragma once

#include <limits>

#include "modes/global/study/wire.hpp"

namespace pennon::test {

inline modes::global::Findings global_findings() {
  using namespace modes::global;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  FoundModes spectrum;
  spectrum.base_flow.drag_coefficient = 0.1;
  spectrum.base_flow.residual = 1.0 / 3;
  spectrum.base_flow.tension = {0.05, 0.02, 0};
  spectrum.chord = {0, 0.5, 1};
  spectrum.unknowns = 12345678901;
  spectrum.requested = 3;
  spectrum.converged = 1;
  spectrum.searched = 12;
  spectrum.box = 7;
  spectrum.too_fast = 3;
  spectrum.checked = 4;
  spectrum.biorthogonality_defect = 1e-11;
  spectrum.base_seconds = 1.5;
  spectrum.operator_seconds = 2.5;
  spectrum.eigen_seconds = 3.5;
  spectrum.modes.push_back(
      {{0.4, 2.6}, 1e-12, {0, {0.3, -0.1}, 1}, 2e-12, Sensitivity{{1, 2}, {3, 4}, {5, 6}, {7, 8}}});
  spectrum.modes.push_back({{-0.2, -5.1}, 3e-12, {0, {0, 1}, {-0.5, 0.25}}, 0, std::nullopt});
  spectrum.modes[0].shares = {.flag = 0.1, .near = 0.5, .wake = 0.3, .outer = 0.1};
  spectrum.modes[1].shares = {.flag = 0.01, .near = 0.04, .wake = 0.15, .outer = 0.8};
  spectrum.modes[1].kind = ModeKind::box;

  NeutralMode low{.omega = 2.7, .mu = 0.11, .by_mu = {0.9, -0.3}, .zeta = {}, .evaluations = 4},
      high{.omega = -8.1, .mu = 0.42, .by_mu = {-0.7, 0.2}, .zeta = {}, .evaluations = 6};
  low.zeta = Eigen::VectorXcd{{{0.6, 0}, {0, 0.8}}};
  high.zeta = Eigen::VectorXcd{{{0, -1}, {0, 0}}};
  NeutralCurve neutral{.parameter = CurveParameter::K_B, .points = {}, .missing = {}};
  neutral.points.push_back({.value = 1e-4,
                            .modes = {{0, low, 1e-9}, {1, high, 2e-9}},
                            .fit_error = 3e-6,
                            .evaluations = 10,
                            .seconds = 0.25,
                            .largest_growth = -1e-8,
                            .distance = 2e-8});
  neutral.points.push_back(
      {.value = 2e-4, .modes = {{1, high, 4e-9}}, .evaluations = 5, .seconds = 0.5});
  neutral.missing.push_back({3e-4, "no neutral mode \"there\""});

  const GrowthMap map{.parameter = CurveParameter::nu_s,
                      .x = {0, 0.3},
                      .mu = {0.1, 0.2, 0.4},
                      .growth = {{-0.5, nan}, {0.1, 0.2}, {0.3, 0.4}},
                      .omega = {{2, nan}, {3, 4}, {5, 6}},
                      .neutral = {{0.15, 0.9}, {}},
                      .basis_size = 17,
                      .fit_error = 1e-7,
                      .basis_error = 2e-7,
                      .lambda_error = 3e-7,
                      .checked_basis = 4,
                      .checked = 5,
                      .samples = 60,
                      .samples_off_axis = 7,
                      .sample_seconds = 8.5,
                      .map_seconds = 9.5};
  return {spectrum, neutral, map};
}

}  // namespace pennon::test
