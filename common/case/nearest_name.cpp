#include "common/case/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>
#include <vector>

namespace pennon {
namespace {

// Costs in half edits, so that a change of letter case or a lost underscore costs one half.
constexpr int edit = 2;
constexpr int slip = 1;

int removal_cost(char letter) {
  return letter == '_' ? slip : edit;
}

int replacement_cost(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? slip : edit;
}

// Edit distance with the costs above and swaps of neighbours (Damerau 1964; Wagner & Fischer 1974),
// row by row.
int distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j < b.size(); ++j) row[j + 1] = row[j] + removal_cost(b[j]);
  std::vector<int> above = row;
  std::vector<int> above_that;
  for (std::size_t i = 0; i < a.size(); ++i) {
    above_that = std::exchange(above, row);
    row[0] = above[0] + removal_cost(a[i]);
    for (std::size_t j = 0; j < b.size(); ++j) {
      row[j + 1] = std::min({above[j + 1] + removal_cost(a[i]), row[j] + removal_cost(b[j]),
                             above[j] + replacement_cost(a[i], b[j])});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j])
        row[j + 1] = std::min(row[j + 1], above_that[j - 1] + edit);
    }
  }
  return row.back();
}

constexpr std::size_t longest_name = 64;

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> known) {
  if (name.size() > longest_name) return {};
  std::string nearest;
  int least = std::numeric_limits<int>::max();
  for (const std::string& candidate : known) {
    const int d = distance(name, candidate);
    if (d < least) {
      least = d;
      nearest = candidate;
    }
  }
  const int near_enough = std::max(edit, static_cast<int>(name.size()) * edit / 3);
  return least <= near_enough ? nearest : std::string();
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
}

}  // namespace pennon
