/// The history of a run as records of a file that grows beside its checkpoint
/// (common/io/record_file.hpp): a row, a shape or the time of a field each, in the order in which
/// they were kept of their kind.
///
///   row    the columns of the history; with a fluid the forces on each plane, the trailing edge at
///          each station (of a flag that the flow moves) and the probes
///   shape  t, rows, columns, the count of strains, then positions, velocities and strains as in
///          FlagShapes
///   field  t
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

#include "common/io/hdf5.hpp"
#include "common/io/record_file.hpp"
#include "dns/run/flag_history.hpp"
#include "dns/run/fluid_history.hpp"

namespace pennon::dns {

enum HistoryRecord : std::uint32_t { row_record = 1, shape_record = 2, field_record = 3 };

/// How much of a run's history there is, or lies in the file already.
struct HistoryCount {
  std::size_t rows = 0, shapes = 0, fields = 0;
};

/// Add to the file what comes behind the first so many.
void add_rows(const FlagHistory&, std::size_t first, RecordFile&);
void add_rows(const FluidHistory&, std::size_t first, RecordFile&);
void add_shapes(const FlagShapes&, std::size_t first, RecordFile&);
void add_fields(const std::vector<double>& times, std::size_t first, RecordFile&);

/// Take a record into a history that holds those before it. Throw InputError, which names `file`,
/// where it does not fit: a row has other columns, or is not later than the row before, or is later
/// than the checkpoint.
void take_row(const std::filesystem::path& file, std::span<const double> record, double last,
              FlagHistory&);
void take_row(const std::filesystem::path& file, std::span<const double> record,
              const HistoryInCheckpoint&, FluidHistory&);
void take_shape(const std::filesystem::path& file, std::span<const double> record, FlagShapes&);
void take_field(const std::filesystem::path& file, std::span<const double> record,
                std::vector<double>& times);

/// How the names of the file of records and of the checkpoint begin.
inline constexpr const char* checkpoint_stem = "checkpoint";

/// Which records belong to a checkpoint, as the text /rows in it. A checkpoint without that text is
/// of an earlier version and holds its history itself.
void write(const RecordsEnd&, hdf5::Writer&);
/// Throws InputError where it is of a later version, or cannot be read.
std::optional<RecordsEnd> records_of(const hdf5::Reader&);

using TakeRecord = std::function<void(const std::filesystem::path& file, HistoryRecord kind,
                                      std::span<const double> record)>;
/// Hands over each record of a checkpoint, from the file beside it. False where the checkpoint
/// holds its history itself. Throws InputError where the file does not serve.
bool read_history_records(const hdf5::Reader& checkpoint, const TakeRecord& take);

}  // namespace pennon::dns
