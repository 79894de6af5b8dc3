/// The numbers that a curve can show and a map can keep, by name.
#pragma once

#include <string>
#include <vector>

#include "lsa/batch.hpp"
#include "lsa/evaluate.hpp"

namespace pennon::lsa {

struct Quantity {
  std::string name;
  std::string meaning;  ///< with its equation and unit
  std::string symbol;   ///< how it is written in formulas, as plain text: "ω_r^+"
  bool is_signed;       ///< zero is a border worth showing
  double (*at)(const Point&, const Theory&);
  Lanes StabilityBatch::*lanes;  ///< null: only along curves
};

const std::vector<std::string>& curve_quantities();
const std::vector<std::string>& map_quantities();
/// `name` must be one of curve_quantities().
const Quantity& quantity(const std::string& name);

}  // namespace pennon::lsa
