/// What a case asks of the global modes: the table [modes.global].
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/fluid/equations/convection.hpp"
#include "modes/global/study/neutral_settings.hpp"

namespace pennon::modes::global {

/// What is not given is as in [dns]: resolve() fills it in.
struct Settings {
  bool is_given = false;
  std::int64_t n_modes = 6;
  /// Growth rate and angular frequency of each target in turn; empty: see study.hpp.
  std::vector<double> target;
  std::optional<double> k_x;
  /// n_x: stations of the flag in one wave. 0: not given.
  std::int64_t n_rho = 0, n_theta = 0, n_x = 0;
  std::optional<double> R, wall_spacing, wake_clustering, dt;
  std::optional<dns::Convection> convection;
  bool adjoint = false;
  std::int64_t frames = 0;  ///< of the animation of each mode
  std::int64_t ranks = 1;
  NeutralSettings neutral;
  MapSettings map;
};

void declare(Schema&, Settings&);

/// The faults between keys. `is_asked_for`: whether global modes are to be found even if the case
/// has no [modes.global].
void check(const Settings&, const FlagParameters&, bool has_flow, bool is_asked_for, Faults&);

/// The grid and step of the simulation, for what the case does not say about its modes.
struct Discretisation {
  std::int64_t n_rho, n_theta, n_x;
  double R, wall_spacing, wake_clustering, dt;
  dns::Convection convection = dns::Convection::kawamura_kuwahara;
};

/// With every number: k_x is 2 pi/gamma without a value, and 0 in two dimensions.
Settings resolve(Settings, const FlagParameters&, const Discretisation&);

/// Everything that pennon-global has to know, which is written as a case file of its own. `schema`
/// refers to the other members, so a Problem can be neither copied nor moved.
struct Problem {
  FlagParameters flag;
  FlowParameters flow;
  Settings settings;
  Schema schema;

  Problem();
  Problem(const FlagParameters&, const FlowParameters&, const Settings&);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;
  ~Problem() = default;

 private:
  bool has_flow_ = false;
};

}  // namespace pennon::modes::global
