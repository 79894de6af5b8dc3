/// Files of records that a run only appends to, for what grows with it: a checkpoint that wrote all
/// of it anew would cost the more the longer the run has gone.
///
///   header   "pennon records 1", the file's own random number, the checksum of both
///   record   kind and count (4 bytes each), `count` numbers, the checksum
///
/// in the machine's own numbers, little-endian. A checksum is of all that stands before it, from
/// the header on, so that the place behind a record (RecordsEnd) also tells which file it is of.
/// HDF5 files are not used here: a process that is killed while the library changes its own records
/// may leave a file that nobody can open. Of this one, what was synced stays as it was.
///
/// Whoever refers to the file does so by a RecordsEnd that flush() has returned, when its records
/// lie on the disk. What stands behind that place, a torn record or those of a later time, is not
/// read, and is cut off when the file is next written to.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace pennon {

/// A place behind a record.
struct RecordsEnd {
  std::uint64_t file = 0;  ///< the file's own number
  std::uint64_t bytes = 0, checksum = 0;
};

/// The name of such a file: "<stem>_<its own number>.rows".
std::filesystem::path records_name(const std::string& stem, std::uint64_t file);

class RecordFile {
 public:
  /// A new file in the folder, which is there after the first flush().
  RecordFile(std::filesystem::path folder, std::string stem);
  /// Goes on behind a place of a file that is there.
  RecordFile(std::filesystem::path folder, std::string stem, const RecordsEnd&);

  /// Adds a record, to be written by flush().
  void add(std::uint32_t kind, std::span<const double> values);
  /// Writes the records that were added, behind those of the last flush(), and syncs them to the
  /// disk. Throws FileError; the next call then tries again.
  RecordsEnd flush();
  /// Removes the folder's other files of this stem.
  void remove_others() const;

 private:
  std::filesystem::path folder_;
  std::string stem_;
  RecordsEnd end_;          // of what lies on the disk
  std::uint64_t checksum_;  // of what was added, too
  std::vector<std::uint64_t> added_;
};

/// Calls use(kind, values) for each record up to `end`. Throws InputError that names the file where
/// it is not there, is another one, ends before, or is damaged.
void read_records(const std::filesystem::path&, const RecordsEnd& end,
                  const std::function<void(std::uint32_t kind, std::span<const double>)>& use);

}  // namespace pennon
