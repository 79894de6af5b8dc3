/// Outcomes of experiments or simulations that a theory is compared with, read from a table.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lsa/model.hpp"

namespace pennon::lsa {

struct Outcome {
  std::string name;  ///< of the case
  double mu;
  std::optional<double> gamma;  ///< none in two dimensions
  double U;
  bool is_unstable;

  double k_x() const;
};

/// Reads the columns case, mu, gamma, U_over_V and lsa (S or U). Throws InputError (file:line).
std::vector<Outcome> read_outcomes(const std::filesystem::path& table);

/// `point` with the outcome's mu, k_x and U.
Point at(Point point, const Outcome&);

}  // namespace pennon::lsa
