#include "modes/global/map/reduced_map.hpp"

#include <algorithm>
#include <numeric>

#include "common/stop_watch.hpp"
#include "modes/global/map/basis_enrichment.hpp"
#include "modes/global/map/check_places.hpp"
#include "modes/global/map/fit_refinement.hpp"
#include "modes/global/map/map_model.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// Finds these columns, checks them and improves basis and fits until no error above its tolerance
// is found. The basis comes first: the response is evaluated only where the basis is right, so that
// an error then is the fit's.
void improve(const std::vector<std::size_t>& columns, std::size_t checks, const SampleOf& response,
             MapModel& model, ReducedMap& map) {
  const ReducedMapSettings& settings = model.task.settings;
  for (int round = 0;; ++round) {
    // The first round searches whole windows: between the columns found before neutral modes may
    // have vanished, and others come.
    model.find(columns, round > 0);
    const bool may_add = settings.is_improved && round < settings.heuristics.most_rounds;
    const BasisCheck basis = check_basis(model, columns);
    map.basis_error = basis.error;
    map.checked_basis = basis.checked;
    if (may_add && !basis.wrong.empty() && !model.basis.is_whole()) {
      add_shapes_of(basis.wrong, model);
      continue;
    }
    const FitCheck fits = check_fits(columns, checks, may_add, response, model);
    map.lambda_error = fits.lambda_error;
    map.checked = fits.checked;
    if (!fits.adds_samples) return;
  }
}

}  // namespace

ReducedMap reduced_map(const SampleOf& response, const std::vector<FlagOperator>& flags,
                       const std::vector<double>& mu, const ReducedMapSettings& settings) {
  const StopWatch watch;
  ReducedMap map;
  const SampleOf counted = [&](Complex lambda) {
    const StopWatch of_sample;
    Eigen::MatrixXcd F = response(lambda);
    map.sample_seconds += of_sample.seconds();
    ++map.samples;
    return F;
  };
  const MapHeuristics& heuristics = settings.heuristics;
  const MapTask task{flags, mu, settings};
  std::vector<CheckedFit> fits;
  for (const Interval& window : settings.windows) {
    fits.emplace_back(
        window, sampled_fit(counted, window, settings.fit_tolerance, heuristics.most_samples));
    map.fit_error = std::max(map.fit_error, fits.back().fit().error);
  }
  FlagBasis basis = first_basis(task, fits);
  MapModel model(task, std::move(fits), std::move(basis));

  const std::vector<std::size_t> few =
      evenly_chosen(flags.size(), heuristics.columns_of_first_rounds);
  improve(few, settings.checks, counted, model, map);
  if (few.size() < flags.size()) {
    std::vector<std::size_t> all(flags.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    improve(all, settings.checks + settings.checks / 2, counted, model, map);
  }

  for (const CheckedFit& fit : model.fits) map.samples_off_axis += fit.samples_off_axis;
  map.basis_size = model.basis.size();
  map.columns = std::move(model.columns);
  map.seconds = watch.seconds() - map.sample_seconds;
  return map;
}

}  // namespace pennon::modes::global
