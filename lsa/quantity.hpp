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
  std::string symbol;   ///< how formulas write it, as plain text: "ω_r^+"
  bool is_signed;       ///< both signs occur, and zero separates two regions
  double (*at)(const Point&, const Theory&);
  Lanes StabilityBatch::*lanes;  ///< null for a quantity that only curves can show
};

const std::vector<std::string>& curve_quantities();
const std::vector<std::string>& map_quantities();
/// `name` must be one of curve_quantities().
const Quantity& quantity(const std::string& name);

}  // namespace pennon::lsa
