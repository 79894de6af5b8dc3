#include "lsa/verdicts.hpp"

#include <algorithm>
#include <cmath>

#include "lsa/root.hpp"

namespace pennon::lsa {
namespace {

// Where the row's verdict changes along the search.
std::vector<double> neutral_points(Point point, const Theory& theory, const Sweep& search) {
  const auto g = [&](double k_y) {
    point.k_y = k_y;
    return neutral_function(coefficients(point, theory));
  };
  std::vector<double> roots;
  double previous = g(search.at(0));
  for (std::int64_t i = 1; i < search.size(); ++i) {
    const double here = g(search.at(i));
    if ((previous < 0) != (here < 0)) roots.push_back(find_root(g, search.at(i - 1), search.at(i)));
    previous = here;
  }
  return roots;
}

}  // namespace

Verdicts compare(const std::vector<Outcome>& outcomes, const Point& point, const Theory& theory,
                 const Sweep& search) {
  Verdicts verdicts;
  std::vector<double> borders = {search.at(0), search.at(search.size() - 1)};
  for (const Outcome& outcome : outcomes) {
    verdicts.rows.push_back({outcome, solve(at(point, outcome), theory)});
    for (const double root : neutral_points(at(point, outcome), theory, search))
      borders.push_back(root);
  }
  std::ranges::sort(borders);
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());

  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {  // no verdict changes between borders
    const double middle = (borders[i] + borders[i + 1]) / 2;
    const auto agreeing =
        static_cast<std::size_t>(std::ranges::count_if(outcomes, [&](const Outcome& outcome) {
          Point there = at(point, outcome);
          there.k_y = middle;
          return solve(there, theory).is_unstable() == outcome.is_unstable;
        }));
    verdicts.most_agreeing = std::max(verdicts.most_agreeing, agreeing);
    if (agreeing < outcomes.size()) continue;
    if (!verdicts.reproduced.empty() && verdicts.reproduced.back().second == borders[i])
      verdicts.reproduced.back().second = borders[i + 1];
    else
      verdicts.reproduced.emplace_back(borders[i], borders[i + 1]);
  }
  return verdicts;
}

}  // namespace pennon::lsa
