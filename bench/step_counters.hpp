/// What benchmarks of a time step count: the fluid's phases, pressure iterations, memory.
#pragma once

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <string>

#include "common/parallel/ranks.hpp"
#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// The mean over the steps of a fluid.
class StepCounters {
 public:
  void add(const FluidStepSummary& summary) {
    seconds_.grid += summary.seconds.grid;
    seconds_.metrics += summary.seconds.metrics;
    seconds_.prediction += summary.seconds.prediction;
    seconds_.projection += summary.seconds.projection;
    pressure_iterations_ += summary.pressure_iterations;
    ++steps_;
  }
  double steps() const { return steps_; }

  /// The phases as `unit`_grid ..., `units_a_second` of them in a second; iterations; ranks.
  void report(benchmark::State& bench, const std::string& unit, double units_a_second) const {
    const auto mean = [&](double seconds) { return seconds * units_a_second / steps_; };
    bench.counters[unit + "_grid"] = mean(seconds_.grid);
    bench.counters[unit + "_metrics"] = mean(seconds_.metrics);
    bench.counters[unit + "_prediction"] = mean(seconds_.prediction);
    bench.counters[unit + "_projection"] = mean(seconds_.projection);
    bench.counters["pressure_iterations"] = pressure_iterations_ / steps_;
    bench.counters["ranks"] = ranks::count();
  }
  double seconds_of_all() const {
    return (seconds_.grid + seconds_.metrics + seconds_.prediction + seconds_.projection) / steps_;
  }

 private:
  FluidStepTimes seconds_;
  double pressure_iterations_ = 0, steps_ = 0;
};

/// The largest resident sets of all ranks so far, in bytes.
inline double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  constexpr double kilobyte = 1024;
  return ranks::sum(static_cast<double>(usage.ru_maxrss)) * kilobyte;
}

}  // namespace pennon::dns
