/// What every command on a case shares: read and check it, make the output folder, echo the
/// resolved case, work, and leave summary.json and record.json.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/case.hpp"
#include "app/result_folder.hpp"
#include "common/record/record.hpp"

namespace pennon::app {

struct Options {
  std::string case_file;
  std::string output;                  ///< the folder; empty: results/<case name>/<command>
  std::vector<std::string> overrides;  ///< table.key=value
  bool check = false;                  ///< print the resolved case and stop
  bool json = false;                   ///< standard output is one JSON object
  bool quiet = false;                  ///< no progress, no text
  bool force = false;                  ///< replace other results in the folder
  std::string command_line;            ///< for the record
};

/// What a command found: for scripts, and for the reader of the screen.
struct Answer {
  nlohmann::ordered_json json;
  std::string text;
};

/// A command's work, and what it asks of the case.
struct Command {
  std::string name;                ///< and of its folder: "lsa"
  std::vector<std::string> files;  ///< how the names of its files begin (result_folder.hpp)
  Asked asked;
  std::function<void(const Case&)> expect;  ///< throws InputError where it cannot run; or nothing
  std::function<Answer(const Case&, const OutputFolder&, Record&)> work;
  /// Where a run goes on from a checkpoint, known once `expect` was called.
  std::function<std::optional<std::filesystem::path>()> checkpoint = {};
};

/// What every command leaves at its end, and says: removes what an earlier run of the case left
/// behind, writes record.json and summary.json, and prints the answer.
void finish(const ResultFolder&, const Record&, const Answer&, bool as_json, bool quietly);

/// Throws InputError where mpiexec has started several ranks of a command that runs on one.
void expect_one_rank(const std::string& command);

/// Prints to standard output, and throws FileError where it cannot be written to.
void print(const std::string& text);

/// Runs the command and prints its answer. Throws InputError, SolverError, FileError, Interrupted.
void run(const Command&, const Options&);

}  // namespace pennon::app
