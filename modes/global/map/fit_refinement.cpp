#include "modes/global/map/fit_refinement.hpp"

#include <cmath>
#include <utility>

#include "common/interrupt.hpp"
#include "modes/global/map/check_places.hpp"

namespace pennon::modes::global {
namespace {

// The error of lambda at a check, to first order. Where the fit has got samples since the map was
// found, the error is that of the mode which the present fit has there.
double error_at(const MapModel& map, const CheckedFit& fit, const ResponseCheck& check) {
  const Aerodynamics F = fit.through(check.sample);
  if (fit.is_reduced()) return std::abs(map.correction_by(F, check.at));
  const FlagOperator& flag = map.flag(check.at.column);
  const double mu = map.task.mu[check.at.m];
  const FlagMode rough = map.mode(check.at);
  const auto mode = flag_mode(fit.fit().aerodynamics(), flag, mu, rough.lambda, rough.zeta);
  return std::abs(correction(F, flag, mu, mode ? *mode : rough));
}

// The checks of one window.
class WindowCheck {
 public:
  WindowCheck(MapModel& map, std::size_t window, bool may_add, FitCheck& result)
      : map_(map), window_(window), fit_(map.fits[window]), may_add_(may_add), result_(result) {}

  // Judges those that were made before: they may be wrong with the map as it is now.
  void repeat_known() {
    std::vector<ResponseCheck> known;
    std::swap(known, fit_.checks);
    for (ResponseCheck& check : known)
      if (map_.has_mode(check.at, window_)) judge(std::move(check));
  }

  void run(const std::vector<MapPlace>& places, std::size_t checks, const SampleOf& response) {
    while (right_in_succession_ < checks) {
      const std::optional<MapPlace> next = next_place(map_, places, fit_);
      if (!next) break;
      const std::complex<double> lambda = map_.small_mode(*next).lambda;
      judge({*next, {lambda, response(lambda)}});
      stop_if_interrupted("no map was written");
    }
  }

 private:
  // Keeps a check at which lambda is right; else, where samples may be added, its response becomes
  // one of the fit's.
  void judge(ResponseCheck check) {
    const ReducedMapSettings& settings = map_.task.settings;
    const MapHeuristics& heuristics = settings.heuristics;
    const double error = error_at(map_, fit_, check);
    const bool is_right = error <= settings.lambda_tolerance;  // false where it is not a number
    if (!is_right && may_add_ && fit_.samples_off_axis < heuristics.most_samples_off_axis) {
      const double closer = std::isfinite(error) ? heuristics.share_at_added_sample *
                                                       settings.lambda_tolerance / error
                                                 : 1;
      fit_.add_off_axis(std::move(check.sample), closer, map_.basis);
      right_in_succession_ = 0;
      result_.adds_samples = true;
      return;
    }
    if (!(error <= result_.lambda_error)) result_.lambda_error = error;
    ++result_.checked;
    ++right_in_succession_;
    fit_.checks.push_back(std::move(check));
  }

  MapModel& map_;
  std::size_t window_;
  CheckedFit& fit_;
  bool may_add_;
  FitCheck& result_;
  std::size_t right_in_succession_ = 0;
};

}  // namespace

FitCheck check_fits(const std::vector<std::size_t>& columns, std::size_t checks, bool may_add,
                    const SampleOf& response, MapModel& map) {
  FitCheck result;
  for (std::size_t window = 0; window < map.fits.size(); ++window) {
    WindowCheck of_window(map, window, may_add, result);
    const std::vector<MapPlace> places = map.places(columns, window);
    of_window.repeat_known();
    of_window.run(places, checks, response);
  }
  return result;
}

}  // namespace pennon::modes::global
