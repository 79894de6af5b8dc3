/// What a case asks of the local stability analysis: the tables [lsa], [lsa.minami], [lsa.curve],
/// [lsa.map], [lsa.most_unstable], [lsa.marks] and [lsa.verdicts].
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "common/case/sweep.hpp"
#include "lsa/axes.hpp"
#include "lsa/evaluate.hpp"

namespace pennon::lsa {

/// For each axis its sweep, where it varies.
using Sweeps = std::array<std::optional<Sweep>, axis_count>;

struct CurveSettings {
  bool is_given = false;
  Sweeps sweeps;  ///< one range; a second axis, given as a list, makes a family of curves
  std::string quantity = "mu_cr";
  std::string title;
};

struct MapSettings {
  bool is_given = false;
  Sweeps sweeps;  ///< of exactly two axes
  std::vector<std::string> fields = {"growth", "frequency", "P", "mu_cr"};
  std::string quantity = "growth";  ///< the field the picture shows
  bool neutral = true;              ///< trace the neutral curve P = 0
  std::string title;
};

struct MostUnstableSettings {
  bool is_given = false;
  std::optional<Sweep> k_x, k_y;  ///< exactly one: where the largest growth is sought
};

/// Published outcomes drawn over a curve or map.
struct MarksSettings {
  bool is_given = false;
  std::string table;
};

/// The k_y for which the verdicts of a table of outcomes are reproduced.
struct VerdictsSettings {
  bool is_given = false;
  std::string table;
  std::optional<Sweep> k_y;
};

struct Settings {
  bool is_given = false;
  Theory theory;
  double k_y = std::numbers::pi;
  std::optional<double> k_x;  ///< none: 2 pi/gamma, or 0 in two dimensions
  CurveSettings curve;
  MapSettings map;
  MostUnstableSettings most_unstable;
  MarksSettings marks;
  VerdictsSettings verdicts;
};

void declare(Schema&, Settings&);

/// The faults between keys: contradictions, a curve or map without its axes, too many points.
void check(const Settings&, const FlagParameters&, const FlowParameters&, Faults&);

/// The point that the case itself describes.
Point point_of(const FlagParameters&, const FlowParameters&, const Settings&);

/// The sweep along an axis that varies.
inline const Sweep& along(const Sweeps& sweeps, Axis axis) {
  return *sweeps[static_cast<std::size_t>(axis)];
}

/// The axes that vary, those with a range before those with a list: at most two for a valid case.
std::vector<Axis> varying(const Sweeps&);

}  // namespace pennon::lsa
