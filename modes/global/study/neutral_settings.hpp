/// What a case asks of the neutral curve and of the map of growth rates: the tables
/// [modes.global.neutral] and [modes.global.map].
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/sweep.hpp"

namespace pennon::modes::global {

/// What may vary along a neutral curve.
enum class CurveParameter { Re, k_x, K_B, nu_s };
inline constexpr std::array curve_parameters = {CurveParameter::Re, CurveParameter::k_x,
                                                CurveParameter::K_B, CurveParameter::nu_s};

struct NeutralSettings {
  bool is_given = false;
  std::optional<Sweep> Re = {}, k_x = {}, K_B = {}, nu_s = {};  ///< one of them
  std::vector<double> mu = {0.001, 1};                          ///< least and greatest
  std::vector<double> omega = {1, 13};
  std::int64_t branches = 2;
  std::int64_t scan_every = 4;
  double fit_tolerance = 1e-5;
  bool check = true;
  std::string title = {};
};

struct MapSettings {
  bool is_given = false;
  std::optional<Sweep> mu = {};
  std::optional<Sweep> Re = {}, k_x = {}, K_B = {}, nu_s = {};  ///< one of them
  std::vector<double> omega = {1, 13};
  double fit_tolerance = 1e-6;
  double lambda_tolerance = 1e-5;
  std::string title = {};
};

void declare(Schema&, NeutralSettings&);
void declare(Schema&, MapSettings&);
void check(const MapSettings&, Faults&);
void check(const NeutralSettings&, Faults&);

/// Precondition: check() finds no fault.
CurveParameter parameter(const NeutralSettings&);
const Sweep& sweep(const NeutralSettings&);
CurveParameter parameter(const MapSettings&);
const Sweep& sweep(const MapSettings&);
/// As in the case file.
const char* name(CurveParameter);

}  // namespace pennon::modes::global
