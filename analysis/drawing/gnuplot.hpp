/// Runs gnuplot, the program that draws every picture.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pennon::analysis {

/// The text as a string of gnuplot's script language, in single quotes, in which nothing is
/// substituted. Control characters, which could end the string's line, become blanks; so do bytes
/// that are not UTF-8. An apostrophe becomes the typographic one: gnuplot misreads its own way to
/// write one at the beginning of a string.
std::string quoted_text(std::string_view text);

/// Runs gnuplot without any shell on a script, which may hold inline binary data, and writes what
/// it draws to `picture`, whole or not at all. `ending` is what a whole picture of this format ends
/// with. Throws FileError with gnuplot's own words where it is missing or fails.
void run_gnuplot(std::string_view script, const std::filesystem::path& picture,
                 std::string_view ending);

}  // namespace pennon::analysis
