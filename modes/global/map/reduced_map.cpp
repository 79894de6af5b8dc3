#include "modes/global/map/reduced_map.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "common/interrupt.hpp"
#include "common/stop_watch.hpp"
#include "modes/global/map/checked_fit.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_samples = 80;   // of a window
constexpr std::size_t most_off_axis = 40;  // of a window
constexpr double of_tolerance = 0.1;       // of lambda, to which a sample that is added is matched
constexpr int most_rounds = 8;
constexpr std::size_t columns_of_rounds = 12;  // the map is improved by so many, then by all
constexpr std::size_t basis_checks = 200;
constexpr std::size_t places_to_ask = 300;  // about the response, at most
constexpr double apart = 0.3;               // of lambda: nearer, a place tells little more
constexpr std::size_t shapes_of_round = 4;
constexpr double basis_share = 0.3;        // of lambda_tolerance
constexpr double same_neutral = 0.05;      // of omega, and of mu in relative terms
constexpr double right_neutral = 1e-3;     // of lambda, of a neutral mode in the basis
constexpr double frequencies_apart = 1.5;  // of omega, where first shapes are taken
constexpr double same_ratio = 1e-3;        // of neutral modes in the basis and of the whole flag

// `count` of 0 ... size - 1, the ends among them.
std::vector<std::size_t> spread(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (size <= count || count < 2) count = size;
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(count == 1 ? 0 : k * (size - 1) / (count - 1));
  return chosen;
}

class Reduction {
 public:
  Reduction(const SampleOf& response, const std::vector<FlagOperator>& flags,
            const std::vector<double>& mu, const ReducedMapSettings& wanted)
      : response_(response), flags_(flags), mu_(mu), wanted_(wanted) {}

  ReducedMap run() {
    const StopWatch watch;
    for (const Interval& window : wanted_.windows) {
      fits_.emplace_back(window, sampled_fit([&](Complex lambda) { return sample(lambda); }, window,
                                             wanted_.fit_tolerance, most_samples));
      map_.fit_error = std::max(map_.fit_error, fits_.back().fit().error);
    }
    take_first_shapes();
    map_.columns.resize(flags_.size());
    const std::vector<std::size_t> few = spread(flags_.size(), columns_of_rounds);
    improve(few, wanted_.checks);
    if (few.size() < flags_.size())
      improve(spread(flags_.size(), flags_.size()), wanted_.checks + wanted_.checks / 2);
    for (const CheckedFit& fit : fits_) map_.samples_off_axis += fit.samples_off_axis;
    map_.basis_size = basis_->size();
    map_.seconds = watch.seconds() - map_.sample_seconds;
    return std::move(map_);
  }

 private:
  Eigen::MatrixXcd sample(Complex lambda) {
    const StopWatch watch;
    Eigen::MatrixXcd F = response_(lambda);
    map_.sample_seconds += watch.seconds();
    ++map_.samples;
    return F;
  }

  // At frequencies over all of the window, every second one from the first or from the one after
  // it, for the first flag, one between and the last.
  template <class Use>
  void along_axis(bool is_between, const Use& use) const {
    for (const CheckedFit& fit : fits_) {
      const auto [low, high] = fit.window();
      const int parts = 2 * static_cast<int>(std::ceil((high - low) / frequencies_apart));
      for (int part = is_between ? 1 : 0; part <= parts; part += 2) {
        const double omega = low + (high - low) * part / parts;
        const Response response = fit.fit().aerodynamics()(Complex(0, omega));
        for (const std::size_t column : spread(flags_.size(), 3))
          use(response, flags_[column], omega);
      }
    }
  }

  // Of what is next to neutral. At the frequencies between, what is neutral or nearly so in the
  // basis must be that of the whole flag.
  void take_first_shapes() {
    std::vector<Eigen::VectorXcd> shapes;
    along_axis(false, [&](const Response& response, const FlagOperator& flag, double omega) {
      ShapesNearby found = shapes_nearby(response, flag, omega, wanted_.mu_of_modes);
      for (Eigen::VectorXcd& shape : found.shapes) shapes.push_back(std::move(shape));
    });
    const Eigen::VectorXd& mass = flags_.front().mass;
    if (shapes.empty()) shapes.push_back(Eigen::VectorXcd::Ones(mass.size()));
    basis_.emplace(mass, shapes, wanted_.basis_tolerance);
    if (wanted_.is_improved)
      along_axis(true, [&](const Response& response, const FlagOperator& flag, double omega) {
        compare_neutral(response, flag, omega);
      });
  }

  void compare_neutral(const Response& response, const FlagOperator& flag, double omega) {
    const ShapesNearby whole = shapes_nearby(response, flag, omega, wanted_.mu_of_modes);
    const Eigen::VectorXcd found =
        mass_ratios(basis_->reduced(response.F), basis_->reduced(flag), omega);
    for (std::size_t k = 0; k < whole.mu.size(); ++k) {
      const double nearest = (found.array() - whole.mu[k]).abs().minCoeff();
      if (nearest < same_ratio * std::abs(whole.mu[k])) continue;
      basis_->add(whole.shapes[2 * k]);
      basis_->add(whole.shapes[2 * k + 1]);
    }
  }

  // Until nothing is found to be wrong by more than the tolerance. The response is asked where the
  // basis is right, so that an error is the fit's.
  void improve(const std::vector<std::size_t>& columns, std::size_t checks) {
    for (int round = 0;; ++round) {
      find(columns, round > 0);
      const bool is_last = round == most_rounds || !wanted_.is_improved;
      if (check_basis(columns, !is_last)) continue;
      if (!check_fits(columns, checks, !is_last)) return;
    }
  }

  // With what is known of the neutral modes, or all anew: those of the column before may have
  // vanished, and others come.
  void find(const std::vector<std::size_t>& columns, bool is_known) {
    std::vector<ResponseInWindow> responses;
    for (CheckedFit& fit : fits_) {
      fit.reduce(*basis_);
      responses.push_back({fit.window(), fit.small()});
    }
    small_flags_.resize(flags_.size());
    for (const std::size_t column : columns) small_flags_[column] = basis_->reduced(flags_[column]);
    std::exception_ptr fault;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      try {
        find_column(columns[k], responses, is_known);
      } catch (...) {
#pragma omp critical
        fault = std::current_exception();
      }
    }
    if (fault) std::rethrow_exception(fault);
  }

  void find_column(std::size_t k, const std::vector<ResponseInWindow>& responses, bool is_known) {
    MapColumn& column = map_.columns[k];
    const auto is_accepted = [&](std::size_t window, const NeutralMode& mode) {
      return is_of_whole_flag(k, window, mode);
    };
    column = map_column(responses, small_flags_[k], mu_, wanted_.mu_of_modes, is_accepted,
                        is_known ? &column : nullptr);
  }

  std::vector<MapPlace> places(const std::vector<std::size_t>& columns, std::size_t window) const {
    std::vector<MapPlace> found;
    for (const std::size_t column : columns)
      for (std::size_t m = 0; m < mu_.size(); ++m) {
        const std::optional<ColumnMode>& most = map_.columns[column].most[m];
        if (most && most->window == window) found.push_back({column, m});
      }
    return found;
  }

  const FlagMode& small_mode_at(const MapPlace& place) const {
    return map_.columns[place.column].most[place.m]->mode;
  }

  // With its shape of the whole flag.
  FlagMode whole(FlagMode mode) const {
    mode.zeta = basis_->shape(mode.zeta).normalized();
    mode.shape_by_mu = {};
    return mode;
  }
  FlagMode mode_at(const MapPlace& place) const {
    return whole(small_mode_at(place));
  }

  Complex correction_by(const Aerodynamics& F, const MapPlace& place) const {
    return correction(F, flags_[place.column], mu_[place.m], mode_at(place));
  }

  // A mode of the basis that is none of the whole flag.
  struct WrongMode {
    double error;
    std::size_t window, column;
    double mu;
    FlagMode rough;
  };

  // Whether shapes were added.
  bool check_basis(const std::vector<std::size_t>& columns, bool may_add) {
    std::vector<WrongMode> wrong = wrong_neutral_modes(columns);
    map_.basis_error = 0;
    map_.checked_basis = 0;
    for (std::size_t w = 0; w < fits_.size(); ++w) {
      const std::vector<MapPlace> all = places(columns, w);
      const Aerodynamics F = fits_[w].fit().aerodynamics();
      for (const std::size_t k : spread(all.size(), basis_checks)) {
        const MapPlace& at = all[k];
        const double error = std::abs(correction_by(F, at));
        if (!(error <= map_.basis_error)) map_.basis_error = error;
        ++map_.checked_basis;
        if (!(error <= basis_share * wanted_.lambda_tolerance))
          wrong.push_back({error, w, at.column, mu_[at.m], mode_at(at)});
      }
    }
    if (wrong.empty() || !may_add || basis_->is_whole()) return false;
    std::ranges::sort(wrong, std::greater(), &WrongMode::error);
    for (const std::size_t k : spread(wrong.size(), shapes_of_round)) add_shapes_of(wrong[k]);
    return true;
  }

  // Neutral modes that the basis does not hold well.
  std::vector<WrongMode> wrong_neutral_modes(const std::vector<std::size_t>& columns) const {
    std::vector<WrongMode> wrong;
    for (const std::size_t column : columns)
      for (const ColumnNeutral& neutral : map_.columns[column].neutral) {
        const FlagMode mode = whole({Complex(0, neutral.omega), neutral.zeta, 0});
        const double error = neutral_error(column, neutral.window, neutral.mu, mode);
        if (!(error <= right_neutral))
          wrong.push_back({error, neutral.window, column, neutral.mu, mode});
      }
    return wrong;
  }

  double neutral_error(std::size_t column, std::size_t window, double mu,
                       const FlagMode& mode) const {
    return std::abs(correction(fits_[window].fit().aerodynamics(), flags_[column], mu, mode));
  }

  // Far above the map's mass ratios the basis may have neutral modes where the whole flag has none.
  bool is_of_whole_flag(std::size_t column, std::size_t window, const NeutralMode& mode) const {
    const FlagMode rough = whole({Complex(0, mode.omega), mode.zeta, 0});
    if (neutral_error(column, window, mode.mu, rough) <= right_neutral) return true;
    const auto found =
        neutral_mode(fits_[window].fit().aerodynamics(), flags_[column], mode.omega, mode.mu);
    return found && std::abs(found->omega - mode.omega) < same_neutral &&
           std::abs(found->mu / mode.mu - 1) < same_neutral;
  }

  void add_shapes_of(const WrongMode& wrong) {
    const Aerodynamics F = fits_[wrong.window].fit().aerodynamics();
    const FlagOperator& flag = flags_[wrong.column];
    const auto mode = flag_mode(F, flag, wrong.mu, wrong.rough.lambda, wrong.rough.zeta);
    if (!mode) return;
    const Eigen::VectorXcd psi = left_shape(F, flag, wrong.mu, *mode);
    basis_->add(mode->zeta);
    basis_->add(psi);
  }

  // Whether samples were added.
  bool check_fits(const std::vector<std::size_t>& columns, std::size_t checks, bool may_add) {
    map_.lambda_error = 0;
    map_.checked = 0;
    bool are_better = false;
    for (std::size_t w = 0; w < fits_.size(); ++w) {
      CheckedFit& fit = fits_[w];
      const std::vector<MapPlace> all = places(columns, w);
      // What was asked before may be wrong with the map as it is now.
      std::vector<ResponseCheck> known;
      std::swap(known, fit.checks);
      std::size_t right = 0;
      for (ResponseCheck& check : known)
        if (is_one(check.at, w)) are_better |= judge(fit, std::move(check), may_add, right);
      while (right < checks) {
        const std::optional<MapPlace> next = next_place(all, fit);
        if (!next) break;
        const Complex lambda = small_mode_at(*next).lambda;
        are_better |= judge(fit, {*next, {lambda, sample(lambda)}}, may_add, right);
        stop_if_interrupted("no map was written");
      }
    }
    return are_better;
  }

  bool is_one(const MapPlace& place, std::size_t window) const {
    const std::optional<ColumnMode>& most = map_.columns[place.column].most[place.m];
    return most && most->window == window;
  }

  // By the map; where the fit has changed since, by the mode that it would have.
  double error_at(const CheckedFit& fit, const ResponseCheck& check) const {
    const Aerodynamics F = fit.through(check.sample);
    if (fit.is_reduced()) return std::abs(correction_by(F, check.at));
    const FlagOperator& flag = flags_[check.at.column];
    const double mu = mu_[check.at.m];
    const FlagMode rough = mode_at(check.at);
    const auto mode = flag_mode(fit.fit().aerodynamics(), flag, mu, rough.lambda, rough.zeta);
    return std::abs(correction(F, flag, mu, mode ? *mode : rough));
  }

  // Keeps the check where lambda is right; else the sample makes the fit better, and true is
  // returned.
  bool judge(CheckedFit& fit, ResponseCheck check, bool may_add, std::size_t& right) {
    const double error = error_at(fit, check);
    const bool is_right = error <= wanted_.lambda_tolerance;  // not so where it is no number
    if (!is_right && may_add && fit.samples_off_axis < most_off_axis) {
      const double closer =
          std::isfinite(error) ? of_tolerance * wanted_.lambda_tolerance / error : 1;
      fit.add_off_axis(std::move(check.sample), closer, *basis_);
      right = 0;
      return true;
    }
    if (!(error <= map_.lambda_error)) map_.lambda_error = error;
    ++map_.checked;
    ++right;
    fit.checks.push_back(std::move(check));
    return false;
  }

  // Where to ask next, of places spread over the map: in turn where lambda is farthest from all at
  // which the response is known, and where a coarser fit would change it most.
  std::optional<MapPlace> next_place(const std::vector<MapPlace>& all,
                                     const CheckedFit& fit) const {
    const bool by_change = fit.checks.size() % 2 == 0;
    const Aerodynamics coarse = fit.coarse();
    std::optional<MapPlace> found;
    double largest = 0;
    for (const std::size_t k : spread(all.size(), places_to_ask)) {
      const MapPlace& place = all[k];
      const FlagMode& mode = small_mode_at(place);
      double doubt = fit.distance_from_known(mode.lambda);
      if (by_change)
        doubt = std::min(doubt / apart, 1.0) *
                std::abs(correction(coarse, small_flags_[place.column], mu_[place.m], mode));
      if (doubt <= largest) continue;
      largest = doubt;
      found = place;
    }
    return found;
  }

  const SampleOf& response_;
  const std::vector<FlagOperator>& flags_;
  const std::vector<double>& mu_;
  const ReducedMapSettings& wanted_;
  ReducedMap map_;
  std::vector<CheckedFit> fits_;  // of each window
  std::optional<FlagBasis> basis_;
  std::vector<FlagOperator> small_flags_;  // in the basis
};

}  // namespace

ReducedMap reduced_map(const SampleOf& response, const std::vector<FlagOperator>& flags,
                       const std::vector<double>& mu, const ReducedMapSettings& wanted) {
  return Reduction(response, flags, mu, wanted).run();
}

}  // namespace pennon::modes::global
