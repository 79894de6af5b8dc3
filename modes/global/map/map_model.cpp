#include "modes/global/map/map_model.hpp"

#include <cmath>
#include <exception>

namespace pennon::modes::global {

using Complex = std::complex<double>;

MapModel::MapModel(const MapTask& its_task, std::vector<CheckedFit> its_fits, FlagBasis its_basis)
    : task(its_task),
      fits(std::move(its_fits)),
      basis(std::move(its_basis)),
      columns(its_task.flags.size()),
      small_flags_(its_task.flags.size()) {}

void MapModel::find(const std::vector<std::size_t>& these_columns, bool starts_from_known) {
  std::vector<ResponseInWindow> responses;
  for (CheckedFit& fit : fits) {
    fit.reduce(basis);
    responses.push_back({fit.window(), fit.small()});
  }
  for (const std::size_t column : these_columns) small_flags_[column] = basis.reduced(flag(column));
  std::exception_ptr fault;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < these_columns.size(); ++k) {
    try {
      find_column(these_columns[k], responses, starts_from_known);
    } catch (...) {
#pragma omp critical
      fault = std::current_exception();
    }
  }
  if (fault) std::rethrow_exception(fault);
}

void MapModel::find_column(std::size_t k, const std::vector<ResponseInWindow>& responses,
                           bool starts_from_known) {
  MapColumn& column = columns[k];
  const auto is_accepted = [&](std::size_t window, const NeutralMode& mode) {
    return is_of_whole_flag(k, window, mode);
  };
  column = map_column(responses, small_flags_[k], task.mu, task.settings.mu_of_modes, is_accepted,
                      starts_from_known ? &column : nullptr);
}

// Far above the map's mass ratios the basis may have neutral modes where the whole flag has none.
bool MapModel::is_of_whole_flag(std::size_t column, std::size_t window,
                                const NeutralMode& mode) const {
  const MapHeuristics& heuristics = task.settings.heuristics;
  const FlagMode rough = neutral_mode_of_whole_flag(mode.omega, mode.zeta);
  if (neutral_error(column, window, mode.mu, rough) <= heuristics.neutral_error) return true;
  const double same = heuristics.same_neutral_mode;
  const auto found =
      neutral_mode(fits[window].fit().aerodynamics(), flag(column), mode.omega, mode.mu);
  return found && std::abs(found->omega - mode.omega) < same &&
         std::abs(found->mu / mode.mu - 1) < same;
}

bool MapModel::has_mode(const MapPlace& place, std::size_t window) const {
  const std::optional<ColumnMode>& leading = columns[place.column].leading[place.m];
  return leading && leading->window == window;
}

std::vector<MapPlace> MapModel::places(const std::vector<std::size_t>& these_columns,
                                       std::size_t window) const {
  std::vector<MapPlace> found;
  for (const std::size_t column : these_columns)
    for (std::size_t m = 0; m < task.mu.size(); ++m)
      if (has_mode({column, m}, window)) found.push_back({column, m});
  return found;
}

FlagMode MapModel::whole(FlagMode small) const {
  small.zeta = basis.shape(small.zeta).normalized();
  small.shape_by_mu = {};
  return small;
}

Complex MapModel::correction_by(const Aerodynamics& F, const MapPlace& place) const {
  return correction(F, flag(place.column), task.mu[place.m], mode(place));
}

double MapModel::neutral_error(std::size_t column, std::size_t window, double mu,
                               const FlagMode& mode) const {
  return std::abs(correction(fits[window].fit().aerodynamics(), flag(column), mu, mode));
}

}  // namespace pennon::modes::global
