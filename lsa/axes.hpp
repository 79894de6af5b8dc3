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

const std::string& name(Axis);
/// What it means, for files: "mass ratio rho_s h/(rho_f L)".
const std::string& meaning(Axis);
/// How it is written in formulas, as plain text: "k_x L".
const std::string& symbol(Axis);
const Range& range(Axis);

double value(const Point&, Axis);
void set(Point&, Axis, double value);
/// The lanes that the axis varies, and the value they take for one of the axis's values.
Lanes& lanes(PointBatch&, Axis);
double lane_value(Axis, double value);

}  // namespace pennon::lsa
