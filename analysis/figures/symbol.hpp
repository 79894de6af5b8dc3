/// Labels of pictures from the plain symbols that results carry.
///
/// A result file says of each array what it is called ("ω_i"), not how that is printed; how a
/// symbol is printed is decided here, for all pictures.
#pragma once

#include <string>
#include <string_view>

#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// A plain symbol as gnuplot's enhanced text (figure.hpp), with variables in italics.
///
/// Letters that follow one another are one variable, and so are variables with a space between
/// them, a product: "k_x L". After `_` comes an index: a single letter is itself a variable and in
/// italics ("ω_i"), a longer index is a word and upright ("μ_cr"). After `^` comes an upright
/// exponent: letters, digits and signs ("ω_r^2D", "ω_r^+"). A hyphen becomes a minus sign; all else
/// stays as it is.
std::string symbol_text(std::string_view symbol);

/// The label of an array: its attribute "quantity", where it has one, and its "symbol" as
/// symbol_text(). Files of older versions carry the text itself as "label", which is taken as it
/// is.
std::string label_of(const hdf5::Reader&, const std::string& array);

}  // namespace pennon::analysis
