/// For which streamwise wavenumbers the local theory reproduces the verdicts of a table.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/case/sweep.hpp"
#include "lsa/evaluate.hpp"
#include "lsa/outcomes.hpp"

namespace pennon::lsa {

struct Verdict {
  Outcome outcome;
  Stability stability;  ///< at the case's own k_y

  bool agrees() const { return stability.is_unstable() == outcome.is_unstable; }
};

struct Verdicts {
  std::vector<Verdict> rows;
  /// The intervals of k_y over which every row agrees; their ends are neutral points of a row, to
  /// machine precision, or the ends of the search.
  std::vector<std::pair<double, double>> reproduced;
  std::size_t most_agreeing = 0;  ///< the number of rows that agree at the best k_y of the search
};

/// `point` gives what the table does not: Re, nu_s, K_B and the case's k_y. A neutral point between
/// two neighbours of the search is found unless there are two. Throws what solve() throws.
Verdicts compare(const std::vector<Outcome>&, const Point& point, const Theory&,
                 const Sweep& search);

}  // namespace pennon::lsa
