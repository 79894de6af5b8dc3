/// The folder of a command's results: of one command and one resolved case, written to by one
/// process at a time.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/io/folder_lock.hpp"
#include "common/io/output_folder.hpp"

namespace pennon::app {

/// What a command is about to write, and where.
struct ResultRequest {
  std::string command;   ///< "lsa"
  std::string the_case;  ///< the resolved case
  std::string title;     ///< what is said above it in case.resolved.toml, on one line
  /// How the names of its files begin: "map" for map.h5, map.csv, map.png.
  std::vector<std::string> files;
  /// The checkpoint from which a run goes on.
  std::optional<std::filesystem::path> checkpoint = {};
  bool is_forced = false;  ///< replaces whatever results are there
  /// Analyses replace those of the same run as it went on: its end and its step may differ.
  bool follows_run = false;
};

class ResultFolder {
 public:
  /// Makes the folder, locks it, removes what killed runs left in it, and writes
  /// case.resolved.toml. Under mpiexec every rank calls. Throws InputError where the folder holds
  /// results of another command or case, an unfinished run, or files of this command's names that
  /// pennon did not write, and nothing is forced; where another process writes to it; FileError
  /// where it cannot be written to.
  ResultFolder(const std::filesystem::path& folder, const ResultRequest&);

  const OutputFolder& output() const { return *output_; }

  /// Where the command found its input unfit before it wrote anything: takes back the case file,
  /// and the folders that were made for it.
  void withdraw();

  /// At the end: removes the files of an earlier run of this case that this one did not write.
  void remove_older_files() const;

 private:
  ResultRequest request_;
  std::vector<std::filesystem::path> made_;  // folders, the outermost first
  std::optional<OutputFolder> output_;
  std::optional<FolderLock> lock_;
};

/// The text of a regular file; empty where there is none. Throws InputError where the path leads to
/// something else.
std::string text_of_file(const std::filesystem::path&);

}  // namespace pennon::app
