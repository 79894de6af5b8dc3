/// A point under a model: its coefficients and what (4.6) says of it.
#pragma once

#include "lsa/dispersion.hpp"
#include "lsa/minami.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa {

/// The assumptions of an analysis, whole.
struct Theory {
  Model model;
  MinamiSettings minami;
};

/// Both throw SolverError where the added mass `minami` cannot be computed.
Coefficients coefficients(const Point&, const Theory&);
Stability solve(const Point&, const Theory&);

}  // namespace pennon::lsa
