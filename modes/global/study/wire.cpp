#include "modes/global/study/wire.hpp"

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"

namespace pennon::modes::global {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A struct that is written (const) or read.
template <class Given, class Struct>
concept Is = std::same_as<std::remove_const_t<Given>, Struct>;

// The members of each struct with their keys, named once for writing and reading. A struct with one
// member more does not compile here until that crosses too.

void members(auto& wire, Is<BaseFlowSummary> auto& of) {
  auto& [drag_coefficient, residual, tension] = of;
  wire("drag_coefficient", drag_coefficient);
  wire("residual", residual);
  wire("tension", tension);
}

void members(auto& wire, Is<Sensitivity> auto& of) {
  auto& [mu, K_B, nu_s, tension] = of;
  wire("mu", mu);
  wire("K_B", K_B);
  wire("nu_s", nu_s);
  wire("ln_tension", tension);
}

void members(auto& wire, Is<EnergyShares> auto& of) {
  auto& [flag, near, wake, outer] = of;
  wire("flag", flag);
  wire("near", near);
  wire("wake", wake);
  wire("outer", outer);
}

void members(auto& wire, Is<GlobalMode> auto& of) {
  auto& [lambda, residual, zeta, adjoint_residual, sensitivity, shares, kind] = of;
  wire("growth", "omega", lambda);
  wire("residual", residual);
  wire("zeta", zeta);
  wire("adjoint_residual", adjoint_residual);
  wire("sensitivity", sensitivity);
  wire("shares", shares);
  wire("kind", kind);
}

void members(auto& wire, Is<FoundModes> auto& of) {
  auto& [base_flow, chord, unknowns, requested, converged, searched, box, too_fast, checked,
         biorthogonality_defect, modes, base_seconds, operator_seconds, eigen_seconds] = of;
  wire("base_flow", base_flow);
  wire("y", chord);
  wire("unknowns", unknowns);
  wire("requested", requested);
  wire("converged", converged);
  wire("searched", searched);
  wire("box", box);
  wire("too_fast", too_fast);
  wire("checked", checked);
  wire("biorthogonality_defect", biorthogonality_defect);
  wire("modes", modes);
  wire("base_flow_s", base_seconds);
  wire("operator_s", operator_seconds);
  wire("eigenpairs_s", eigen_seconds);
}

void members(auto& wire, Is<NeutralMode> auto& of) {
  auto& [omega, mu, by_mu, zeta, evaluations] = of;
  wire("omega", omega);
  wire("mu", mu);
  wire("lambda_by_mu", by_mu);
  wire("zeta", zeta);
  wire("evaluations", evaluations);
}

void members(auto& wire, Is<BranchPoint> auto& of) {
  auto& [branch, mode, residual] = of;
  wire("branch", branch);
  wire("mode", mode);
  wire("residual", residual);
}

void members(auto& wire, Is<CurvePoint> auto& of) {
  auto& [value, modes, fit_error, evaluations, seconds, largest_growth, distance] = of;
  wire("value", value);
  wire("modes", modes);
  wire("fit_error", fit_error);
  wire("evaluations", evaluations);
  wire("wall_s", seconds);
  wire("largest_growth", largest_growth);
  wire("distance", distance);
}

void members(auto& wire, Is<MissingPoint> auto& of) {
  auto& [value, fault] = of;
  wire("value", value);
  wire("fault", fault);
}

void members(auto& wire, Is<NeutralCurve> auto& of) {
  auto& [parameter, points, missing] = of;
  wire("over", parameter);
  wire("points", points);
  wire("missing", missing);
}

void members(auto& wire, Is<GrowthMap> auto& of) {
  auto& [parameter, x, mu, growth, omega, neutral, basis_size, fit_error, basis_error, lambda_error,
         checked_basis, checked, samples, samples_off_axis, sample_seconds, map_seconds] = of;
  wire("over", parameter);
  wire("x", x);
  wire("mu", mu);
  wire("growth", growth);
  wire("omega", omega);
  wire("neutral", neutral);
  wire("basis_size", basis_size);
  wire("fit_error", fit_error);
  wire("basis_error", basis_error);
  wire("lambda_error", lambda_error);
  wire("checked_basis", checked_basis);
  wire("checked", checked);
  wire("samples", samples);
  wire("samples_off_axis", samples_off_axis);
  wire("sample_s", sample_seconds);
  wire("map_s", map_seconds);
}

void members(auto& wire, Is<Findings> auto& of) {
  auto& [spectrum, neutral, map] = of;
  wire("global", spectrum);
  wire("neutral", neutral);
  wire("map", map);
}

void members(auto& wire, Is<CurveProgress> auto& of) {
  auto& [found, faults, next, last_scan, scan_to, branches] = of;
  wire("points", found);
  wire("faults", faults);
  wire("next", next);
  wire("last_scan", last_scan);
  wire("scan_to", scan_to);
  wire("branches", branches);
}

void members(auto& wire, Is<MapProgress> auto& of) {
  auto& [map, next] = of;
  wire("map", map);
  wire("next", next);
}

// An enum crosses by its name.
template <class Value>
concept Named = std::same_as<Value, CurveParameter> || std::same_as<Value, ModeKind>;

template <Named Value>
const auto& all_of() {
  if constexpr (std::same_as<Value, CurveParameter>)
    return curve_parameters;
  else
    return mode_kinds;
}

template <Named Value>
Value value_named(const Json& word) {
  Json known;
  for (const Value each : all_of<Value>()) known[name(each)] = static_cast<int>(each);
  return static_cast<Value>(known.at(word.get<std::string>()).template get<int>());
}

template <class Value>
concept Word = std::same_as<Value, std::string>;
template <class Value>
concept Sequence = std::ranges::sized_range<Value> && !Word<Value>;

// Fills a JSON object.
class Writer {
 public:
  template <class Value>
  static Json code(const Value& value) {
    if constexpr (std::floating_point<Value>) {
      if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
      return std::isnan(value) ? Json() : Json(value);
    } else if constexpr (std::integral<Value> || Word<Value>) {
      return value;
    } else if constexpr (Named<Value>) {
      return name(value);
    } else if constexpr (std::same_as<Value, Complex>) {
      return Json::array({code(value.real()), code(value.imag())});
    } else if constexpr (Sequence<Value>) {
      Json json = Json::array();
      for (const auto& each : value) json.push_back(code(each));
      return json;
    } else {
      Writer writer;
      members(writer, value);
      return std::move(writer.json_);
    }
  }

  template <class Value>
  void operator()(const char* key, const Value& value) {
    json_[key] = code(value);
  }
  template <class Value>
  void operator()(const char* key, const std::optional<Value>& value) {
    if (value) json_[key] = code(*value);
  }
  void operator()(const char* real, const char* imaginary, const Complex& value) {
    json_[real] = code(value.real());
    json_[imaginary] = code(value.imag());
  }

 private:
  Json json_ = Json::object();
};

// Takes the members from a JSON object.
class Reader {
 public:
  template <class Value>
  static void decode(const Json& json, Value& value) {
    if constexpr (std::floating_point<Value>) {
      if (json == "inf" || json == "-inf")
        value = json == "inf" ? infinity : -infinity;
      else
        value = json.is_null() ? std::numeric_limits<Value>::quiet_NaN() : json.get<Value>();
    } else if constexpr (std::integral<Value> || Word<Value>) {
      value = json.get<Value>();
    } else if constexpr (Named<Value>) {
      value = value_named<Value>(json);
    } else if constexpr (std::same_as<Value, Complex>) {
      value = {number(json.at(0)), number(json.at(1))};
    } else if constexpr (Sequence<Value>) {
      value.resize(static_cast<decltype(value.size())>(json.size()));
      for (std::size_t k = 0; k < json.size(); ++k)
        decode(json.at(k), value[static_cast<decltype(value.size())>(k)]);
    } else {
      Reader reader(json);
      members(reader, value);
    }
  }

  template <class Value>
  void operator()(const char* key, Value& value) {
    decode(json_.at(key), value);
  }
  template <class Value>
  void operator()(const char* key, std::optional<Value>& value) {
    if (json_.contains(key)) decode(json_.at(key), value.emplace());
  }
  void operator()(const char* real, const char* imaginary, Complex& value) {
    value = {number(json_.at(real)), number(json_.at(imaginary))};
  }

 private:
  explicit Reader(const Json& json) : json_(json) {}
  static double number(const Json& json) {
    double value = 0;
    decode(json, value);
    return value;
  }

  const Json& json_;
};

}  // namespace

Json to_wire(const Findings& findings) {
  return Writer::code(findings);
}

Findings from_wire(const Json& json) {
  Findings findings;
  Reader::decode(json, findings);
  return findings;
}

Json to_wire(const CurveProgress& progress) {
  return Writer::code(progress);
}
Json to_wire(const MapProgress& progress) {
  return Writer::code(progress);
}
void from_wire(const Json& json, CurveProgress& progress) {
  Reader::decode(json, progress);
}
void from_wire(const Json& json, MapProgress& progress) {
  Reader::decode(json, progress);
}

void write_findings(const Findings& findings, const std::filesystem::path& path) {
  write_file(path, to_wire(findings).dump(1) + "\n");
}

Findings read_findings(const std::filesystem::path& path) try {
  std::ifstream file(path);
  if (!file) throw FileError(path.string() + ", which pennon-global writes, cannot be read");
  return from_wire(Json::parse(file));
} catch (const nlohmann::json::exception& fault) {
  throw FileError(
      fmt::format("{} is not what pennon-global writes: {}", path.string(), fault.what()));
}

}  // namespace pennon::modes::global
