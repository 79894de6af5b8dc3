#include "analysis/figures/of_modes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pennon::analysis {
namespace {

constexpr std::size_t most_normal_modes_drawn = 9;

// A number of a mode as it was counted; 0 for what is none.
int whole(double number) {
  constexpr double most = 1e6;
  return number >= 0 && number < most ? static_cast<int>(number) : 0;
}

}  // namespace

Figure figure_of_normal_modes(const hdf5::Reader& file) {
  Figure figure;
  figure.title = "Normal modes, " + file.text("/", "family");
  std::ranges::replace(figure.title, '_', ' ');
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "{/:Italic Y_{nm}}";
  const std::vector<double> y = file.list("/y"), n = file.list("/n"), m = file.list("/m", n.size()),
                            omega = file.list("/omega", n.size());
  const hdf5::Array shapes = file.read("/shapes", {n.size(), y.size()});
  for (std::size_t i = 0; i < std::min<std::size_t>(n.size(), most_normal_modes_drawn); ++i) {
    const auto begin = shapes.values.begin() + static_cast<std::ptrdiff_t>(i * y.size());
    figure.lines.push_back(
        {y,
         {begin, begin + static_cast<std::ptrdiff_t>(y.size())},
         fmt::format("{{/:Italic n}} = {:.0f}, {{/:Italic m}} = {:.0f}: {{/:Italic ω}} = {:.4g}",
                     n[i], m[i], omega[i]),
         static_cast<Stroke>(whole(n[i]) % 4),
         whole(m[i])});
  }
  return figure;
}

}  // namespace pennon::analysis
