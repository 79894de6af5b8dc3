/// How long the next step of a run is.
#pragma once

#include <cstdint>
#include <optional>

namespace pennon::dns {

/// Equal steps: the times are origin + k dt, and the last is t_end. The origin is 0, or where a
/// restart changed dt.
class EqualSteps {
 public:
  EqualSteps(double dt, double t_end);

  bool are_done() const { return taken_ >= count_; }
  /// The time at the end of the next step.
  double next_time() const;
  void take() { ++taken_; }
  /// Since the origin.
  std::int64_t taken() const { return taken_; }
  double origin() const { return origin_; }
  double dt() const { return dt_; }
  /// So many steps after the origin.
  void go_on(double origin, std::int64_t taken);

 private:
  double dt_, t_end_, origin_ = 0;
  std::int64_t count_, taken_ = 0;
};

/// Steps that keep to a Courant number where there is one, never longer than `most`, and that
/// change so slowly that backward differences stay stable: each is at most 1.2 times the one before
/// and, for the Courant number's sake, at least 0.6 times.
class CourantSteps {
 public:
  CourantSteps(double most, std::optional<double> CFL, double t_end);

  bool are_done(double t) const;
  /// The next step from t. The last fifty share what is left, so that none of them is much shorter
  /// than the one before: the pressure answers a sudden change of the step.
  double next(double t) const;
  /// The next step follows from the one taken and its Courant number.
  void take(double dt, double CFL);

  /// The length that the next step would have if the run did not end: next() may shorten it to
  /// reach t_end. A restart goes on with this length; where `most` is less by
  /// then, the steps shrink to it.
  double dt() const { return dt_; }
  void go_on_with(double dt) { dt_ = dt; }

 private:
  double most_, t_end_;
  std::optional<double> CFL_;
  double dt_;
};

}  // namespace pennon::dns
