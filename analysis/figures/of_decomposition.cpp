#include "analysis/figures/of_decomposition.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/result_parts.hpp"

namespace pennon::analysis {
namespace {

constexpr std::size_t lines_drawn = 4, first_modes = 3;

Figure figure_of_energies(const hdf5::Reader& file) {
  constexpr double least = 1e-17;  // of the variance: below is roundoff
  const std::vector<double> energy = file.list("/energy");
  double variance = 0;
  for (const double each : energy) variance += each;
  Figure figure;
  figure.x.label = "mode";
  figure.y = {"share of the variance", true, {}, {}};
  Marks marks{{}, {}, "", Marker::circle, true, 1};
  for (std::size_t j = 0; j < energy.size(); ++j) {
    if (!(energy[j] > least * variance)) break;
    marks.x.push_back(static_cast<double>(j + 1));
    marks.y.push_back(energy[j] / variance);
  }
  figure.lines.push_back({marks.x, marks.y, "", Stroke::solid, 1, 1});
  figure.marks.push_back(std::move(marks));
  return figure;
}

Figure figure_of_eigenvalues(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "angular frequency {/:Italic ω}";
  figure.y.label = "growth rate";
  const std::vector<double> growth = file.list("/growth"),
                            omega = file.list("/omega", growth.size()),
                            growth_error = file.list("/growth_error", growth.size()),
                            omega_error = file.list("/omega_error", growth.size());
  // Of real data the two modes of a pair are one oscillation.
  const bool is_real = file.text("/", "numbers") == "real";
  Marks marks{{}, {}, "", Marker::circle, true, 1};
  for (std::size_t j = 0; j < growth.size(); ++j) {
    constexpr double rounding = 1e-9;
    if (is_real && omega[j] < -rounding) continue;
    marks.x.push_back(omega[j]);
    marks.y.push_back(growth[j]);
    figure.lines.push_back({{omega[j], omega[j]},
                            {growth[j] - growth_error[j], growth[j] + growth_error[j]},
                            "",
                            Stroke::solid,
                            1,
                            1});
    figure.lines.push_back({{omega[j] - omega_error[j], omega[j] + omega_error[j]},
                            {growth[j], growth[j]},
                            "",
                            Stroke::solid,
                            1,
                            1});
  }
  figure.marks.push_back(std::move(marks));
  return figure;
}

Figure figure_of_spectra(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "frequency";
  figure.y = {"energy", true, {}, {}};
  const std::vector<double> f = file.list("/f");
  const hdf5::Array energy = file.read("/energy", {f.size(), hdf5::any}),
                    interval = file.read("/interval", {f.size(), 2});
  const std::vector<double> first = column_of(energy, 0);
  for (const std::size_t side : {0U, 1U}) {
    Line bound{
        f, column_of(interval, side), side == 0 ? "95 % of the first" : "", Stroke::dotted, 1, 1};
    for (std::size_t k = 0; k < f.size(); ++k) bound.y[k] *= first[k];
    figure.lines.push_back(std::move(bound));
  }
  for (std::size_t j = 0; j < std::min<std::size_t>(energy.shape[1], lines_drawn); ++j)
    figure.lines.push_back({f, column_of(energy, j), fmt::format("mode {}", j + 1),
                            static_cast<Stroke>(j % 4), static_cast<int>(j + 1)});
  return figure;
}

Figure figure_of_wave_amplitudes(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "waves along the span, {/:Italic n}";
  figure.y.label = "amplitude / {/:Italic L}";
  figure.y.low = 0;
  const std::vector<double> along = file.list("/along"),
                            against = file.list("/against", along.size());
  std::vector<double> n;
  for (std::size_t k = 0; k < along.size(); ++k) n.push_back(static_cast<double>(k));
  figure.marks.push_back({n, along, "along +{/:Italic x}", Marker::circle, true, 1});
  figure.marks.push_back({n, against, "along −{/:Italic x}", Marker::square, false, 2});
  figure.x.low = -0.5;
  figure.x.high = n.back() + 0.5;
  return figure;
}

// Lines over time: coefficients, or the moduli of waves.
Figure figure_over_time(const hdf5::Reader& file, const std::string& array, const char* label,
                        const char* each) {
  Figure figure;
  figure.x.label = "time";
  figure.y.label = label;
  const std::vector<double> t = file.list("/t");
  const bool is_complex = file.contains(array + "_real");
  const hdf5::Array real = file.read(is_complex ? array + "_real" : array, {hdf5::any, t.size()});
  const hdf5::Array imaginary = is_complex ? file.read(array + "_imag", real.shape) : hdf5::Array{};
  const std::size_t begin = array == "/zeta" ? 0 : 1;
  for (std::size_t j = 0; j < std::min<std::size_t>(real.shape[0], lines_drawn); ++j) {
    std::vector<double> values = row_of(real, j);
    if (is_complex) {
      const std::vector<double> other = row_of(imaginary, j);
      for (std::size_t m = 0; m < values.size(); ++m) values[m] = std::hypot(values[m], other[m]);
    }
    figure.lines.push_back({t, std::move(values), fmt::format("{} {}", each, j + begin),
                            Stroke::solid, static_cast<int>(j + 1)});
  }
  return figure;
}

// Amplitudes of given modes, and what they leave, on a logarithmic axis.
Figure figure_of_amplitudes(const hdf5::Reader& file) {
  Figure figure = figure_over_time(file, "/coefficients", "|{/:Italic a}|", "mode");
  figure.y.is_log = true;
  return figure;
}

struct Places {
  std::vector<double> x, y;  // x is empty without a span
};

// Where the modes' values lie, if that is a chord or a flag.
std::optional<Places> places_of(const hdf5::Reader& file) {
  if (!file.contains("/coordinates")) return std::nullopt;
  const hdf5::Array coordinates = file.read("/coordinates", {hdf5::any, hdf5::any});
  if (coordinates.shape[1] == 1) return Places{{}, coordinates.values};
  if (coordinates.shape[1] != 2 || file.number("/", "stations", 0) == 0) return std::nullopt;
  const auto stations = static_cast<std::size_t>(file.counted("/", "stations"));
  if (stations == 0 || coordinates.shape[0] % stations != 0)
    file.fail(fmt::format("has {} points for {} stations", coordinates.shape[0], stations));
  const std::size_t of_station = coordinates.shape[0] / stations;
  Places places;
  for (std::size_t i = 0; i < stations; ++i)
    places.x.push_back(coordinates.values[2 * i * of_station]);
  for (std::size_t j = 0; j < of_station; ++j) places.y.push_back(coordinates.values[2 * j + 1]);
  return places;
}

// One mode along the chord.
Figure along_chord(const std::vector<double>& y, const std::vector<double>& real,
                   const std::vector<double>& imaginary) {
  Figure figure;
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "mode";
  figure.lines.push_back({y, real, imaginary.empty() ? "" : "real part", Stroke::solid, 1});
  if (imaginary.empty()) return figure;
  figure.lines.push_back({y, imaginary, "imaginary part", Stroke::dashed, 2});
  for (const double side : {1.0, -1.0}) {
    Line envelope{y, {}, side > 0 ? "modulus" : "", Stroke::solid, 6, 1};
    for (std::size_t k = 0; k < y.size(); ++k)
      envelope.y.push_back(side * std::hypot(real[k], imaginary[k]));
    figure.lines.push_back(std::move(envelope));
  }
  return figure;
}

// The first station stands again where the period ends.
Figure on_flag(const hdf5::Reader& file, const Places& places, std::vector<double> values) {
  Figure figure;
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "{/:Italic x}/{/:Italic L}";
  std::vector<double> x = places.x;
  const double span = file.number("/", "span", 0);
  if (span > x.back()) {
    x.push_back(span);
    values.insert(values.end(), values.begin(),
                  values.begin() + static_cast<std::ptrdiff_t>(places.y.size()));
  }
  figure.field = FigureField{places.y, std::move(x), std::move(values), "mode", true};
  figure.is_to_scale = true;
  return figure;
}

}  // namespace

Figure figure_of_decomposition(const hdf5::Reader& file) {
  const std::string method = file.text("/", "method");
  if (method == "pod") return figure_of_energies(file);
  if (method == "dmd") return figure_of_eigenvalues(file);
  if (method == "spod") return figure_of_spectra(file);
  if (method == "waves") return figure_of_wave_amplitudes(file);
  if (method == "normal_modes" || method == "global_modes") return figure_of_amplitudes(file);
  file.fail(fmt::format("is a decomposition by {}, which this pennon cannot draw",
                        method.empty() ? "no method" : method));
}

std::vector<NamedFigure> figures_of_modes(const hdf5::Reader& file) {
  std::vector<NamedFigure> figures;
  const std::string method = file.text("/", "method");
  if (method == "waves") {
    figures.push_back({"waves", figure_over_time(file, "/zeta", "|{/:Italic ζ_n}| / {/:Italic L}",
                                                 "{/:Italic n} =")});
    return figures;
  }
  if (method == "pod")
    figures.push_back(
        {"coefficients", figure_over_time(file, "/coefficients", "coefficient", "mode")});
  const std::optional<Places> places = places_of(file);
  if (!places) return figures;
  const bool is_complex = file.contains("/modes_real");
  if (!is_complex && !file.contains("/modes")) return figures;
  const std::size_t points = places->y.size() * std::max<std::size_t>(places->x.size(), 1);
  const hdf5::Shape expected = {hdf5::any, 1, points};
  const std::string array = is_complex ? "/modes_real" : "/modes";
  if (file.shape(array).size() != expected.size() || file.shape(array)[1] != 1) return figures;
  const hdf5::Array real = file.read(array, expected);
  const hdf5::Array imaginary = is_complex ? file.read("/modes_imag", real.shape) : hdf5::Array{};
  for (std::size_t j = 0; j < std::min<std::size_t>(real.shape[0], first_modes); ++j) {
    const std::vector<double> other = is_complex ? row_of(imaginary, j) : std::vector<double>();
    figures.push_back({fmt::format("mode_{}", j + 1),
                       places->x.empty() ? along_chord(places->y, row_of(real, j), other)
                                         : on_flag(file, *places, row_of(real, j))});
  }
  return figures;
}

}  // namespace pennon::analysis
