#include "analysis/drawing/picture_style.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <vector>

namespace pennon::analysis {
namespace {

// Equidistant samples of viridis (van der Walt & Smith 2015), and a blue-white-red in the manner of
// Moreland (2009), whose ends are equally light.
constexpr std::array<const char*, 11> sequential_map = {"#440154", "#482475", "#414487", "#355F8D",
                                                        "#2A788E", "#21918C", "#22A884", "#44BF70",
                                                        "#7AD151", "#BDDF26", "#FDE725"};
constexpr std::array<const char*, 9> diverging_map = {"#2A4BA0", "#4A73C3", "#7FA5DF",
                                                      "#B9D0EE", "#FFFFFF", "#F3C6B0",
                                                      "#E0917A", "#C5524F", "#9E1B2F"};

// Pixels of a picture as SVG, and how many more the PNG has each way.
constexpr int picture_width = 640;
constexpr int picture_height = 460;
constexpr int sharpness = 3;

template <std::size_t count>
std::string palette(const std::array<const char*, count>& colors, int bands) {
  std::vector<std::string> steps;
  steps.reserve(count);
  for (const char* color : colors) steps.push_back(fmt::format("{} '{}'", steps.size(), color));
  return fmt::format("set palette defined ({}) maxcolors {}\n", fmt::join(steps, ", "), bands);
}

}  // namespace

std::string png_terminal() {
  return fmt::format(
      "set terminal pngcairo enhanced size {0},{1} font 'DejaVu Sans,10' fontscale {2} linewidth "
      "{2} pointscale {2}\n",
      picture_width * sharpness, picture_height * sharpness, sharpness);
}

std::string svg_terminal() {
  return fmt::format("set terminal svg standalone enhanced size {},{} font 'DejaVu Sans,12'\n",
                     picture_width, picture_height);
}

std::string sequential_palette(int bands) {
  return palette(sequential_map, bands);
}

std::string diverging_palette() {
  return palette(diverging_map, 0);
}

}  // namespace pennon::analysis
