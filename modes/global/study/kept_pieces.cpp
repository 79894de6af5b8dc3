#include "modes/global/study/kept_pieces.hpp"

#include <fstream>
#include <utility>

#include "common/io/atomic_file.hpp"
#include "modes/global/study/wire.hpp"

namespace pennon::modes::global {
namespace {

constexpr const char* problem_key = "problem";

}  // namespace

KeptPieces::KeptPieces(std::filesystem::path file, std::string problem) : file_(std::move(file)) {
  if (std::filesystem::is_regular_file(file_)) {
    std::ifstream stream(file_);
    kept_ = nlohmann::ordered_json::parse(stream, nullptr, false);
  }
  if (!kept_.is_object() || !kept_.contains(problem_key) || kept_[problem_key] != problem)
    kept_ = {{problem_key, std::move(problem)}};
}

template <class Progress>
Keeper<Progress> KeptPieces::keeper(const char* name) {
  return {.load = [this, name]() -> std::optional<Progress> {
            if (!kept_.contains(name)) return std::nullopt;
            try {
              Progress progress;
              from_wire(kept_[name], progress);
              return progress;
            } catch (const nlohmann::json::exception&) {
              return std::nullopt;
            }
          },
          .save =
              [this, name](const Progress& progress) {
                kept_[name] = to_wire(progress);
                write_file(file_, kept_.dump(1) + "\n");
              }};
}

Keeper<CurveProgress> KeptPieces::neutral() {
  return keeper<CurveProgress>("neutral");
}

Keeper<MapProgress> KeptPieces::map() {
  return keeper<MapProgress>("map");
}

void KeptPieces::remove() const {
  std::error_code ignored;
  std::filesystem::remove(file_, ignored);
}

}  // namespace pennon::modes::global
