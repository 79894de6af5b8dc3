#include "lsa/most_unstable.hpp"

#include "lsa/root.hpp"

namespace pennon::lsa {

std::optional<MostUnstable> most_unstable(Point point, const Theory& theory, Axis axis,
                                          const Sweep& search) {
  const auto stability = [&](double wavenumber) {
    set(point, axis, wavenumber);
    return solve(point, theory);
  };
  std::int64_t best = 0;
  double largest = 0;
  for (std::int64_t i = 0; i < search.size(); ++i) {
    const double growth = stability(search.at(i)).growth;
    if (growth <= largest) continue;
    largest = growth;
    best = i;
  }
  if (largest <= 0) return std::nullopt;
  const bool is_at_an_end = best == 0 || best == search.size() - 1;
  const double wavenumber =
      is_at_an_end ? search.at(best)
                   : find_maximum([&](double k) { return stability(k).growth; },
                                  search.at(best - 1), search.at(best), search.at(best + 1));
  return MostUnstable{wavenumber, stability(wavenumber), is_at_an_end};
}

}  // namespace pennon::lsa
