/// Published outcomes as points over two axes, to be compared with a curve or a map over them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"
#include "lsa/axes.hpp"
#include "lsa/outcomes.hpp"

namespace pennon::lsa {

/// The outcome's coordinate along an axis; none where the table does not say it.
std::optional<double> coordinate(const Outcome&, Axis);

/// Writes the outcomes (common/io/outcome_points.hpp) that have a coordinate along both axes; one
/// with a cross-flow only where the model has it (`cross_flow`). `y` is the name of an axis, or
/// "mu_cr", which is compared with mu. Writes nothing where `y` is neither.
void write_outcome_points(hdf5::Writer&, const std::vector<Outcome>&, Axis x, const std::string& y,
                          bool cross_flow);

}  // namespace pennon::lsa
