#include "analysis/figures/of_modes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pennon::analysis {
namespace {

constexpr std::size_t most_normal_modes_drawn = 9;

}  // namespace

Figure figure_of_normal_modes(const hdf5::Reader& file) {
  Figure figure;
  figure.title = "Normal modes, " + file.text("/", "family");
  std::ranges::replace(figure.title, '_', ' ');
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "{/:Italic Y_{nm}}";
  const std::vector<double> y = file.read("/y").values;
  const hdf5::Array shapes = file.read("/shapes");
  const std::vector<double> n = file.read("/n").values;
  const std::vector<double> m = file.read("/m").values;
  const std::vector<double> omega = file.read("/omega").values;
  for (std::size_t i = 0; i < std::min<std::size_t>(n.size(), most_normal_modes_drawn); ++i) {
    const auto begin = shapes.values.begin() + static_cast<std::ptrdiff_t>(i * y.size());
    figure.lines.push_back(
        {y,
         {begin, begin + static_cast<std::ptrdiff_t>(y.size())},
         fmt::format("{{/:Italic n}} = {:.0f}, {{/:Italic m}} = {:.0f}: {{/:Italic ω}} = {:.4g}",
                     n[i], m[i], omega[i]),
         static_cast<Stroke>(static_cast<int>(n[i]) % 4),
         static_cast<int>(m[i])});
  }
  return figure;
}

}  // namespace pennon::analysis
