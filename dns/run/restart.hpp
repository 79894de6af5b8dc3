/// Which case a run is of: kept in each of its checkpoints, so that a restart with another case is
/// seen. Keys of [flag], [flow] and [dns...] are of three kinds:
///
///   free       may change: the end, the step, tolerances, what is kept
///   physics    may change where the user says that it is meant, and the change is recorded
///   fixed      may not: the grid, the nodes, the probes, where the run started
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"

namespace pennon::dns {

enum class AtRestart { free, physics, fixed };

/// Of a key, "flag.mu". Any that is not known as free or physics is fixed.
AtRestart at_restart(const std::string& key);

/// Whether the key is of what a simulation computes: in [flag], [flow] or [dns].
bool is_of_simulation(const std::string& key);

/// A key of the physics with another value from a time on.
struct CaseChange {
  double t = 0;
  std::string key, before, after;  ///< values as TOML
};

struct CaseOfRun {
  std::string text;  ///< the resolved case
  std::vector<CaseChange> changes;
};

void write(const CaseOfRun&, hdf5::Writer&);
/// Throws InputError where the file has none.
CaseOfRun read_case_of_run(const hdf5::Reader&);

/// How a run begins, and what its checkpoints say of the case.
struct Beginning {
  CaseOfRun the_case;
  std::optional<std::filesystem::path> checkpoint;  ///< from which it goes on; none: at t = 0
};

/// The beginning of a run with the case `text` from the checkpoint. Throws InputError that names
/// each key which may not have changed, with its value there and here; where the file is no
/// checkpoint, or is at t_end already although its run left a summary beside it.
/// `accepts_physics`: changes of the physics are meant.
Beginning beginning_at(const std::filesystem::path& checkpoint, const std::string& text,
                       double t_end, bool accepts_physics);

}  // namespace pennon::dns
