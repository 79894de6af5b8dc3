#include "dns/run/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace pennon::dns {
namespace {

constexpr double slack = 1e-9;  // of a step, for times that are multiples of it but for rounding

}  // namespace

EqualSteps::EqualSteps(double dt, double t_end) : dt_(dt), t_end_(t_end) {
  go_on(0, 0);
}

double EqualSteps::next_time() const {
  return std::min(t_end_, origin_ + static_cast<double>(taken_ + 1) * dt_);
}

void EqualSteps::go_on(double origin, std::int64_t taken) {
  origin_ = origin;
  taken_ = taken;
  count_ = static_cast<std::int64_t>(std::ceil((t_end_ - origin) / dt_ - slack));
}

CourantSteps::CourantSteps(double most, std::optional<double> CFL, double t_end)
    : most_(most), t_end_(t_end), CFL_(CFL), dt_(most) {}

bool CourantSteps::are_done(double t) const {
  return !(t < t_end_ - slack * dt_);
}

double CourantSteps::next(double t) const {
  constexpr double steps_that_share = 50;
  const double left = t_end_ - t, count = std::ceil(left / dt_ - slack);
  const double share = left / std::max(count, 1.0);
  return count > steps_that_share || std::abs(share - dt_) < slack * dt_ ? dt_ : share;
}

void CourantSteps::take(double dt, double CFL) {
  constexpr double most_growth = 1.2, most_shrinkage = 0.6;
  double most = std::max(most_, most_shrinkage * dt);
  if (CFL_ && CFL > 0) most = std::min(most, dt * std::max(*CFL_ / CFL, most_shrinkage));
  dt_ = std::min(most, most_growth * std::max(dt, dt_));
}

}  // namespace pennon::dns
