/// The parameters of a point that a curve or map may vary.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "common/case/range.hpp"
#include "lsa/batch.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa {

/// `gamma` stands for k_x = 2 pi/gamma.
enum class Axis { mu, Re, k_x, k_y, nu_s, gamma, K_B, U };
inline constexpr std::size_t axis_count = 8;

/// The key of a case: "k_x".
const std::string& name(Axis);
/// The meaning in words, as files state it: "mass ratio rho_s h/(rho_f L)".
const std::string& meaning(Axis);
/// How formulas write it, as plain text: "k_x L".
const std::string& symbol(Axis);
/// The values that a case may give.
const Range& range(Axis);

double value(const Point&, Axis);
void set(Point&, Axis, double value);
/// The lanes of a batch that the axis varies.
Lanes& lanes(PointBatch&, Axis);
/// The number that these lanes hold where the axis has this value: 2 pi/gamma for gamma, else the
/// value itself.
double lane_value(Axis, double value);

}  // namespace pennon::lsa
