/// The finished points of a neutral curve and columns of a map, in a file beside the results.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "modes/global/study/growth_map.hpp"
#include "modes/global/study/keeper.hpp"
#include "modes/global/study/neutral_curve.hpp"

namespace pennon::modes::global {

class KeptPieces {
 public:
  /// `problem`: its resolved text. What the file holds of another problem, or in another form, is
  /// not used.
  KeptPieces(std::filesystem::path file, std::string problem);

  /// Each saves the whole file anew after a piece, and throws FileError where that fails.
  Keeper<CurveProgress> neutral();
  Keeper<MapProgress> map();

  /// At the end, when the results are written.
  void remove() const;

 private:
  template <class Progress>
  Keeper<Progress> keeper(const char* name);

  std::filesystem::path file_;
  nlohmann::ordered_json kept_;
};

}  // namespace pennon::modes::global
