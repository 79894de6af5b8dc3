/// The basis of a map: its first shapes, and those that are added where the modes in the basis are
/// wrong.
#pragma once

#include <vector>

#include "modes/global/map/map_model.hpp"

namespace pennon::modes::global {

/// The basis with which a map begins, from the fits along the axis of the angular frequency: shapes
/// and adjoints of the modes of a few flags that are nearly neutral at frequencies spread over each
/// window. Where the settings ask for improvement, the mass ratios in the basis are then compared
/// with those of the whole flag at the frequencies half-way between, and the shapes that turn out
/// to be missing are added.
FlagBasis first_basis(const MapTask&, const std::vector<CheckedFit>& fits);

/// A mode of the basis that is not one of the whole flag, with its error of lambda.
struct WrongMode {
  double error;
  std::size_t window, column;
  double mu;
  FlagMode rough;  ///< with its shape of the whole flag
};

struct BasisCheck {
  double error = 0;         ///< of lambda, the largest at the points that were checked
  std::size_t checked = 0;  ///< points
  std::vector<WrongMode> wrong;
};

/// Compares lambda in the basis with lambda of the whole flag, with the same fit: at points of the
/// map spread over these columns, and at all their neutral modes.
BasisCheck check_basis(const MapModel&, const std::vector<std::size_t>& columns);

/// Adds the mode of the whole flag and its adjoint for some of the wrong modes, those with the
/// largest and the smallest error among them.
void add_shapes_of(std::vector<WrongMode> wrong, MapModel&);

}  // namespace pennon::modes::global
