#include "dns/run/restart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "common/case/case_difference.hpp"
#include "common/errors.hpp"

namespace pennon::dns {
namespace {

// Names of keys; one that ends with a dot stands for a table.
constexpr std::array<std::string_view, 11> free_keys = {"dns.t_end",
                                                        "dns.dt",
                                                        "dns.cfl",
                                                        "dns.first_dt",
                                                        "dns.output.",
                                                        "dns.coupling.",
                                                        "dns.convergence.",
                                                        "dns.flag.tolerance",
                                                        "dns.fluid.pressure_tolerance",
                                                        "dns.fluid.velocity_tolerance",
                                                        "dns.fluid.grid_tolerance"};
constexpr std::array<std::string_view, 16> physics_keys = {"flag.mu",
                                                           "flag.K_B",
                                                           "flag.K_S",
                                                           "flag.nu_s",
                                                           "flag.damping",
                                                           "flag.gravity",
                                                           "flag.leading_edge",
                                                           "flow.Re",
                                                           "flow.U",
                                                           "dns.fluid.convection",
                                                           "dns.motion.",
                                                           "dns.loads.",
                                                           "dns.initial.ramp",
                                                           "dns.initial.release",
                                                           "dns.initial.kick",
                                                           "dns.initial.kick_duration"};
// Within the tables above.
constexpr std::array<std::string_view, 2> fixed_keys = {"dns.output.probe_x", "dns.output.probe_y"};

template <class Names>
bool is_among(const std::string& key, const Names& names) {
  return std::ranges::any_of(names, [&](std::string_view name) {
    return name.ends_with('.') ? key.starts_with(name) : key == name;
  });
}

constexpr const char* case_text = "/case";
constexpr const char* changes_text = "/changes";

std::string value_or_none(const std::optional<std::string>& value) {
  return value.value_or("not set");
}

// Whether the difference may not be, even where changes of the physics are meant: a table or a key
// that is on one side alone is another kind of run.
bool is_fixed(const CaseDifference& difference) {
  return at_restart(difference.key) == AtRestart::fixed ||
         (at_restart(difference.key) == AtRestart::physics &&
          (!difference.there || !difference.here));
}

}  // namespace

AtRestart at_restart(const std::string& key) {
  if (is_among(key, fixed_keys)) return AtRestart::fixed;
  if (is_among(key, free_keys)) return AtRestart::free;
  if (is_among(key, physics_keys)) return AtRestart::physics;
  return AtRestart::fixed;
}

bool is_of_simulation(const std::string& key) {
  return key.starts_with("flag.") || key.starts_with("flow.") || key.starts_with("dns.");
}

void write(const CaseOfRun& the_case, hdf5::Writer& file) {
  file.write_text(case_text, the_case.text);
  nlohmann::json changes = nlohmann::json::array();
  for (const auto& [t, key, before, after] : the_case.changes)
    changes.push_back({{"t", t}, {"key", key}, {"before", before}, {"after", after}});
  file.write_text(changes_text, changes.dump());
}

CaseOfRun read_case_of_run(const hdf5::Reader& file) {
  if (!file.contains(case_text))
    file.fail(
        "does not say of which case it is; an earlier version of pennon wrote it, or it is "
        "no checkpoint");
  CaseOfRun the_case{file.long_text(case_text), {}};
  const auto changes = nlohmann::json::parse(file.long_text(changes_text), nullptr, false);
  try {
    for (const auto& change : changes)
      the_case.changes.push_back(
          {change.at("t"), change.at("key"), change.at("before"), change.at("after")});
  } catch (const nlohmann::json::exception&) {
    file.fail(fmt::format("has a list of changes, {}, that cannot be read", changes_text));
  }
  return the_case;
}

Beginning beginning_at(const std::filesystem::path& checkpoint, const std::string& text,
                       double t_end, bool accepts_physics) {
  const hdf5::Reader file(checkpoint);
  if (!file.text("/", "kind").ends_with("_checkpoint"))
    file.fail("is no checkpoint; a run writes checkpoint.h5");
  Beginning beginning{read_case_of_run(file), checkpoint};
  const double t = file.number("/", "t");
  std::vector<InputFault> faults;
  for (const CaseDifference& difference :
       case_differences(beginning.the_case.text, checkpoint.string() + " " + case_text, text,
                        [](const auto& key) {
                          return is_of_simulation(key) && at_restart(key) != AtRestart::free;
                        })) {
    if (is_fixed(difference)) {
      faults.push_back({"--restart", fmt::format("{}; it cannot change at a restart: start anew, "
                                                 "without --restart",
                                                 difference.text())});
    } else if (!accepts_physics) {
      faults.push_back({"--restart", fmt::format("{}; where that is meant, --change goes on so and "
                                                 "records it",
                                                 difference.text())});
    } else {
      beginning.the_case.changes.push_back(
          {t, difference.key, value_or_none(difference.there), value_or_none(difference.here)});
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  // A run that was stopped after its last step has its results to write yet.
  constexpr double rounding = 1e-12;
  const bool is_at_end = std::abs(t - t_end) <= rounding * t_end;
  const bool was_ended = std::filesystem::exists(checkpoint.parent_path() / "summary.json");
  if (is_at_end ? was_ended : t > t_end)
    throw InputError("dns.t_end",
                     fmt::format("= {} is reached already: {} is at t = {}; give a later dns.t_end "
                                 "to go on",
                                 t_end, checkpoint.string(), t));
  beginning.the_case.text = text;
  return beginning;
}

}  // namespace pennon::dns
