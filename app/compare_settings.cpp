#include "app/compare_settings.hpp"

#include <algorithm>

namespace pennon::app {

void declare(Schema& schema, CompareSettings& settings) {
  schema
      .table("compare", "What `pennon compare` sets side by side: models of the same flag.",
             &settings.is_given)
      .key({"waves", &settings.waves, "numbers of waves along the span, n of k_x = 2 pi n/gamma",
            Range{0, 1000}, false, "0, 1, 2; in two dimensions 0"});
}

void check(const CompareSettings& settings, const FlagParameters& flag, Faults& faults) {
  if (!flag.gamma && std::ranges::any_of(settings.waves, [](std::int64_t n) { return n != 0; }))
    faults.about("compare.waves",
                 "compare.waves counts waves along a span, which flag.gamma would give; in two "
                 "dimensions only 0 is possible");
}

std::vector<std::int64_t> waves_of(const CompareSettings& settings, const FlagParameters& flag) {
  if (!settings.waves.empty()) return settings.waves;
  return flag.gamma ? std::vector<std::int64_t>{0, 1, 2} : std::vector<std::int64_t>{0};
}

}  // namespace pennon::app
