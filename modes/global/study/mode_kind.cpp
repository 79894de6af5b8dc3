#include "modes/global/study/mode_kind.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double least_growth_of_R = 1.5;
// Of a mode that stays, of |lambda|; and of the distance to its neighbour, of which a mode with
// much energy at the flag may move by more: no mode of the box that crowds there is like it.
constexpr double greatest_move = 0.05, move_of_gap = 0.02, move_of_gap_beside_flag = 0.1;

// What the modes of flags and boxes have in the cases that were tried
// (docs/theory/global-modes.md): flags 0.13 and more beside them and at most 0.04 outside; boxes at
// most 0.03 and at least 0.5.
constexpr double least_beside_flag = 0.1, most_outside_of_flag = 0.25;
constexpr double most_beside_box = 0.05, least_outside_of_box = 0.5;

double beside(const EnergyShares& share) {
  return share.flag + share.near;
}

}  // namespace

const char* name(ModeKind kind) {
  constexpr std::array names = {"flag", "wake", "box"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<ModeKind> kind_by_shares(const EnergyShares& share) {
  if (beside(share) >= least_beside_flag && share.outer <= most_outside_of_flag)
    return ModeKind::flag;
  if (beside(share) <= most_beside_box && share.outer >= least_outside_of_box) return ModeKind::box;
  return std::nullopt;
}

bool stays(Complex lambda, std::vector<Complex> others, double R, double larger_R,
           double share_of_gap) {
  const auto distance = [&](const Complex& other) { return std::abs(other - lambda); };
  std::ranges::sort(others, {}, distance);
  if (others.empty()) return false;
  const double least = 1 / R;  // of |lambda| among the modes of a box
  const double move = distance(others.front());
  if (move > greatest_move * std::max(std::abs(lambda), least)) return false;
  if (others.size() > 1 && move > share_of_gap * std::abs(others[1] - others[0])) return false;
  const double growth = lambda.real();
  const double half_of_fall = std::abs(growth) * (1 - R / larger_R) / 2;
  return growth > -least || std::abs(others.front().real() - growth) <= half_of_fall;
}

Settings with_larger_box(Settings settings, const OGrid& grid) {
  const double wanted = std::asinh(2 * least_growth_of_R * *settings.R);
  double reached = grid.rho(grid.n_rho()), step = reached - grid.rho(grid.n_rho() - 1);
  const double growth = std::max(grid.growth(), 1.0);  // cells that shrink would reach nothing
  while (reached < wanted) {
    step *= growth;
    reached += step;
    ++settings.n_rho;
  }
  settings.R = std::sinh(reached) / 2;
  return settings;
}

KindFinder::KindFinder(const FlagParameters& flag, const FlowParameters& flow,
                       const Settings& settings, const EigenSolver& solve)
    : flag_(flag), flow_(flow), settings_(settings), solve_(solve) {}

ModeKind KindFinder::kind_of(Complex lambda, const EnergyShares& share) {
  if (const auto kind = kind_by_shares(share)) return *kind;
  const bool is_beside = beside(share) >= least_beside_flag;
  if (!stays_in_larger_box(lambda, is_beside ? move_of_gap_beside_flag : move_of_gap))
    return ModeKind::box;
  return is_beside ? ModeKind::flag : ModeKind::wake;
}

bool KindFinder::stays_in_larger_box(Complex lambda, double share_of_gap) {
  if (!larger_)
    larger_ = coupled_problem(flag_, flow_, with_larger_box(settings_, grid_of(settings_)));
  const double R = *settings_.R, larger_R = larger_->grid.settings().R;
  ++checked_;
  for (const Disk& disk : disks_) {
    std::vector<Complex> others = disk.nearest_to(lambda);
    if (others.size() > 1) return stays(lambda, std::move(others), R, larger_R, share_of_gap);
  }
  constexpr int neighbours = 8;
  Disk& disk = disks_.emplace_back(Disk{lambda, {}});
  for (const Eigenpair& pair : solve_(larger_->coupled, lambda, neighbours, false).pairs)
    disk.eigenvalues.push_back(pair.lambda);
  return stays(lambda, disk.eigenvalues, R, larger_R, share_of_gap);
}

std::vector<Complex> KindFinder::Disk::nearest_to(Complex lambda) const {
  double radius = 0;
  for (const Complex& each : eigenvalues) radius = std::max(radius, std::abs(each - centre));
  std::vector<Complex> nearest;
  for (const Complex& each : eigenvalues)
    if (std::abs(each - lambda) <= radius - std::abs(lambda - centre)) nearest.push_back(each);
  return nearest;
}

}  // namespace pennon::modes::global
