/// Runs gnuplot, the program that draws every picture.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pennon::analysis {

/// The text as a string of gnuplot's script language, in single quotes, in which nothing is
/// substituted. Control characters, which could end the string's line, become blanks; so do bytes
/// that are not UTF-8. An apostrophe becomes the typographic one: gnuplot misreads its own way to
/// write one at the beginning of a string.
std::string quoted_text(std::string_view text);

/// A plot command and the numbers that it draws. They never stand in the script: where a command
/// fails, gnuplot would read what follows it as commands.
class PlotItems {
 public:
  /// "plot" or "splot".
  explicit PlotItems(std::string_view command) : command_(command) {}

  /// Adds an item of these numbers; `how` is what follows their name in the command, from `record`
  /// or `array` on. What is not finite becomes NaN, which gnuplot leaves out.
  void add(std::string_view how, const std::vector<double>& numbers);
  /// The command; one that draws nothing where there is no item.
  std::string command() const;
  std::string_view bytes() const { return bytes_; }

 private:
  std::string command_, items_, bytes_;
};

/// Runs gnuplot without any shell and without anybody's settings on a script, which ends with the
/// command of the items, and writes what it draws to `picture`, whole or not at all. `ending` is
/// what a whole picture of this format ends with. Throws FileError with gnuplot's own words where
/// it is missing or fails.
void run_gnuplot(std::string_view script, const PlotItems& items,
                 const std::filesystem::path& picture, std::string_view ending);

}  // namespace pennon::analysis
