#include "modes/global/reduced_map.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "common/interrupt.hpp"
#include "common/stop_watch.hpp"
#include "modes/global/flag_basis.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_samples = 80;   // of a window
constexpr std::size_t most_off_axis = 40;  // of a window
constexpr int most_rounds = 8;
constexpr std::size_t columns_of_rounds = 12;  // the map is improved by so many, then by all
constexpr std::size_t basis_checks = 200;
constexpr std::size_t places_to_ask = 300;  // about the response, at most
constexpr double apart = 0.3;               // of lambda: nearer, a place tells little more
constexpr std::size_t shapes_of_round = 4;
constexpr double basis_share = 0.3;        // of lambda_tolerance
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

struct Place {
  std::size_t column, m;
};

// Where the response itself was asked, and what it was.
struct Check {
  Place at;
  MatrixSample sample;
};

// The response next to where it is known: the fit, moved by what it misses there.
Aerodynamics through(const RationalFit& fit, const MatrixSample& sample) {
  const Eigen::MatrixXcd missed = sample.F - fit(sample.lambda);
  return [&fit, missed](Complex lambda) {
    return Response{fit(lambda) + missed, [&fit, lambda](const Eigen::VectorXcd& zeta) {
                      return fit.derivative(lambda, zeta);
                    }};
  };
}

class Reduction {
 public:
  Reduction(const SampleOf& response, const std::vector<FlagOperator>& flags,
            const std::vector<double>& mu, const ReducedMapSettings& wanted)
      : response_(response), flags_(flags), mu_(mu), wanted_(wanted) {}

  ReducedMap run() {
    const StopWatch watch;
    for (const Interval& window : wanted_.windows) {
      fits_.push_back(sampled_fit([&](Complex lambda) { return sample(lambda); }, window,
                                  wanted_.fit_tolerance, most_samples));
      map_.fit_error = std::max(map_.fit_error, fits_.back().error);
    }
    checks_.resize(fits_.size());
    take_first_shapes();
    map_.columns.resize(flags_.size());
    const std::vector<std::size_t> few = spread(flags_.size(), columns_of_rounds);
    improve(few, wanted_.checks);
    if (few.size() < flags_.size())
      improve(spread(flags_.size(), flags_.size()), wanted_.checks + wanted_.checks / 2);
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
    for (std::size_t w = 0; w < fits_.size(); ++w) {
      const auto [low, high] = wanted_.windows[w];
      const int parts = 2 * static_cast<int>(std::ceil((high - low) / frequencies_apart));
      for (int part = is_between ? 1 : 0; part <= parts; part += 2) {
        const double omega = low + (high - low) * part / parts;
        const Response response = fits_[w].aerodynamics()(Complex(0, omega));
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

  // Until nothing is found to be wrong by more than the tolerance.
  void improve(const std::vector<std::size_t>& columns, std::size_t checks) {
    for (int round = 0;; ++round) {
      find(columns, round > 0);
      const bool is_last = round == most_rounds || !wanted_.is_improved;
      const bool is_basis_better = check_basis(columns, !is_last);
      const bool are_fits_better = check_fits(columns, checks, !is_last);
      if (!is_basis_better && !are_fits_better) return;
    }
  }

  // With what is known of the neutral modes, or all anew: those of the column before may have
  // vanished, and others come.
  void find(const std::vector<std::size_t>& columns, bool is_known) {
    small_.clear();
    for (const SampledFit& fit : fits_) small_.push_back(basis_->reduced(fit.fit));
    std::vector<ResponseInWindow> responses;
    for (std::size_t w = 0; w < small_.size(); ++w)
      responses.push_back({wanted_.windows[w], aerodynamics_of(small_[w])});
    std::exception_ptr fault;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      try {
        MapColumn& column = map_.columns[columns[k]];
        column = map_column(responses, basis_->reduced(flags_[columns[k]]), mu_,
                            wanted_.mu_of_modes, is_known ? &column : nullptr);
      } catch (...) {
#pragma omp critical
        fault = std::current_exception();
      }
    }
    if (fault) std::rethrow_exception(fault);
  }

  std::vector<Place> places(const std::vector<std::size_t>& columns, std::size_t window) const {
    std::vector<Place> found;
    for (const std::size_t column : columns)
      for (std::size_t m = 0; m < mu_.size(); ++m) {
        const std::optional<ColumnMode>& most = map_.columns[column].most[m];
        if (most && most->window == window) found.push_back({column, m});
      }
    return found;
  }

  // With its shape of the whole flag.
  FlagMode mode_at(const Place& place) const {
    FlagMode mode = map_.columns[place.column].most[place.m]->mode;
    mode.zeta = basis_->shape(mode.zeta).normalized();
    mode.shape_by_mu = {};
    return mode;
  }

  Complex correction_by(const Aerodynamics& F, const Place& place) const {
    return correction(F, flags_[place.column], mu_[place.m], mode_at(place));
  }

  // Whether shapes were added.
  bool check_basis(const std::vector<std::size_t>& columns, bool may_add) {
    struct Wrong {
      double error;
      std::size_t window;
      Place at;
    };
    std::vector<Wrong> wrong;
    map_.basis_error = 0;
    map_.checked_basis = 0;
    for (std::size_t w = 0; w < fits_.size(); ++w) {
      const std::vector<Place> all = places(columns, w);
      const Aerodynamics F = fits_[w].aerodynamics();
      for (const std::size_t k : spread(all.size(), basis_checks)) {
        const double error = std::abs(correction_by(F, all[k]));
        if (!(error <= map_.basis_error)) map_.basis_error = error;
        ++map_.checked_basis;
        if (!(error <= basis_share * wanted_.lambda_tolerance)) wrong.push_back({error, w, all[k]});
      }
    }
    if (wrong.empty() || !may_add || basis_->is_whole()) return false;
    std::ranges::sort(wrong, std::greater(), &Wrong::error);
    for (const std::size_t k : spread(wrong.size(), shapes_of_round))
      add_shapes_at(wrong[k].window, wrong[k].at);
    return true;
  }

  void add_shapes_at(std::size_t window, const Place& place) {
    const Aerodynamics F = fits_[window].aerodynamics();
    const FlagOperator& flag = flags_[place.column];
    const FlagMode rough = mode_at(place);
    const auto mode = flag_mode(F, flag, mu_[place.m], rough.lambda, rough.zeta);
    if (!mode) return;
    const Eigen::VectorXcd psi = left_shape(F, flag, mu_[place.m], *mode);
    basis_->add(mode->zeta);
    basis_->add(psi);
  }

  // Whether samples were added.
  bool check_fits(const std::vector<std::size_t>& columns, std::size_t checks, bool may_add) {
    map_.lambda_error = 0;
    map_.checked = 0;
    is_fit_of_map_.assign(fits_.size(), true);
    bool are_better = false;
    for (std::size_t w = 0; w < fits_.size(); ++w) {
      const std::vector<Place> all = places(columns, w);
      // What was asked before may be wrong with the map as it is now.
      std::vector<Check> known;
      std::swap(known, checks_[w]);
      std::size_t right = 0;
      for (Check& check : known) {
        if (!is_one(check.at, w)) continue;
        are_better |= judge(w, std::move(check), may_add, right);
      }
      while (right < checks) {
        const std::optional<Place> next = next_place(all, w);
        if (!next) break;
        const Complex lambda = map_.columns[next->column].most[next->m]->mode.lambda;
        are_better |= judge(w, {*next, {lambda, sample(lambda)}}, may_add, right);
        stop_if_interrupted("no map was written");
      }
    }
    return are_better;
  }

  bool is_one(const Place& place, std::size_t window) const {
    const std::optional<ColumnMode>& most = map_.columns[place.column].most[place.m];
    return most && most->window == window;
  }

  // By the map; where the fit has changed since, by the mode that it would have.
  double error_at(std::size_t w, const Check& check) const {
    const RationalFit& fit = fits_[w].fit;
    const Aerodynamics F = through(fit, check.sample);
    if (is_fit_of_map_[w]) return std::abs(correction_by(F, check.at));
    const FlagOperator& flag = flags_[check.at.column];
    const double mu = mu_[check.at.m];
    const FlagMode rough = mode_at(check.at);
    const auto mode = flag_mode(aerodynamics_of(fit), flag, mu, rough.lambda, rough.zeta);
    return std::abs(correction(F, flag, mu, mode ? *mode : rough));
  }

  // Keeps the check where lambda is right; else the sample makes the fit better, and true is
  // returned.
  bool judge(std::size_t w, Check check, bool may_add, std::size_t& right) {
    SampledFit& fit = fits_[w];
    const double error = error_at(w, check);
    const bool is_right = error <= wanted_.lambda_tolerance;  // not so where it is no number
    if (!is_right && may_add && off_axis_[w] < most_off_axis) {
      fit.add(std::move(check.sample));
      ++off_axis_[w];
      ++map_.samples_off_axis;
      right = 0;
      is_fit_of_map_[w] = false;
      return true;
    }
    if (!(error <= map_.lambda_error)) map_.lambda_error = error;
    ++map_.checked;
    ++right;
    checks_[w].push_back(std::move(check));
    return false;
  }

  // Where to ask next, of places spread over the map: in turn where lambda is farthest from all at
  // which the response is known, and where a coarser fit would change it most.
  std::optional<Place> next_place(const std::vector<Place>& all, std::size_t w) const {
    const bool by_change = checks_[w].size() % 2 == 0;
    const RationalFit less = fits_[w].coarser();
    const Aerodynamics F = aerodynamics_of(less);
    std::optional<Place> found;
    double largest = 0;
    for (const std::size_t k : spread(all.size(), places_to_ask)) {
      double doubt = distance_from_known(all[k], w);
      if (by_change) doubt = std::min(doubt / apart, 1.0) * std::abs(correction_by(F, all[k]));
      if (doubt <= largest) continue;
      largest = doubt;
      found = all[k];
    }
    return found;
  }

  double distance_from_known(const Place& place, std::size_t w) const {
    const Complex lambda = map_.columns[place.column].most[place.m]->mode.lambda;
    double nearest = std::numeric_limits<double>::infinity();
    for (const MatrixSample& known : fits_[w].samples)
      nearest = std::min(nearest, std::abs(known.lambda - lambda));
    for (const Check& check : checks_[w])
      nearest = std::min(nearest, std::abs(check.sample.lambda - lambda));
    return nearest;
  }

  const SampleOf& response_;
  const std::vector<FlagOperator>& flags_;
  const std::vector<double>& mu_;
  const ReducedMapSettings& wanted_;
  ReducedMap map_;
  std::vector<SampledFit> fits_;     // of each window
  std::vector<RationalFit> small_;   // the same in the basis
  std::vector<bool> is_fit_of_map_;  // not changed since the map was found
  std::optional<FlagBasis> basis_;
  std::vector<std::vector<Check>> checks_;  // of each window
  std::vector<std::size_t> off_axis_ = std::vector<std::size_t>(wanted_.windows.size());
};

}  // namespace

ReducedMap reduced_map(const SampleOf& response, const std::vector<FlagOperator>& flags,
                       const std::vector<double>& mu, const ReducedMapSettings& wanted) {
  return Reduction(response, flags, mu, wanted).run();
}

}  // namespace pennon::modes::global
