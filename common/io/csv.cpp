#include "common/io/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string_view>

#include "common/errors.hpp"

namespace pennon {
namespace {

std::string trimmed(std::string_view cell) {
  constexpr std::string_view blank = " \t\r";
  const std::size_t begin = cell.find_first_not_of(blank);
  if (begin == std::string_view::npos) return {};
  return std::string(cell.substr(begin, cell.find_last_not_of(blank) - begin + 1));
}

// The text of a quoted cell that begins with the quote at `at`, which moves behind its last one;
// none where it is not closed.
std::optional<std::string> quoted(std::string_view line, std::size_t& at) {
  std::string text;
  for (++at; at < line.size(); ++at) {
    if (line[at] != '"') {
      text += line[at];
    } else if (at + 1 < line.size() && line[at + 1] == '"') {
      text += '"';
      ++at;
    } else {
      ++at;
      return text;
    }
  }
  return std::nullopt;
}

// None where a quote is not closed, or something stands between it and the next comma.
std::optional<std::vector<std::string>> cells_of(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    std::size_t at = std::min(line.find_first_not_of(" \t", begin), line.size());
    if (at < line.size() && line[at] == '"') {
      const std::optional<std::string> text = quoted(line, at);
      const std::size_t comma = std::min(line.find(',', at), line.size());
      if (!text || !trimmed(line.substr(at, comma - at)).empty()) return std::nullopt;
      cells.push_back(*text);
      begin = comma + 1;
      continue;
    }
    const std::size_t comma = std::min(line.find(',', begin), line.size());
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    begin = comma + 1;
  }
  return cells;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file.string()) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(file_, "there is no such file");
  std::ifstream stream(file);
  if (!stream) throw InputError(file_, "cannot be read");
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    if (trimmed(line).empty() || line.front() == '#') continue;
    const std::string place = fmt::format("{}:{}", file_, number);
    std::optional<std::vector<std::string>> cells = cells_of(line);
    if (!cells) throw InputError(place, "has a quoted cell that does not end at its second quote");
    if (names_.empty()) {
      names_ = std::move(*cells);
      for (std::size_t k = 0; k < names_.size(); ++k)
        if (std::find(names_.begin(), names_.begin() + static_cast<std::ptrdiff_t>(k), names_[k]) !=
            names_.begin() + static_cast<std::ptrdiff_t>(k))
          throw InputError(place, fmt::format("names the column {} twice", names_[k]));
    } else if (cells->size() == names_.size()) {
      rows_.push_back({number, std::move(*cells)});
    } else {
      throw InputError(place, fmt::format("has {} cells, but the header names {} columns",
                                          cells->size(), names_.size()));
    }
  }
  if (names_.empty()) throw InputError(file_, "is empty: a table begins with its column names");
}

void CsvTable::expect_only(const std::vector<std::string>& columns) const {
  std::vector<std::string> unknown;
  for (const std::string& name : names_)
    if (std::ranges::find(columns, name) == columns.end()) unknown.push_back(name);
  if (!unknown.empty())
    throw InputError(file_, fmt::format("has columns that are not known here: {}; it must have {}",
                                        fmt::join(unknown, ", "), fmt::join(columns, ", ")));
}

void CsvTable::expect_each_once(const std::vector<std::string>& columns,
                                const std::string& meaning) const {
  std::map<std::vector<double>, std::size_t> seen;
  for (std::size_t row = 0; row < rows(); ++row) {
    std::vector<double> numbers;
    numbers.reserve(columns.size());
    for (const std::string& name : columns)
      numbers.push_back(number(row, column(name)).value_or(0));
    const auto [first, is_new] = seen.emplace(std::move(numbers), row);
    if (!is_new)
      throw InputError(place(row), fmt::format("repeats {} of line {}; each stands once", meaning,
                                               rows_[first->second].line));
  }
}

bool CsvTable::has(const std::string& name) const {
  return std::ranges::find(names_, name) != names_.end();
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end())
    throw InputError(
        file_, fmt::format("has no column {}; its columns are {}", name, fmt::join(names_, ", ")));
  return static_cast<std::size_t>(found - names_.begin());
}

std::optional<double> CsvTable::number(std::size_t row, std::size_t column) const {
  const std::string& cell = text(row, column);
  if (cell.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    throw InputError(
        place(row), fmt::format("{} must be a finite number, but is \"{}\"", names_[column], cell));
  return value;
}

std::vector<double> CsvTable::numbers(const std::string& name) const {
  const std::size_t named = column(name);
  std::vector<double> found;
  for (std::size_t row = 0; row < rows(); ++row)
    found.push_back(number(row, named).value_or(std::numeric_limits<double>::quiet_NaN()));
  return found;
}

std::string CsvTable::place(std::size_t row) const {
  return fmt::format("{}:{}", file_, rows_[row].line);
}

CsvText::CsvText(const std::string& comment, const std::vector<std::string>& columns)
    : columns_(columns.size()),
      text_(fmt::format("# {}\n{}\n", comment, fmt::join(columns, ","))) {}

void CsvText::row(const std::vector<double>& numbers, const std::vector<std::string>& words_first) {
  assert(numbers.size() + words_first.size() == columns_);
  std::vector<std::string> cells = words_first;
  for (const double value : numbers)
    cells.push_back(std::isnan(value) ? "" : fmt::format("{}", value));
  text_ += fmt::format("{}\n", fmt::join(cells, ","));
}

}  // namespace pennon
