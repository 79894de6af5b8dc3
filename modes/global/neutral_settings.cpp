#include "modes/global/neutral_settings.hpp"

#include <fmt/format.h>

#include <array>

#include "common/parameters.hpp"

namespace pennon::modes::global {
namespace {

constexpr std::array parameters = {CurveParameter::Re, CurveParameter::k_x, CurveParameter::K_B,
                                   CurveParameter::nu_s};

const std::optional<Sweep>& sweep_of(const NeutralSettings& settings, CurveParameter parameter) {
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

}  // namespace

void declare(Schema& schema, NeutralSettings& settings) {
  schema
      .table("modes.global.neutral",
             "The neutral curve: the critical mass ratio mu_cr, above which the first global mode "
             "grows, along one of Re, k_x, K_B, nu_s. flag.mu does not enter.",
             &settings.is_given)
      .key({"Re", &settings.Re, "along the curve: Reynolds number V L/nu", ranges::Re})
      .key({"k_x", &settings.k_x, "along the curve: spanwise wavenumber, in 1/L", Range{0, 1e30}})
      .key({"K_B", &settings.K_B, "along the curve: bending stiffness EI/(rho_f V^2 L^3)",
            ranges::K_B})
      .key({"nu_s", &settings.nu_s, "along the curve: Poisson ratio", ranges::nu_s})
      .key({"mu", &settings.mu, "mass ratios between which neutral modes are sought", positive})
      .key({"omega", &settings.omega, "angular frequencies between which they are sought, in V/L",
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
  int given = 0;
  for (const CurveParameter parameter : parameters) {
    const std::optional<Sweep>& values = sweep_of(settings, parameter);
    if (!values) continue;
    ++given;
    const std::string key = fmt::format("modes.global.neutral.{}", name(parameter));
    constexpr std::int64_t most_points = 10000;
    if (values->size() > most_points)
      faults.about(key, fmt::format("{} has {} points; a neutral curve has at most {}", key,
                                    values->size(), most_points));
    else if (!values->is_increasing())
      faults.about(key, key + " must list its values in increasing order");
  }
  if (given != 1)
    faults.about("modes.global.neutral",
                 fmt::format("modes.global.neutral needs one of Re, k_x, K_B, nu_s as a range or a "
                             "list; it has {}",
                             given));
  check_interval("modes.global.neutral.mu", settings.mu, faults);
  check_interval("modes.global.neutral.omega", settings.omega, faults);
}

CurveParameter parameter(const NeutralSettings& settings) {
  for (const CurveParameter parameter : parameters)
    if (sweep_of(settings, parameter)) return parameter;
  return CurveParameter::Re;
}

const Sweep& sweep(const NeutralSettings& settings) {
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
