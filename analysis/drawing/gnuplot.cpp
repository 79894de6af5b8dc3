#include "analysis/drawing/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/process/process.hpp"
#include "common/utf8.hpp"

namespace pennon::analysis {
namespace {

bool file_ends_with(const std::filesystem::path& file, std::string_view ending) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() < static_cast<std::streamoff>(ending.size())) return false;
  stream.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
  std::string last(ending.size(), '\0');
  stream.read(last.data(), static_cast<std::streamsize>(last.size()));
  return last == ending;
}

}  // namespace

std::string quoted_text(std::string_view text) {
  constexpr std::size_t longest = 400;  // bytes; a picture has no room for more
  std::string result = "'";
  while (!text.empty()) {
    if (result.size() > longest) {
      result += "...";
      break;
    }
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = utf8_length(text);
    if (length == 0 || first < 0x20 || first == 0x7f)
      result += ' ';
    else if (first == '\'')
      result += "\u2019";
    else
      result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result + "'";
}

void PlotItems::add(std::string_view how, const std::vector<double>& numbers) {
  items_ += fmt::format("{} '{}' binary skip={} {}", items_.empty() ? "" : ",", data_file,
                        bytes_.size(), how);
  for (const double number : numbers) {
    const double drawn = std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN();
    bytes_.append(reinterpret_cast<const char*>(&drawn), sizeof drawn);
  }
}

std::string PlotItems::command() const {
  return command_ + (items_.empty() ? " NaN notitle" : items_) + '\n';
}

void run_gnuplot(std::string_view script, const PlotItems& items,
                 const std::filesystem::path& picture, std::string_view ending) {
  AtomicFile file(picture);
  const std::optional<std::filesystem::path> gnuplot = find_program("gnuplot");
  if (!gnuplot)
    throw FileError("gnuplot, which draws the pictures, was not found: install gnuplot-nox");
  // -d: without the user's ~/.gnuplot. That and the variables could change any picture.
  const ChildEnd end =
      run_program({.program = *gnuplot,
                   .arguments = {"-d"},
                   .input = script,
                   .output = file.temporary(),
                   .data = items.bytes(),
                   .unset = {"GNUTERM", "GNUPLOT_LIB", "GNUPLOT_FONTPATH", "GNUPLOT_PS_DIR"}});
  if (!end.is_success() || !file_ends_with(file.temporary(), ending))
    throw FileError(fmt::format("gnuplot could not draw {}: {}", picture.string(),
                                end.messages.empty() ? "the picture is not whole" : end.messages));
  file.finish();
}

}  // namespace pennon::analysis
