#include "modes/global/study/modes_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/shape_phases.hpp"

namespace pennon::modes::global {
namespace {

using Json = nlohmann::ordered_json;
using Complex = std::complex<double>;

double frequency(const GlobalMode& mode) {
  return mode.lambda.imag() / (2 * std::numbers::pi);
}

Json to_json(const Sensitivity& sensitivity) {
  const auto parts = [](const Complex& value) { return Json{value.real(), value.imag()}; };
  return {{"mu", parts(sensitivity.mu)},
          {"K_B", parts(sensitivity.K_B)},
          {"nu_s", parts(sensitivity.nu_s)},
          {"ln_tension", parts(sensitivity.tension)}};
}

Json to_json(const EnergyShares& shares) {
  return {
      {"flag", shares.flag}, {"near", shares.near}, {"wake", shares.wake}, {"outer", shares.outer}};
}

Json to_json(const GlobalMode& mode) {
  Json json = {{"growth", mode.lambda.real()}, {"omega", mode.lambda.imag()},
               {"frequency", frequency(mode)}, {"residual", mode.residual},
               {"kind", name(mode.kind)},      {"shares", to_json(mode.shares)}};
  if (mode.sensitivity) {
    json["adjoint_residual"] = mode.adjoint_residual;
    json["sensitivity"] = to_json(*mode.sensitivity);
  }
  return json;
}

// The spectrum.
std::string table_of_modes(const FoundModes& found) {
  CsvText table(
      "global modes exp(lambda t): growth and angular frequency in V/L; what each belongs to, "
      "modes "
      "of the box, which move with its size, last; shares of its energy: the flag's, the fluid's "
      "near it, in the wake (y > 1.5) and outside (r > R/2)",
      {"kind", "growth", "omega", "frequency", "residual", "share_flag", "share_near", "share_wake",
       "share_outer"});
  for (const GlobalMode& mode : found.modes) {
    const auto& [flag, near, wake, outer] = mode.shares;
    table.row({mode.lambda.real(), mode.lambda.imag(), frequency(mode), mode.residual, flag, near,
               wake, outer},
              {name(mode.kind)});
  }
  return table.text();
}

// The flag along the chord in each mode; at the phase 0 its displacement is zeta_real.
std::string table_of_shapes(const FoundModes& found) {
  static_assert(shape_phases.front() == 0);
  std::vector<std::string> columns = {"mode", "y", "zeta_real", "zeta_imag"};
  for (std::size_t k = 1; k < shape_phases.size(); ++k)
    columns.push_back(fmt::format("at_{}", shape_phases[k]));
  CsvText table(
      "displacement of the flag in its global modes, 1 where it is largest, and at phases in "
      "degrees (at 0 it is zeta_real); y in L",
      columns);
  for (std::size_t m = 0; m < found.modes.size(); ++m)
    for (std::size_t j = 0; j < found.chord.size(); ++j) {
      const Complex zeta = found.modes[m].zeta[j];
      std::vector<double> row = {static_cast<double>(m + 1), found.chord[j], zeta.real(),
                                 zeta.imag()};
      for (std::size_t k = 1; k < shape_phases.size(); ++k)
        row.push_back((zeta * std::polar(1.0, shape_phases[k] * std::numbers::pi / 180)).real());
      table.row(row);
    }
  return table.text();
}

std::string line_of(const GlobalMode& mode) {
  const auto& [flag, near, wake, outer] = mode.shares;
  // What is left of the frequency of a mode that does not swing is rounding.
  constexpr double left = 1e-9;
  const double omega =
      std::abs(mode.lambda.imag()) > left * std::abs(mode.lambda) ? mode.lambda.imag() : 0;
  return fmt::format(
      " {:11.6g} {:11.6g} {:11.6g}   {:.1e}      {:8.1e} {:7.1e} {:7.1e} {:7.1e}{}\n",
      mode.lambda.real(), omega, omega / (2 * std::numbers::pi), mode.residual, flag, near, wake,
      outer, mode.kind == ModeKind::wake ? "  (wake)" : "");
}

constexpr const char* residual_is_no_error =
    "  A small residual says that a mode is one of this grid, not that the grid is fine enough:\n"
    "  compare with more cells (n_rho, n_theta).\n";

}  // namespace

Json to_json(const FoundModes& found) {
  Json json = {{"base_flow",
                {{"drag_coefficient", found.base_flow.drag_coefficient},
                 {"tension_leading_edge", found.base_flow.tension.front()},
                 {"residual", found.base_flow.residual}}},
               {"requested", found.requested},
               {"converged", found.converged},
               {"searched", found.searched},
               {"box", found.box},
               {"too_fast", found.too_fast},
               {"checked_in_larger_box", found.checked}};
  if (found.biorthogonality_defect) json["biorthogonality_defect"] = *found.biorthogonality_defect;
  json["modes"] = Json::array();
  for (const GlobalMode& mode : found.modes) json["modes"].push_back(to_json(mode));
  return json;
}

void write_tables(const FoundModes& found, const OutputFolder& folder) {
  write_file(folder / "global_modes.csv", table_of_modes(found));
  write_file(folder / "global_shapes.csv", table_of_shapes(found));
}

std::string text_of(const FoundModes& found) {
  std::string text = fmt::format(
      "  global modes: {} of {} found; steady flow: drag coefficient {:.6g}, tension at the "
      "leading edge {:.6g}\n",
      found.converged, found.requested, found.base_flow.drag_coefficient,
      found.base_flow.tension.front());
  const char* heading =
      "      growth       omega   frequency  residual  energy: flag    near    wake   outer\n";
  if (found.converged > 0) text += heading;
  const auto is_of_box = [](const GlobalMode& mode) { return mode.kind == ModeKind::box; };
  const auto first_of_box = std::ranges::find_if(found.modes, is_of_box);
  for (auto mode = found.modes.begin(); mode != first_of_box; ++mode) text += line_of(*mode);
  if (found.converged > 0) text += residual_is_no_error;
  if (found.converged < found.requested)
    text += fmt::format(
        "  {} of those asked for are not among the {} pairs next to each target; another\n"
        "  modes.global.target may find them\n",
        found.requested - found.converged, found.searched);
  if (found.box > 0) {
    const auto listed = found.modes.end() - first_of_box;
    text += fmt::format(
        "  {} pairs belong to the box in which the flow is computed and say nothing about the "
        "flag:\n"
        "  their energy lies outside, or they move when R grows by half (tried for {}){}\n",
        found.box, found.checked, listed > 0 ? fmt::format("; {} of them:", listed) : "");
    if (first_of_box != found.modes.end()) text += heading;
    for (auto mode = first_of_box; mode != found.modes.end(); ++mode) text += line_of(*mode);
  }
  if (found.too_fast > 0)
    text += fmt::format(
        "  {} eigenvalues with |lambda| dt > 1 are left out: they are not modes of the "
        "simulation\n",
        found.too_fast);
  return text;
}

}  // namespace pennon::modes::global
