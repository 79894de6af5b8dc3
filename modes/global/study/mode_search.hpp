/// The search for the global modes of a case.
#pragma once

#include <vector>

#include "modes/global/study/mode_kind.hpp"

namespace pennon::modes::global {

struct SortedPair {
  Eigenpair pair;
  EnergyShares shares;
  ModeKind kind = ModeKind::flag;
};

struct FoundPairs {
  std::vector<SortedPair> pairs;  ///< by falling growth rate, those of the box last
  int requested = 0;              ///< n_modes, of each target that was given
  int converged = 0;              ///< those among `pairs` that are not of the box
  int searched = 0;               ///< pairs that were computed next to each target
  int box = 0;                    ///< modes of the box that were found, listed or not
  int too_fast = 0;               ///< eigenvalues with |lambda| dt > 1, which are left out
  int checked = 0;                ///< modes that were computed once more with a larger R
};

/// The n pairs that grow most among the n next to each of several points along the axis of the
/// angular frequency, on both sides where they differ; whatever they belong to.
Spectrum leading_pairs(const CoupledOperator&, int n, const EigenSolver&);

/// The modes next to each target, each once; without a target the leading ones next to those same
/// points. n_modes counts those of flag and wake; as many of the box at most are listed behind
/// them. Where too few are found, 4 n_modes pairs are sought next to each target, and no more. An
/// eigenvalue with |lambda| dt > 1 is not a mode of the simulation and is left out. Throws
/// SolverError as KindFinder does.
FoundPairs search_modes(const CoupledProblem&, const Settings&, const EigenSolver&, KindFinder&);

}  // namespace pennon::modes::global
