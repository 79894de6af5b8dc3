#include "lsa/neutral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "lsa/root.hpp"

namespace pennon::lsa {
namespace {

using Function = std::function<double(double, double)>;

struct Crossing {
  double x, y;
  std::array<std::size_t, 2> neighbours{};
  std::size_t degree = 0;
  bool is_used = false;
};

class MarchingSquares {
 public:
  MarchingSquares(const Function& g, std::span<const double> x, std::span<const double> y)
      : g_(g), x_(x), y_(y), values_(x.size() * y.size()) {
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i) values_[j * x.size() + i] = g(x[i], y[j]);
  }

  std::vector<Polyline> trace() {
    for (std::size_t j = 0; j + 1 < y_.size(); ++j)
      for (std::size_t i = 0; i + 1 < x_.size(); ++i) join_in_cell(i, j);
    std::vector<Polyline> lines;
    for (std::size_t c = 0; c < crossings_.size(); ++c)  // open curves, from their ends
      if (crossings_[c].degree == 1 && !crossings_[c].is_used) lines.push_back(follow(c));
    for (std::size_t c = 0; c < crossings_.size(); ++c)  // what is left is closed
      if (crossings_[c].degree == 2 && !crossings_[c].is_used) {
        lines.push_back(follow(c));
        lines.back().x.push_back(lines.back().x.front());
        lines.back().y.push_back(lines.back().y.front());
      }
    return lines;
  }

 private:
  double value(std::size_t i, std::size_t j) const { return values_[j * x_.size() + i]; }
  bool changes(double a, double b) const { return (a < 0) != (b < 0); }

  // The crossing of the grid line from node (i, j) in direction x or y, made when first asked for.
  std::size_t crossing(std::size_t i, std::size_t j, bool along_x) {
    const std::uint64_t key = 2 * (j * x_.size() + i) + (along_x ? 1 : 0);
    const auto [entry, is_new] = index_.try_emplace(key, crossings_.size());
    if (is_new) {
      const double x = x_[i];
      const double y = y_[j];
      if (along_x)
        crossings_.push_back({find_root([&](double t) { return g_(t, y); }, x, x_[i + 1]), y});
      else
        crossings_.push_back({x, find_root([&](double t) { return g_(x, t); }, y, y_[j + 1])});
    }
    return entry->second;
  }

  void join(std::size_t a, std::size_t b) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
      if (crossings_[from].degree < 2) crossings_[from].neighbours[crossings_[from].degree++] = to;
  }

  void join_in_cell(std::size_t i, std::size_t j) {
    const std::array<double, 4> corner = {value(i, j), value(i + 1, j), value(i + 1, j + 1),
                                          value(i, j + 1)};
    if (std::ranges::any_of(corner, [](double v) { return std::isnan(v); })) return;
    // The cell's edges in turn: bottom, right, top, left.
    const auto edge = [&](std::size_t e) {
      return e == 0   ? crossing(i, j, true)
             : e == 1 ? crossing(i + 1, j, false)
             : e == 2 ? crossing(i, j + 1, true)
                      : crossing(i, j, false);
    };
    std::array<std::size_t, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t e = 0; e < 4; ++e)
      if (changes(corner[e], corner[(e + 1) % 4])) crossed[count++] = edge(e);
    if (count == 2) join(crossed[0], crossed[1]);
    if (count == 4) {  // a saddle: the value in the middle says which corners belong together
      const double middle = g_((x_[i] + x_[i + 1]) / 2, (y_[j] + y_[j + 1]) / 2);
      const std::size_t first = changes(middle, corner[0]) ? 3 : 1;
      join(crossed[0], crossed[first]);
      join(crossed[2], crossed[first == 3 ? 1 : 3]);
    }
  }

  Polyline follow(std::size_t start) {
    Polyline line;
    for (std::size_t at = start;;) {
      Crossing& here = crossings_[at];
      here.is_used = true;
      line.x.push_back(here.x);
      line.y.push_back(here.y);
      std::size_t next = at;
      for (std::size_t n = 0; n < here.degree; ++n)
        if (!crossings_[here.neighbours[n]].is_used) next = here.neighbours[n];
      if (next == at) return line;
      at = next;
    }
  }

  const Function& g_;
  std::span<const double> x_, y_;
  std::vector<double> values_;
  std::vector<Crossing> crossings_;
  std::unordered_map<std::uint64_t, std::size_t> index_;
};

}  // namespace

std::vector<Polyline> trace_neutral(const Function& g, std::span<const double> x,
                                    std::span<const double> y) {
  return MarchingSquares(g, x, y).trace();
}

}  // namespace pennon::lsa
