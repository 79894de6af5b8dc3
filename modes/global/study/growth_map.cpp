#include "modes/global/study/growth_map.hpp"

#include <algorithm>
#include <limits>

#include "common/interrupt.hpp"
#include "common/progress.hpp"
#include "modes/global/map/reduced_map.hpp"
#include "modes/global/study/linearisation.hpp"

namespace pennon::modes::global {
namespace {

constexpr double least_mu_of_modes = 1e-4;
constexpr double greatest_over_map = 20;  // neutral modes are sought up to so many times its mu
// Of the response itself, where one fit serves all columns and where each has its own.
constexpr std::size_t checks_of_map = 8, checks_of_column = 3;

class Map {
 public:
  Map(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings,
      std::shared_ptr<SparseFactors> factors)
      : wanted_(settings.map),
        linearisations_(flag, flow, settings, parameter(wanted_), std::move(factors)) {
    map_.parameter = parameter(wanted_);
    map_.x = sweep(wanted_).values();
    map_.mu = wanted_.mu->values();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    map_.growth.assign(map_.mu.size(), std::vector<double>(map_.x.size(), none));
    map_.omega = map_.growth;
    map_.neutral.resize(map_.x.size());
  }

  GrowthMap run(const Keeper<MapProgress>& keeper) {
    const std::size_t columns = linearisations_.fluid_varies() ? 1 : map_.x.size();
    MapProgress so_far = keeper.begin();
    if (so_far.next > 0) map_ = std::move(so_far.map);
    Progress progress(names_of_progress[1], static_cast<std::int64_t>(map_.x.size()), true);
    progress.begin_at(static_cast<std::int64_t>(so_far.next));
    for (std::size_t first = so_far.next; first < map_.x.size(); first += columns) {
      stop_if_interrupted("no map was written");
      find(first, columns);
      keeper.keep({map_, first + columns});
      progress.advance_to(static_cast<std::int64_t>(first + columns));
    }
    return std::move(map_);
  }

 private:
  // Columns that share the flow.
  void find(std::size_t first, std::size_t columns) {
    Linearisation linearised = linearisations_.at(map_.x[first]);
    std::vector<FlagOperator> flags;
    for (std::size_t i = first; i < first + columns; ++i)
      flags.push_back(linearisations_.flag_at(map_.x[i]));
    const ReducedMap found = reduced_map(
        [&](std::complex<double> lambda) { return linearised.F.at(lambda); }, flags, map_.mu,
        {.windows = frequency_windows({wanted_.omega[0], wanted_.omega[1]},
                                      linearised.coupled.fluid().is_symmetric),
         .mu_of_modes = {least_mu_of_modes, greatest_over_map * map_.mu.back()},
         .fit_tolerance = wanted_.fit_tolerance,
         .lambda_tolerance = wanted_.lambda_tolerance,
         .checks = linearisations_.fluid_varies() ? checks_of_column : checks_of_map});
    for (std::size_t i = 0; i < columns; ++i) take(found.columns[i], first + i);
    take_errors(found);
  }

  void take(const MapColumn& column, std::size_t i) {
    for (const ColumnNeutral& neutral : column.neutral) map_.neutral[i].push_back(neutral.mu);
    for (std::size_t m = 0; m < map_.mu.size(); ++m)
      if (const std::optional<ColumnMode>& leading = column.leading[m]) {
        map_.growth[m][i] = leading->mode.lambda.real();
        map_.omega[m][i] = leading->mode.lambda.imag();
      }
  }

  void take_errors(const ReducedMap& found) {
    map_.basis_size = std::max(map_.basis_size, found.basis_size);
    map_.fit_error = std::max(map_.fit_error, found.fit_error);
    map_.basis_error = std::max(map_.basis_error, found.basis_error);
    map_.lambda_error = std::max(map_.lambda_error, found.lambda_error);
    map_.checked_basis += found.checked_basis;
    map_.checked += found.checked;
    map_.samples += found.samples;
    map_.samples_off_axis += found.samples_off_axis;
    map_.sample_seconds += found.sample_seconds;
    map_.map_seconds += found.seconds;
  }

  const MapSettings& wanted_;
  Linearisations linearisations_;
  GrowthMap map_;
};

}  // namespace

GrowthMap growth_map(const FlagParameters& flag, const FlowParameters& flow,
                     const Settings& settings, const std::shared_ptr<SparseFactors>& factors,
                     const Keeper<MapProgress>& keeper) {
  return Map(flag, flow, settings, factors).run(keeper);
}

}  // namespace pennon::modes::global
