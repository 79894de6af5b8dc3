#include "lsa/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "lsa/quantity.hpp"

namespace pennon::lsa {
namespace {

constexpr std::int64_t most_points_on_an_axis = 10'000'000;
constexpr double most_points_of_a_map = 1e10;
constexpr std::int64_t most_curves = 64;

void declare_sweeps(Table& table, Sweeps& sweeps, const std::string& what) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Axis axis = static_cast<Axis>(i);
    table.key({name(axis), &sweeps[i], what + meaning(axis), range(axis)});
  }
}

void declare_curve(Schema& schema, CurveSettings& curve) {
  Table& table =
      schema.table("lsa.curve",
                   "A quantity along one parameter, given as a range; a second parameter, "
                   "given as a list, makes a family of curves.",
                   &curve.is_given);
  table.key({"quantity", &curve.quantity, "what is drawn", any_sign, false, {}, curve_quantities()})
      .key({"title", &curve.title, "of the picture"});
  declare_sweeps(table, curve.sweeps, "along the curve: ");
}

void declare_map(Schema& schema, MapSettings& map) {
  Table& table =
      schema.table("lsa.map",
                   "Fields over two parameters, each a range, with the neutral curve. mu "
                   "lies along the ordinate; else the first given of Re, k_x, k_y, nu_s, "
                   "gamma, K_B, U lies along the abscissa.",
                   &map.is_given);
  table
      .key({"fields",
            &map.fields,
            "what is computed and kept",
            any_sign,
            false,
            {},
            map_quantities()})
      .key({"quantity",
            &map.quantity,
            "the field that the picture shows",
            any_sign,
            false,
            {},
            map_quantities()})
      .key({"neutral", &map.neutral, "trace the neutral curve P = 0"})
      .key({"title", &map.title, "of the picture"});
  declare_sweeps(table, map.sweeps, "over the map: ");
}

std::string dotted(const std::string& table, Axis axis) {
  return table + "." + name(axis);
}

void check_axes(const std::string& table, const Sweeps& sweeps, const Model& model,
                Faults& faults) {
  const auto given = [&](Axis axis) { return sweeps[static_cast<std::size_t>(axis)].has_value(); };
  if (given(Axis::gamma) && given(Axis::k_x))
    faults.about(
        dotted(table, Axis::gamma),
        fmt::format("{0}.gamma and {0}.k_x vary the same number, k_x = 2 pi/gamma; give one",
                    table));
  if (given(Axis::K_B) && !model.bending)
    faults.about(dotted(table, Axis::K_B),
                 table +
                     ".K_B changes nothing unless lsa.bending = true; the paper's local theory "
                     "has no bending");
  if (given(Axis::U) && !model.cross_flow)
    faults.about(dotted(table, Axis::U),
                 table +
                     ".U changes nothing unless lsa.cross_flow = true; the paper's local theory "
                     "has no cross-flow");
  for (std::size_t i = 0; i < axis_count; ++i)
    if (sweeps[i] && sweeps[i]->size() > most_points_on_an_axis)
      faults.about(dotted(table, static_cast<Axis>(i)),
                   fmt::format("{} has {} points; an axis has at most {}",
                               dotted(table, static_cast<Axis>(i)), sweeps[i]->size(),
                               most_points_on_an_axis));
}

// A picture needs its values in order.
void check_order(const std::string& table, Axis axis, const Sweep& sweep, Faults& faults) {
  if (!sweep.is_increasing())
    faults.about(
        dotted(table, axis),
        dotted(table, axis) + (sweep.list.empty()
                                   ? " has more points than there are numbers between its ends"
                                   : " must list its values in increasing order"));
}

std::string axes_text(const std::vector<Axis>& axes) {
  std::vector<std::string> names;
  names.reserve(axes.size());
  for (const Axis axis : axes) names.push_back(name(axis));
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

void check_curve(const Settings& settings, Faults& faults) {
  const CurveSettings& curve = settings.curve;
  if (!curve.is_given) return;
  const std::vector<Axis> axes = varying(curve.sweeps);
  const auto sweep = [&](std::size_t i) -> const Sweep& { return along(curve.sweeps, axes[i]); };
  const bool is_one = axes.size() == 1;
  const bool is_family = axes.size() == 2 && sweep(0).list.empty() && !sweep(1).list.empty();
  if (!is_one && !is_family)
    faults.about(
        "lsa.curve",
        fmt::format("lsa.curve needs one parameter as a range {{ from = a, to = b, points = "
                    "n }} and, for a family of curves, a second as a list; it has {}",
                    axes_text(axes)));
  if (is_one || is_family) check_order("lsa.curve", axes[0], sweep(0), faults);
  if (is_family && sweep(1).size() > most_curves)
    faults.about(dotted("lsa.curve", axes[1]),
                 fmt::format("{} lists {} values; a picture holds at most {} curves",
                             dotted("lsa.curve", axes[1]), sweep(1).size(), most_curves));
  check_axes("lsa.curve", curve.sweeps, settings.theory.model, faults);
}

void check_map(const Settings& settings, Faults& faults) {
  const MapSettings& map = settings.map;
  if (!map.is_given) return;
  const std::vector<Axis> axes = varying(map.sweeps);
  if (axes.size() != 2)
    faults.about("lsa.map",
                 fmt::format("lsa.map needs exactly two parameters as ranges or lists; it "
                             "has {} ({})",
                             axes.size(), axes_text(axes)));
  double points = 1;
  for (const Axis axis : axes) {
    const Sweep& sweep = along(map.sweeps, axis);
    check_order("lsa.map", axis, sweep, faults);
    points *= static_cast<double>(sweep.size());
  }
  if (points > most_points_of_a_map)
    faults.about("lsa.map", fmt::format("lsa.map has {:.3g} points; a map has at most {:.0e}",
                                        points, most_points_of_a_map));
  if (map.fields.empty())
    faults.about("lsa.map.fields", "lsa.map.fields is empty; a map keeps at least one field");
  else if (std::ranges::find(map.fields, map.quantity) == map.fields.end())
    faults.about("lsa.map.quantity",
                 fmt::format("lsa.map.quantity is {}, which lsa.map.fields lacks ({})",
                             map.quantity, fmt::join(map.fields, ", ")));
  for (std::size_t i = 0; i < map.fields.size(); ++i)
    if (std::find(map.fields.begin(), map.fields.begin() + static_cast<std::ptrdiff_t>(i),
                  map.fields[i]) != map.fields.begin() + static_cast<std::ptrdiff_t>(i))
      faults.about("lsa.map.fields", "lsa.map.fields names " + map.fields[i] + " twice");
  check_axes("lsa.map", map.sweeps, settings.theory.model, faults);
}

void check_most_unstable(const MostUnstableSettings& sought, Faults& faults) {
  if (!sought.is_given) return;
  if (sought.k_x.has_value() == sought.k_y.has_value())
    faults.about(
        "lsa.most_unstable",
        fmt::format("lsa.most_unstable needs k_x or k_y as a range, one of them; it has {}",
                    sought.k_x ? "both" : "neither"));
  for (const auto& [sweep, key] : {std::pair(&sought.k_x, "k_x"), std::pair(&sought.k_y, "k_y")})
    if (*sweep && !(*sweep)->list.empty())
      faults.about(
          std::string("lsa.most_unstable.") + key,
          fmt::format("lsa.most_unstable.{} must be a range {{ from = a, to = b, points = n "
                      "}}, but is a list",
                      key));
}

void check_verdicts(const VerdictsSettings& verdicts, Faults& faults) {
  if (!verdicts.is_given) return;
  if (!verdicts.k_y)
    faults.about(
        "lsa.verdicts",
        "lsa.verdicts.k_y is missing: the range of k_y that is searched, { from = a, to = b, "
        "points = n }");
  else if (!verdicts.k_y->list.empty())
    faults.about(
        "lsa.verdicts.k_y",
        "lsa.verdicts.k_y must be a range { from = a, to = b, points = n }, but is a list");
}

}  // namespace

void declare(Schema& schema, Settings& settings) {
  Model& model = settings.theory.model;
  schema.table("lsa", "Local linear stability (section 4).", &settings.is_given)
      .key({"k_y", &settings.k_y,
            "streamwise wavenumber; pi reproduces the verdicts of Table 1, see docs/theory",
            ranges::k_y})
      .key({"k_x", &settings.k_x, "spanwise wavenumber", ranges::k_x, false,
            "2 pi/gamma; 0 in two dimensions"})
      .key({"added_mass", choice(model.added_mass, {"two_d", "wu", "lamb", "minami"}),
            "the added-mass coefficient c_m (appendix B)"})
      .key({"form", choice(model.form, {"consistent", "as_printed"}),
            "as_printed keeps the misprints of (4.8b) to (4.11)"})
      .key({"bending", &model.bending, "adds K_B (k_x^2 + k_y^2)^2 to the restoring force"})
      .key({"cross_flow", &model.cross_flow, "travelling wave in a stream with the cross-flow U"})
      .key({"tension_coefficient", &model.tension_coefficient,
            "tension at the leading edge times Re^1/2, in rho_f V^2 L", not_negative})
      .key({"tension_at", &model.tension_at, "y of the section whose tension is taken", Range{0, 1},
            false, "where it is largest"});
  schema.table("lsa.minami", "The mode and pressure of the added mass minami (B 4).")
      .key({"mode",
            choice(settings.theory.minami.mode, {"plunge", "pitch", "sine", "hanging_chain"}),
            "chordwise shape: 1; y; sin(k_y y); J_0(j_01 (1-y)^1/2)"})
      .key({"pressure", choice(settings.theory.minami.pressure, {"sheet", "plate"}),
            "of an unbounded sheet, or of potential flow around the chord"});
  declare_curve(schema, settings.curve);
  declare_map(schema, settings.map);
  schema
      .table("lsa.most_unstable",
             "The wavenumber of the largest growth: k_x or k_y, given as a range that is sampled "
             "and then refined.",
             &settings.most_unstable.is_given)
      .key({"k_x", &settings.most_unstable.k_x, "searched spanwise wavenumbers", ranges::k_x})
      .key({"k_y", &settings.most_unstable.k_y, "searched streamwise wavenumbers", ranges::k_y});
  schema
      .table("lsa.marks", "Published outcomes drawn over the curve or map.",
             &settings.marks.is_given)
      .key({"table", &settings.marks.table,
            "CSV file with columns case, mu, gamma, U_over_V, lsa; a path from the case file's "
            "folder",
            any_sign, true});
  schema
      .table("lsa.verdicts",
             "The k_y for which the verdicts of a table (column lsa: S or U) are reproduced.",
             &settings.verdicts.is_given)
      .key({"table", &settings.verdicts.table,
            "CSV file with columns case, mu, gamma, U_over_V, lsa; a path from the case file's "
            "folder",
            any_sign, true})
      .key({"k_y", &settings.verdicts.k_y, "searched streamwise wavenumbers", ranges::k_y});
}

void check(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
           Faults& faults) {
  if (settings.k_x && flag.gamma)
    faults.about("lsa.k_x",
                 fmt::format("lsa.k_x = {} contradicts flag.gamma = {}, which makes k_x = 2 "
                             "pi/gamma; give one of the two",
                             *settings.k_x, *flag.gamma));
  if (settings.theory.model.cross_flow && flow.U != 0 && !flag.gamma && !settings.k_x &&
      varying(settings.map.sweeps).empty() && varying(settings.curve.sweeps).empty())
    faults.about(
        "lsa.cross_flow",
        "lsa.cross_flow = true changes nothing in two dimensions: it enters as U k_x; give "
        "flag.gamma or lsa.k_x");
  check_curve(settings, faults);
  check_map(settings, faults);
  check_most_unstable(settings.most_unstable, faults);
  check_verdicts(settings.verdicts, faults);
}

Point point_of(const FlagParameters& flag, const FlowParameters& flow, const Settings& settings) {
  const double from_span = flag.gamma ? 2 * std::numbers::pi / *flag.gamma : 0.0;
  return {flag.mu,  flow.Re, settings.k_x.value_or(from_span), settings.k_y, flag.nu_s,
          flag.K_B, flow.U};
}

std::vector<Axis> varying(const Sweeps& sweeps) {
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (sweeps[i]) axes.push_back(static_cast<Axis>(i));
  std::stable_partition(axes.begin(), axes.end(),
                        [&](Axis axis) { return along(sweeps, axis).list.empty(); });
  return axes;
}

}  // namespace pennon::lsa
