#include "common/nearest_name.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <vector>

namespace pennon {
namespace {

// Costs in half edits, so that a change of letter case or a lost underscore costs one half.
constexpr int edit = 2;
constexpr int slip = 1;

int removal_cost(char letter) { return letter == '_' ? slip : edit; }

int replacement_cost(char a, char b) {
  if (a == b) return 0;
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return lower(a) == lower(b) ? slip : edit;
}

// Levenshtein distance with the costs above (Wagner & Fischer 1974), one row at a time.
int distance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j < b.size(); ++j) row[j + 1] = row[j] + removal_cost(b[j]);
  for (const char letter : a) {
    int diagonal = row[0];
    row[0] += removal_cost(letter);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int best =
          std::min({row[j + 1] + removal_cost(letter), row[j] + removal_cost(b[j]),
                    diagonal + replacement_cost(letter, b[j])});
      diagonal = row[j + 1];
      row[j + 1] = best;
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
