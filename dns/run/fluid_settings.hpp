/// The fluid's grid, among the keys of [dns], and the table [dns.fluid].
#pragma once

#include <cstdint>
#include <optional>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/fluid/equations/convection.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/fluid/parameters.hpp"

namespace pennon::dns {

struct FluidSettings {
  std::int64_t n_rho = 60;
  std::int64_t n_theta = 120;
  double R = 8;
  double wall_spacing = 0.012;
  double wake_clustering = 0;
  std::optional<double> cfl;
  std::optional<double> first_dt;
  Convection convection = Convection::kawamura_kuwahara;
  FluidTolerances tolerances;
};

/// The keys of the grid, into [dns].
void declare_grid(Table& dns, FluidSettings&);
/// [dns.fluid].
void declare(Schema&, FluidSettings&);
/// `n_x`: points along the span; `dt`: the largest step.
void check(const FluidSettings&, std::int64_t n_x, double dt, const FlagParameters&, Faults&);

/// The fluid with the grid, span, parameters and tolerances of a case, in a stream that rises over
/// the time `ramp`.
Fluid fluid_of(const FluidSettings&, std::int64_t n_x, const FlagParameters&, const FlowParameters&,
               double ramp);

}  // namespace pennon::dns
