/// What is kept of long work as its pieces are finished, so that the next start goes on with them.
#pragma once

#include <functional>
#include <optional>

namespace pennon::modes::global {

template <class Progress>
struct Keeper {
  std::function<std::optional<Progress>()> load = {};  ///< what was kept; none: nothing
  std::function<void(const Progress&)> save = {};

  /// Without functions nothing is kept.
  Progress begin() const {
    if (load)
      if (std::optional<Progress> kept = load()) return std::move(*kept);
    return {};
  }
  void keep(const Progress& progress) const {
    if (save) save(progress);
  }
};

}  // namespace pennon::modes::global
