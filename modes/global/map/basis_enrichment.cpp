#include "modes/global/map/basis_enrichment.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "modes/global/map/check_places.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

enum class Frequencies { on_grid, half_way };

// Calls use(response, flag, omega) at equally spaced frequencies of each window, its ends among
// them, or half-way between those; at each for a few flags.
template <class Use>
void along_axis(const MapTask& task, const std::vector<CheckedFit>& fits, Frequencies frequencies,
                const Use& use) {
  const MapHeuristics& heuristics = task.settings.heuristics;
  for (const CheckedFit& fit : fits) {
    const auto [low, high] = fit.window();
    const int halves = 2 * static_cast<int>(std::ceil((high - low) / heuristics.frequency_spacing));
    for (int half = frequencies == Frequencies::on_grid ? 0 : 1; half <= halves; half += 2) {
      const double omega = low + (high - low) * half / halves;
      const Response response = fit.fit().aerodynamics()(Complex(0, omega));
      for (const std::size_t column :
           evenly_chosen(task.flags.size(), heuristics.flags_of_first_shapes))
        use(response, task.flags[column], omega);
    }
  }
}

// Adds the shapes of the modes that are nearly neutral at a frequency and whose mass ratio is not
// found in the basis.
void add_missing(const Response& response, const FlagOperator& flag, double omega,
                 const ReducedMapSettings& settings, FlagBasis& basis) {
  const ShapesNearby whole = shapes_nearby(response, flag, omega, settings.mu_of_modes);
  const Eigen::VectorXcd found = mass_ratios(basis.reduced(response.F), basis.reduced(flag), omega);
  for (std::size_t k = 0; k < whole.mu.size(); ++k) {
    const double nearest = (found.array() - whole.mu[k]).abs().minCoeff();
    if (nearest < settings.heuristics.same_mass_ratio * std::abs(whole.mu[k])) continue;
    basis.add(whole.shapes[2 * k]);
    basis.add(whole.shapes[2 * k + 1]);
  }
}

std::vector<WrongMode> wrong_neutral_modes(const MapModel& map,
                                           const std::vector<std::size_t>& columns) {
  std::vector<WrongMode> wrong;
  for (const std::size_t column : columns)
    for (const ColumnNeutral& neutral : map.columns[column].neutral) {
      const FlagMode mode = map.neutral_mode_of_whole_flag(neutral.omega, neutral.zeta);
      const double error = map.neutral_error(column, neutral.window, neutral.mu, mode);
      if (!(error <= map.task.settings.heuristics.neutral_error))
        wrong.push_back({error, neutral.window, column, neutral.mu, mode});
    }
  return wrong;
}

}  // namespace

FlagBasis first_basis(const MapTask& task, const std::vector<CheckedFit>& fits) {
  std::vector<Eigen::VectorXcd> shapes;
  along_axis(task, fits, Frequencies::on_grid,
             [&](const Response& response, const FlagOperator& flag, double omega) {
               ShapesNearby found = shapes_nearby(response, flag, omega, task.settings.mu_of_modes);
               std::ranges::move(found.shapes, std::back_inserter(shapes));
             });
  const Eigen::VectorXd& mass = task.flags.front().mass;
  if (shapes.empty()) shapes.push_back(Eigen::VectorXcd::Ones(mass.size()));
  FlagBasis basis(mass, shapes, task.settings.basis_tolerance);
  if (task.settings.is_improved)
    along_axis(task, fits, Frequencies::half_way,
               [&](const Response& response, const FlagOperator& flag, double omega) {
                 add_missing(response, flag, omega, task.settings, basis);
               });
  return basis;
}

BasisCheck check_basis(const MapModel& map, const std::vector<std::size_t>& columns) {
  const ReducedMapSettings& settings = map.task.settings;
  const double tolerance = settings.heuristics.basis_share * settings.lambda_tolerance;
  BasisCheck check;
  check.wrong = wrong_neutral_modes(map, columns);
  for (std::size_t window = 0; window < map.fits.size(); ++window) {
    const std::vector<MapPlace> all = map.places(columns, window);
    const Aerodynamics F = map.fits[window].fit().aerodynamics();
    for (const std::size_t k : evenly_chosen(all.size(), settings.heuristics.basis_checks)) {
      const MapPlace& at = all[k];
      const double error = std::abs(map.correction_by(F, at));
      // The negations also catch an error that is not a number.
      if (!(error <= check.error)) check.error = error;
      ++check.checked;
      if (!(error <= tolerance))
        check.wrong.push_back({error, window, at.column, map.task.mu[at.m], map.mode(at)});
    }
  }
  return check;
}

void add_shapes_of(std::vector<WrongMode> wrong, MapModel& map) {
  std::ranges::sort(wrong, std::greater(), &WrongMode::error);
  for (const std::size_t k :
       evenly_chosen(wrong.size(), map.task.settings.heuristics.modes_of_round)) {
    const WrongMode& at = wrong[k];
    const Aerodynamics F = map.fits[at.window].fit().aerodynamics();
    const FlagOperator& flag = map.flag(at.column);
    const auto mode = flag_mode(F, flag, at.mu, at.rough.lambda, at.rough.zeta);
    if (!mode) continue;
    const Eigen::VectorXcd psi = left_shape(F, flag, at.mu, *mode);
    map.basis.add(mode->zeta);
    map.basis.add(psi);
  }
}

}  // namespace pennon::modes::global
