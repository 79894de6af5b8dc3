#include "modes/global/study/neutral_settings.hpp"

#include <fmt/format.h>

#include "common/case/parameters.hpp"

namespace pennon::modes::global {
namespace {

template <class Settings>
const std::optional<Sweep>& sweep_of(const Settings& settings, CurveParameter parameter) {
  switch (parameter) {
    case CurveParameter::Re:
      return settings.Re;
    case CurveParameter::k_x:
      return settings.k_x;
    case CurveParameter::K_B:
      return settings.K_B;
    default:
      return settings.nu_s;
  }
}

void check_interval(const std::string& key, const std::vector<double>& ends, Faults& faults) {
  if (ends.size() != 2)
    faults.about(key,
                 fmt::format("{} holds {} numbers; it is [least, greatest]", key, ends.size()));
  else if (!(ends[0] < ends[1]))
    faults.about(key, fmt::format("{} = [{}, {}] is empty: the first must be the smaller one", key,
                                  ends[0], ends[1]));
}

void check_values(const std::string& key, const Sweep& values, Faults& faults) {
  constexpr std::int64_t most_points = 10000;
  if (values.size() > most_points)
    faults.about(key,
                 fmt::format("{} has {} points; it may have {}", key, values.size(), most_points));
  else if (!values.is_increasing())
    faults.about(key, key + " must list its values in increasing order");
}

// One of the four is given, in order.
template <class Settings>
void check_sweep(const std::string& table, const Settings& settings, Faults& faults) {
  int given = 0;
  for (const CurveParameter parameter : curve_parameters) {
    const std::optional<Sweep>& values = sweep_of(settings, parameter);
    if (!values) continue;
    ++given;
    check_values(fmt::format("{}.{}", table, name(parameter)), *values, faults);
  }
  if (given != 1)
    faults.about(table, fmt::format("{} needs one of Re, k_x, K_B, nu_s as a range or a list; it "
                                    "has {}",
                                    table, given));
}

template <class Settings>
CurveParameter parameter_of(const Settings& settings) {
  for (const CurveParameter parameter : curve_parameters)
    if (sweep_of(settings, parameter)) return parameter;
  return CurveParameter::Re;
}

template <class Settings>
void declare_sweeps(Table& table, Settings& settings) {
  table.key({"Re", &settings.Re, "Reynolds number V L/nu", ranges::Re})
      .key({"k_x", &settings.k_x, "spanwise wavenumber, in 1/L", Range{0, 1e30}})
      .key({"K_B", &settings.K_B, "bending stiffness EI/(rho_f V^2 L^3)", ranges::K_B})
      .key({"nu_s", &settings.nu_s, "Poisson ratio", ranges::nu_s});
}

}  // namespace

void declare(Schema& schema, NeutralSettings& settings) {
  Table& table =
      schema.table("modes.global.neutral",
                   "The neutral curve: the critical mass ratio mu_cr, above which the first global "
                   "mode grows, along one of Re, k_x, K_B, nu_s. flag.mu does not enter.",
                   &settings.is_given);
  declare_sweeps(table, settings);
  table.key({"mu", &settings.mu, "mass ratios between which neutral modes are sought", positive})
      .key({"omega", &settings.omega,
            "angular frequencies between which they are sought, in V/L; with a cross-flow and k_x "
            "!= "
            "0, where the spectrum is not symmetric, those of either sign whose size is between",
            positive})
      .key({"branches", &settings.branches,
            "neutral modes that are followed, those of the smallest mass ratios", Range{1, 20}})
      .key({"scan_every", &settings.scan_every,
            "at the first point, the last and every such point all neutral modes are sought anew; "
            "between, those known are followed",
            Range{1, 1e6}})
      .key({"fit_tolerance", &settings.fit_tolerance,
            "relative error of the fluid's response where all are sought; what is found is then "
            "solved without it",
            Range{1e-10, 1e-2}})
      .key({"check", &settings.check,
            "find the leading modes at mu_cr by the full operator too, at the first point and the "
            "last"})
      .key({"title", &settings.title, "of the picture"});
}

void check(const NeutralSettings& settings, Faults& faults) {
  if (!settings.is_given) return;
  check_sweep("modes.global.neutral", settings, faults);
  check_interval("modes.global.neutral.mu", settings.mu, faults);
  check_interval("modes.global.neutral.omega", settings.omega, faults);
}

void declare(Schema& schema, MapSettings& settings) {
  Table& table =
      schema.table("modes.global.map",
                   "Growth rates over mu, along the ordinate, and one of Re, k_x, K_B, nu_s, by a "
                   "rational fit of "
                   "the fluid's response: one fit for all K_B or nu_s, one for each Re or k_x.",
                   &settings.is_given);
  table.key({"mu", &settings.mu, "mass ratios", ranges::mu, true});
  declare_sweeps(table, settings);
  table
      .key({"omega", &settings.omega,
            "angular frequencies between which modes become neutral, in V/L, of either sign as in "
            "[modes.global.neutral]",
            positive})
      .key({"fit_tolerance", &settings.fit_tolerance,
            "relative error of the fit along the axis of the angular frequency",
            Range{1e-10, 1e-2}})
      .key({"lambda_tolerance", &settings.lambda_tolerance,
            "error of growth rate and angular frequency, in V/L: where a check finds more, fit and "
            "basis of the flag's shapes are improved",
            Range{1e-9, 1e-1}})
      .key({"title", &settings.title, "of the picture"});
}

void check(const MapSettings& settings, Faults& faults) {
  if (!settings.is_given) return;
  check_sweep("modes.global.map", settings, faults);
  if (settings.mu) check_values("modes.global.map.mu", *settings.mu, faults);
  check_interval("modes.global.map.omega", settings.omega, faults);
}

CurveParameter parameter(const NeutralSettings& settings) {
  return parameter_of(settings);
}
const Sweep& sweep(const NeutralSettings& settings) {
  return *sweep_of(settings, parameter(settings));
}
CurveParameter parameter(const MapSettings& settings) {
  return parameter_of(settings);
}
const Sweep& sweep(const MapSettings& settings) {
  return *sweep_of(settings, parameter(settings));
}

const char* name(CurveParameter parameter) {
  switch (parameter) {
    case CurveParameter::Re:
      return "Re";
    case CurveParameter::k_x:
      return "k_x";
    case CurveParameter::K_B:
      return "K_B";
    default:
      return "nu_s";
  }
}

}  // namespace pennon::modes::global
