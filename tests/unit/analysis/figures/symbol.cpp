/// Symbols of results as the text of a picture.
#include "analysis/figures/symbol.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace pennon::analysis {
namespace {

using test::TemporaryFolder;

TEST(SymbolText, HasVariablesInItalics) {
  EXPECT_EQ(symbol_text("P"), "{/:Italic P}");
  EXPECT_EQ(symbol_text("Re"), "{/:Italic Re}");
  EXPECT_EQ(symbol_text("γ"), "{/:Italic γ}");
  EXPECT_EQ(symbol_text("U/V"), "{/:Italic U}/{/:Italic V}");
  EXPECT_EQ(symbol_text("-P"), "−{/:Italic P}");
  EXPECT_EQ(symbol_text(""), "");
}

TEST(SymbolText, HasAnIndexOfOneLetterInItalicsAndAWordUpright) {
  EXPECT_EQ(symbol_text("ν_s"), "{/:Italic ν_s}");
  EXPECT_EQ(symbol_text("K_θ"), "{/:Italic K_θ}");
  EXPECT_EQ(symbol_text("k_x L"), "{/:Italic k_x L}");
  EXPECT_EQ(symbol_text("μ_cr"), "{/:Italic μ}_{cr}");
}

TEST(SymbolText, HasExponentsUpright) {
  EXPECT_EQ(symbol_text("ω_r^+"), "{/:Italic ω_r}^+");
  EXPECT_EQ(symbol_text("ω_i^-"), "{/:Italic ω_i}^−");
  EXPECT_EQ(symbol_text("ω_r / ω_r^2D"), "{/:Italic ω_r} / {/:Italic ω_r}^{2D}");
}

TEST(LabelOf, AnArrayIsItsQuantityAndItsSymbol) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "result.h5");
  file.write("/x", {1}, std::vector<double>{1}, {{"symbol", "k_x L"}});
  file.write("/y", {1}, std::vector<double>{1}, {{"quantity", "growth rate"}, {"symbol", "σL/V"}});
  file.finish();
  const hdf5::Reader reader(folder / "result.h5");
  EXPECT_EQ(label_of(reader, "/x"), "{/:Italic k_x L}");
  EXPECT_EQ(label_of(reader, "/y"), "growth rate {/:Italic σL}/{/:Italic V}");
}

TEST(LabelOf, AnArrayOfAnOlderFileIsTheTextThatTheFileCarries) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "result.h5");
  file.write("/x", {1}, std::vector<double>{1}, {{"label", "{/:Italic μ}_{cr} of 1996"}});
  file.finish();
  EXPECT_EQ(label_of(hdf5::Reader(folder / "result.h5"), "/x"), "{/:Italic μ}_{cr} of 1996");
}

}  // namespace
}  // namespace pennon::analysis
