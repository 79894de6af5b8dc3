#include "analysis/figures/of_global_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/drawing/plane_section.hpp"
#include "analysis/figures/result_parts.hpp"
#include "common/shape_phases.hpp"

namespace pennon::analysis {
namespace {

constexpr std::size_t most_modes_drawn = 3;
constexpr PlaneWindow flag_and_wake{-0.25, 2.75, -0.9, 0.9};
constexpr PlaneWindow about_flag{-0.15, 1.35, -0.45, 0.45};

std::string title_of(const hdf5::Reader& file, std::size_t mode) {
  const std::vector<double> all = file.list("/growth");
  const double growth = all[mode - 1], omega = file.list("/omega", all.size())[mode - 1];
  return fmt::format("mode {}: λL/V = {}{:.4g} {} {:.4g} i", mode, growth < 0 ? "−" : "",
                     std::abs(growth), omega < 0 ? "−" : "+", std::abs(omega));
}

// The flag at the phases between the envelopes of its motion.
Figure shapes_of(const hdf5::Reader& file, std::size_t mode) {
  constexpr std::array<Stroke, shape_phases.size()> strokes = {Stroke::solid, Stroke::dashed,
                                                               Stroke::dash_dotted, Stroke::dotted};
  Figure figure;
  figure.title = title_of(file, mode);
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "{/:Italic ζ}/max |{/:Italic ζ}|";
  figure.y.low = -1.1;
  figure.y.high = 1.1;
  const std::string group = fmt::format("/mode_{}/", mode);
  const std::vector<double> y = file.list("/y"), real = file.list(group + "zeta_real", y.size()),
                            imaginary = file.list(group + "zeta_imag", y.size());
  const hdf5::Array shapes = file.read(group + "shapes", {shape_phases.size(), y.size()});
  constexpr int light = 6;
  for (const double side : {1.0, -1.0}) {
    Line envelope{y, {}, "", Stroke::solid, light, 1};
    envelope.y.reserve(y.size());
    for (std::size_t k = 0; k < y.size(); ++k)
      envelope.y.push_back(side * std::hypot(real[k], imaginary[k]));
    figure.lines.push_back(std::move(envelope));
  }
  figure.lines.back().label = "envelope";
  for (std::size_t k = 0; k < shape_phases.size(); ++k) {
    const auto begin = shapes.values.begin() + static_cast<std::ptrdiff_t>(k * y.size());
    figure.lines.push_back({y,
                            {begin, begin + static_cast<std::ptrdiff_t>(y.size())},
                            fmt::format("{}°", shape_phases[k]),
                            strokes[k],
                            static_cast<int>(k)});
  }
  return figure;
}

Figure section_of(const hdf5::Reader& file, std::size_t mode, const std::string& array,
                  const PlaneWindow& window, const char* label, bool is_diverging) {
  const auto [points, values] = section_arrays(file, fmt::format("/mode_{}/{}", mode, array));
  FigureField field = plane_section(points, values, window);
  field.label = label;
  field.is_diverging = is_diverging;
  constexpr double share_of_vorticity = 0.97, share_of_wavemaker = 0.99;
  clip_to_most(field, is_diverging ? share_of_vorticity : share_of_wavemaker);
  Figure figure = figure_of_section(std::move(field), points, values.shape.back(), window);
  figure.title = title_of(file, mode);
  figure.is_to_scale = true;
  return figure;
}

Figure along_flag(const hdf5::Reader& file, std::size_t mode) {
  Figure figure;
  figure.title = title_of(file, mode);
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label =
      "wavemaker on the flag, {/:Italic L} |{/:Italic p_f}| |∂{/:Italic ζ}/∂{/:Italic t}|";
  figure.y.low = 0;
  const std::vector<double> y = file.list("/y");
  figure.lines.push_back(
      {y, file.list(fmt::format("/mode_{}/flag_wavemaker", mode), y.size()), "", Stroke::solid, 1});
  return figure;
}

}  // namespace

Figure figure_of_spectrum(const hdf5::Reader& file) {
  Figure figure;
  figure.title = fmt::format("Global modes, Re = {:.6g}", file.number("/", "Re", 0));
  if (const double k_x = file.number("/", "k_x", 0); k_x != 0)
    figure.title += fmt::format(", k_x L = {:.4g}", k_x);
  figure.x.label = "angular frequency Im {/:Italic λL}/{/:Italic V}";
  figure.y.label = "growth rate Re {/:Italic λL}/{/:Italic V}";
  const std::vector<double> growth = file.list("/growth"),
                            omega = file.list("/omega", growth.size());
  constexpr int blue = 1, vermilion = 2;
  Marks grows{{}, {}, "grows", Marker::circle, true, vermilion},
      decays{{}, {}, "decays", Marker::circle, false, blue};
  for (std::size_t k = 0; k < growth.size(); ++k) {
    Marks& marks = growth[k] > 0 ? grows : decays;
    marks.x.push_back(omega[k]);
    marks.y.push_back(growth[k]);
  }
  for (Marks* marks : {&grows, &decays})
    if (!marks->x.empty()) figure.marks.push_back(std::move(*marks));
  const auto [low, high] = std::ranges::minmax(omega);
  const double margin = std::max(0.1 * (high - low), 0.5);
  figure.x.low = low - margin;
  figure.x.high = high + margin;
  figure.lines.push_back({{*figure.x.low, *figure.x.high}, {0, 0}, "", Stroke::dashed, 0, 0.8});
  return figure;
}

std::vector<NamedFigure> figures_of_global_modes(const hdf5::Reader& file) {
  std::vector<NamedFigure> figures;
  const std::size_t count =
      std::min<std::size_t>(file.shape("/growth", {hdf5::any})[0], most_modes_drawn);
  for (std::size_t mode = 1; mode <= count; ++mode) {
    const std::string name = fmt::format("mode_{}_", mode);
    figures.push_back({name + "shape", shapes_of(file, mode)});
    figures.push_back({name + "vorticity", section_of(file, mode, "fixed_omega_x_real",
                                                      flag_and_wake, "Re {/:Italic ω_x'}", true)});
    if (!file.contains(fmt::format("/mode_{}/wavemaker", mode))) continue;
    figures.push_back(
        {name + "wavemaker", section_of(file, mode, "wavemaker", about_flag,
                                        "|{/:Bold p}| |{/:Bold v}'|, in 1/{/:Italic L}²", false)});
    figures.push_back({name + "flag_wavemaker", along_flag(file, mode)});
  }
  return figures;
}

}  // namespace pennon::analysis
