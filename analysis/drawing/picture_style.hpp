/// What all pictures share: their size, and the colours of values.
#pragma once

#include <string>
#include <string_view>

namespace pennon::analysis {

/// Chooses a PNG of the common size as gnuplot's output.
std::string png_terminal();
/// What a whole PNG ends with.
inline constexpr std::string_view png_ending = "IEND\xae\x42\x60\x82";
/// Chooses an SVG of the same size.
std::string svg_terminal();
inline constexpr std::string_view svg_ending = "</svg>\n\n";

/// Colours from dark to light, for values; `bands`: steps of colour, 0 for a continuous range.
std::string sequential_palette(int bands);
/// Colours centred on zero.
std::string diverging_palette();

}  // namespace pennon::analysis
