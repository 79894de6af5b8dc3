/// A displacement known at points, as a table gives it.
#pragma once

#include <filesystem>
#include <vector>

namespace pennon::modes {

struct Sample {
  double x, y, zeta;  ///< scaled by L; x = 0 in two dimensions
};

/// Reads the columns x, y, zeta of a CSV file; in two dimensions (`has_span` false) y, zeta.
/// Throws InputError with file:line for every cell that is empty or outside 0 <= y <= 1.
std::vector<Sample> read_samples(const std::filesystem::path&, bool has_span);

}  // namespace pennon::modes
