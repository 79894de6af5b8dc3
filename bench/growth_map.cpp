/// A map of growth rates of 10 000 points over mu and K_B,
/// data/cases/modes/growth_map_stiffness.toml: what it costs once the samples of the fluid's
/// response are there, for one thread and two. The samples are taken in a first map, which is not
/// timed.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <list>

#include "modes/global/map/reduced_map.hpp"
#include "modes/global/study/linearisation.hpp"

namespace {

using namespace pennon;
using namespace pennon::modes::global;

class StiffnessMap {
 public:
  StiffnessMap()
      : settings_(settings()),
        linearisations_(flag_, {.Re = 1000}, settings_, CurveParameter::K_B, umfpack_factors()),
        linearisation_(linearisations_.at(flag_.K_B)) {
    for (const double K_B : logarithmic(1e-5, 1e-2)) flags_.push_back(linearisations_.flag_at(K_B));
  }

  ReducedMap find() {
    return reduced_map([&](std::complex<double> lambda) { return response(lambda); }, flags_,
                       logarithmic(0.01, 1),
                       {.windows = {{1, 13}},
                        .mu_of_modes = {1e-4, 20},
                        .fit_tolerance = 1e-6,
                        .lambda_tolerance = 1e-5,
                        .checks = 8});
  }

 private:
  Settings settings() const {
    Settings asked;
    asked.is_given = true;
    return resolve(asked, flag_,
                   {.n_rho = 60,
                    .n_theta = 120,
                    .n_x = 60,
                    .R = 8,
                    .wall_spacing = 0.012,
                    .wake_clustering = 0,
                    .dt = 0.002});
  }

  static std::vector<double> logarithmic(double from, double to) {
    return Sweep{.from = from, .to = to, .points = 100, .scale = Scale::log, .list = {}}.values();
  }

  Eigen::MatrixXcd response(std::complex<double> lambda) {
    for (const MatrixSample& sample : known_)
      if (sample.lambda == lambda) return sample.F;
    return known_.emplace_back(MatrixSample{lambda, linearisation_.F.at(lambda)}).F;
  }

  FlagParameters flag_{.mu = 1, .K_B = 1e-4, .gamma = {}};
  Settings settings_;
  Linearisations linearisations_;
  Linearisation linearisation_;
  std::vector<FlagOperator> flags_;
  std::list<MatrixSample> known_;
};

void stiffness_map(benchmark::State& state) {
  static StiffnessMap map;
  static const ReducedMap first = map.find();
  omp_set_num_threads(static_cast<int>(state.range(0)));
  ReducedMap found;
  for (auto _ : state) found = map.find();
  state.counters["shapes"] = static_cast<double>(found.basis_size);
  state.counters["samples"] = static_cast<double>(found.samples);
  state.counters["lambda_error"] = found.lambda_error;
  state.counters["basis_error"] = found.basis_error;
}
BENCHMARK(stiffness_map)->Arg(1)->Arg(2)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace
