/// What a global mode belongs to: the flag, its wake, or the box in which it was computed.
///
/// The wake carries disturbances to the outer boundary, and the pressure brings a little of each
/// back to the flag at once. That loop has modes of its own, whose eigenvalues are about
/// V (ln r + 2 pi i k)/R, r < 1 the share that comes back and k = 0, 1, ...: they fall with R and
/// say nothing about the flag, however small their residual is. A mode is called a box mode if it
/// moves by more than 5 % of |lambda| when R grows by half.
///
/// They crowd as R grows, so that another of them may lie where the first one was. A mode that
/// stays must therefore also move by less than a share of the distance to its next neighbour (2 %,
/// with much energy at the flag 10 %), and its growth rate by less than half of what the formula
/// above takes from it.
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "modes/global/solve/eigen_solver.hpp"
#include "modes/global/study/coupled_problem.hpp"
#include "modes/global/study/mode_shares.hpp"

namespace pennon::modes::global {

enum class ModeKind { flag, wake, box };

inline constexpr std::array mode_kinds = {ModeKind::flag, ModeKind::wake, ModeKind::box};

/// "flag", "wake", "box".
const char* name(ModeKind);

/// What the shares of the energy say by themselves: the mode of a flag moves the fluid beside it,
/// the mode of a box lives far from both. Nothing where they leave a doubt.
std::optional<ModeKind> kind_by_shares(const EnergyShares&);

/// Whether the eigenvalue, found with the radius R, is there with the larger one too: `others` are
/// those next to it with that radius, and `share_of_gap` is what it may move by of the distance
/// between the first two of them.
bool stays(std::complex<double> lambda, std::vector<std::complex<double>> others, double R,
           double larger_R, double share_of_gap);

/// Finds out kinds. Where the shares leave a doubt the eigenvalues nearby are computed once more
/// with R grown by half, the cells within R being the same.
class KindFinder {
 public:
  /// Precondition: the settings are resolved. All must outlive this.
  KindFinder(const FlagParameters&, const FlowParameters&, const Settings&, const EigenSolver&);

  /// Throws SolverError where nothing can be computed with the larger R.
  ModeKind kind_of(std::complex<double> lambda, const EnergyShares&);

  /// Eigenvalues that were computed with the larger R.
  int checked() const { return checked_; }

 private:
  // All eigenvalues that are no farther from the centre than the last of them.
  struct Disk {
    std::complex<double> centre;
    std::vector<std::complex<double>> eigenvalues;

    // Those that are certainly the nearest.
    std::vector<std::complex<double>> nearest_to(std::complex<double> lambda) const;
  };

  bool stays_in_larger_box(std::complex<double> lambda, double share_of_gap);

  const FlagParameters& flag_;
  const FlowParameters& flow_;
  const Settings& settings_;
  const EigenSolver& solve_;
  std::optional<CoupledProblem> larger_;
  std::vector<Disk> disks_;  // of the larger box
  int checked_ = 0;
};

/// The settings with R grown by half, or as much more as whole cells need that continue those of
/// the grid: within R the cells are the same.
Settings with_larger_box(Settings, const OGrid&);

}  // namespace pennon::modes::global
