/// Whether all that reads HDF5 files, or the records beside a checkpoint, answers a damaged one in
/// words: each kind of file that pennon writes is damaged in many ways (hdf5_mutator.hpp) and
/// handed to what reads it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/hdf5_mutator.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::test {

/// How many damaged files were answered in which way.
struct Answers {
  std::map<std::string, std::int64_t> taken, refused;  ///< by kind of file
  std::vector<std::string> faults;  ///< what was answered in another way than in words
  long memory_kilobytes = 0;        ///< by which the process grew
};

class ForeignFiles {
 public:
  /// Has pennon write a file of each kind.
  ForeignFiles();

  /// Damages so many files, with the seeds from `first` on.
  Answers damage(std::int64_t count, std::uint64_t first);
  std::size_t kinds() const { return kinds_.size(); }

 private:
  using Read = std::function<void(const std::filesystem::path&)>;
  /// Writes a damaged copy; says what is wrong with it.
  using Damage = std::function<std::string(std::uint64_t seed, const std::filesystem::path& copy)>;
  struct Kind {
    std::string name;
    std::filesystem::path damaged;  ///< where the copy goes
    Damage damage;
    Read read;
  };

  std::filesystem::path run(const std::string& command, const std::string& name,
                            const std::string& case_text);
  void add(const std::string& name, const std::filesystem::path& file, Read);
  void add_records(const std::string& name, const std::filesystem::path& checkpoint,
                   const Read& restart);
  void add_pictures(const std::filesystem::path& folder, const std::vector<std::string>& names);
  void add_lsa();
  void add_modes();
  void add_flag();
  void add_flow();
  void add_oblique_run();
  void add_snapshots();

  TemporaryFolder folder_;
  std::vector<Kind> kinds_;
};

}  // namespace pennon::test
