#include "lsa/curve.hpp"
#include "lsa/axis_attributes.hpp"

#include <fmt/format.h>

#include <limits>

#include "common/interrupt.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "lsa/outcome_points.hpp"
#include "lsa/quantity.hpp"

namespace pennon::lsa {

Curve compute(const CurveSettings& settings, const Point& point, const Theory& theory) {
  const std::vector<Axis> axes = varying(settings.sweeps);
  Curve curve{axes[0],
              along(settings.sweeps, axes[0]).scale,
              along(settings.sweeps, axes[0]).values(),
              std::nullopt,
              {},
              settings.quantity,
              settings.title,
              {}};
  if (axes.size() == 2) {
    curve.family_axis = axes[1];
    curve.family = along(settings.sweeps, axes[1]).values();
  } else {
    curve.family = {std::numeric_limits<double>::quiet_NaN()};
  }
  const Quantity& shown = quantity(settings.quantity);
  for (const double member : curve.family) {
    Point there = point;
    if (curve.family_axis) set(there, *curve.family_axis, member);
    std::vector<double> values;
    values.reserve(curve.x.size());
    for (const double x : curve.x) {
      set(there, curve.axis, x);
      values.push_back(shown.at(there, theory));
    }
    stop_if_interrupted("the curve was not written; run the same command again");
    curve.values.push_back(std::move(values));
  }
  return curve;
}

void write_csv(const Curve& curve, const std::filesystem::path& path) {
  std::vector<std::string> columns = {name(curve.axis)};
  for (const double member : curve.family)
    columns.push_back(curve.family_axis ? fmt::format("{} at {} = {}", curve.quantity,
                                                      name(*curve.family_axis), member)
                                        : curve.quantity);
  CsvText text(quantity(curve.quantity).meaning + ", along " + meaning(curve.axis), columns);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    std::vector<double> row = {curve.x[i]};
    for (const auto& values : curve.values) row.push_back(values[i]);
    text.row(row);
  }
  write_file(path, text.text());
}

void write_lines(const Curve& curve, hdf5::Writer& file) {
  const Quantity& shown = quantity(curve.quantity);
  file.write("/x", {curve.x.size()}, curve.x, attributes(curve.axis, curve.scale));
  std::vector<double> values;
  for (const auto& row : curve.values) values.insert(values.end(), row.begin(), row.end());
  file.write("/values", {curve.family.size(), curve.x.size()}, values,
             {{"name", shown.name}, {"meaning", shown.meaning}, {"symbol", shown.symbol}});
  if (curve.family_axis)
    file.write("/family", {curve.family.size()}, curve.family,
               {{"name", name(*curve.family_axis)},
                {"meaning", meaning(*curve.family_axis)},
                {"symbol", symbol(*curve.family_axis)}});
}

void write_hdf5(const Curve& curve, const std::vector<Outcome>& outcomes, bool cross_flow,
                const std::filesystem::path& path) {
  hdf5::Writer file(path);
  file.attributes({{"kind", "lsa_curve"}, {"title", curve.title}});
  write_lines(curve, file);
  write_outcome_points(file, outcomes, curve.axis, curve.quantity, cross_flow);
  file.finish();
}

}  // namespace pennon::lsa
