#include "analysis/decomposition/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "common/available_memory.hpp"
#include "common/case/about_key.hpp"

namespace pennon::decomposition {
namespace {

// "2GB", "500 MB": bytes; none where it is not of that form.
std::optional<double> bytes_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit = end;
  while (unit.starts_with(' ')) unit.erase(0, 1);
  if (end == text.c_str() || !std::isfinite(number) || !(number > 0)) return std::nullopt;
  if (unit == "kB") return number * 1e3;
  if (unit == "MB") return number * 1e6;
  if (unit == "GB") return number * 1e9;
  if (unit == "TB") return number * 1e12;
  return std::nullopt;
}

}  // namespace

const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = {"pod",   "dmd",          "spod",
                                                 "waves", "normal_modes", "global_modes"};
  return names;
}

const std::string& name_of(Method method) {
  return method_names()[static_cast<std::size_t>(method)];
}

double Settings::memory_bytes() const {
  constexpr double unknown = 2e9;
  if (const auto bytes = bytes_in(memory)) return *bytes;
  return available_memory().value_or(2 * unknown) / 2;
}

void declare(Schema& schema, Settings& settings) {
  schema
      .table("decompose",
             "What `pennon decompose` does with a run, or with the snapshots of another code.",
             &settings.is_given)
      .key({"method", choice(settings.method, method_names()),
            "proper orthogonal modes; dynamic modes; spectral proper orthogonal modes; waves along "
            "the span; amplitudes on the normal modes of [modes.normal], or on global modes"})
      .key({"of", choice(settings.of, {"flag", "fluid"}),
            "of a run: z of the flag's shapes, or the velocity in the fluid's fields; of a file of "
            "another code with both: z, or q"})
      .key({"mean", choice(settings.mean, {"removed", "kept"}), "of each value over the snapshots",
            any_sign, false, "removed for pod, spod and waves, else kept"})
      .key({"n_modes", &settings.n_modes, "modes that are reported and kept", Range{1, 10000},
            false, "10, or as many as there are"})
      .key({"block", &settings.block, "of spod: snapshots in a Welch block", Range{4, 1e9}})
      .key({"overlap", &settings.overlap, "of spod: the share of a block that the next one has too",
            Range{0, 0.95}})
      .key({"window", choice(settings.window, {"hamming", "hann", "none"}),
            "of spod: by which each block is multiplied"})
      .key({"frequencies", &settings.frequencies,
            "of spod: at which modes are kept, the nearest there is to each; empty: at the five "
            "highest peaks of the first energy",
            any_sign})
      .key({"from", &settings.from, "begin of the snapshots that are taken, in time", any_sign,
            false, "the first"})
      .key({"to", &settings.to, "their end", any_sign, false, "the last"})
      .key({"rank", &settings.rank, "of dmd: how many exponentials", Range{1, 10000}, false,
            "the singular values above the noise by Gavish and Donoho's rule"})
      .key({"variant", choice(settings.variant, {"exact", "optimised"}),
            "of dmd: exact (biased by noise), or the best fit to all snapshots"})
      .key({"delays", &settings.delays,
            "of dmd: snapshots that are stacked, one behind the other; 2 and more tell "
            "oscillations that stand",
            Range{1, 1000}})
      .key(
          {"wave", &settings.wave,
           "decompose the wave with so many periods along the span alone, by its complex amplitude",
           Range{0, 1e6}, false, "all together"})
      .key({"y", &settings.y, "of waves: the place along the chord; the nearest station is taken",
            any_sign})
      .key({"global_modes", &settings.global_modes,
            "of global_modes: the file in which pennon modes left them; empty: "
            "modes/global_modes.h5 beside the run"})
      .key({"memory", &settings.memory,
            "of all ranks together, as \"2GB\" or \"500MB\"; empty: half of what is free"});
}

void check(const Settings& settings, Faults& faults) {
  if (settings.from && settings.to && *settings.from >= *settings.to)
    about_key(faults, "decompose.to",
              fmt::format("= {} must be above decompose.from = {}", *settings.to, *settings.from));
  if (!settings.memory.empty() && !bytes_in(settings.memory))
    about_key(faults, "decompose.memory",
              fmt::format("= \"{}\" is no size; \"2GB\" or \"500MB\" is one", settings.memory));
  const std::string method = fmt::format("decompose.method = \"{}\"", name_of(settings.method));
  if (settings.is_of_shapes() && settings.wave)
    about_key(faults, "decompose.wave",
              "chooses one wave, but " + method + " is of all; leave it out");
  if (settings.is_of_shapes() && settings.of == Of::fluid)
    about_key(faults, "decompose.of",
              "= \"fluid\" does not go with " + method + ", which is of the flag");
}

}  // namespace pennon::decomposition
