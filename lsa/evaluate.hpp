/// A point under a model: the coefficients of (4.6) and its solution.
#pragma once

#include "lsa/dispersion.hpp"
#include "lsa/minami.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa {

/// All assumptions of an analysis.
struct Theory {
  Model model;
  MinamiSettings minami;
};

/// Both throw SolverError where the added mass `minami` cannot be computed.
Coefficients coefficients(const Point&, const Theory&);
Stability solve(const Point&, const Theory&);

}  // namespace pennon::lsa
