#include "dns/run/history_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"

namespace pennon::dns {
namespace {

constexpr const char* rows_text = "/rows";
constexpr int format = 2;  // of checkpoints; those of 1 have no such text

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw InputError(file.string(), what);
}

template <class Values>
void append(const Values& values, std::vector<double>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

// The values of row r of an array that has `rows` of them.
std::span<const double> row_of(const std::vector<double>& values, std::size_t r, std::size_t rows) {
  const std::size_t each = values.size() / rows;
  return {values.data() + r * each, each};
}

// Takes `count` numbers off the front of a record.
std::span<const double> taken(std::span<const double>& record, std::size_t count) {
  const std::span<const double> front = record.first(count);
  record = record.subspan(count);
  return front;
}

void expect_size(const std::filesystem::path& file, const char* what,
                 std::span<const double> record, std::size_t expected) {
  if (record.size() != expected)
    fail(file, fmt::format("has a {} of {} numbers, where the case has {}", what, record.size(),
                           expected));
}

void expect_time(const std::filesystem::path& file, std::size_t row, double t, double before,
                 double last) {
  if (!(t > before && t <= last))
    fail(file, fmt::format("has t = {} in row {}; it must lie above {} and not above {}, the time "
                           "of the checkpoint",
                           t, row, before, last));
}

template <class Rows>
double time_before(const Rows& rows) {
  return rows.empty() ? -HUGE_VAL : rows.back()[0];
}

// A whole number of at least 1 and at most `most`.
std::size_t count_in(const std::filesystem::path& file, double value, std::size_t most) {
  if (!(value >= 1 && value <= static_cast<double>(most) && value == std::floor(value)))
    fail(file, fmt::format("has {} for the number of nodes of a shape along one side", value));
  return static_cast<std::size_t>(value);
}

std::uint64_t hexadecimal(const std::string& text) {
  constexpr std::size_t digits = 16;
  constexpr int base = 16;
  if (text.size() != digits || text.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::invalid_argument("no number of 16 digits");
  return std::stoull(text, nullptr, base);
}

}  // namespace

void add_rows(const FlagHistory& history, std::size_t first, RecordFile& file) {
  for (std::size_t r = first; r < history.rows.size(); ++r) file.add(row_record, history.rows[r]);
}

void add_rows(const FluidHistory& history, std::size_t first, RecordFile& file) {
  const std::size_t rows = history.rows.size();
  std::vector<double> record;
  for (std::size_t r = first; r < rows; ++r) {
    record.assign(history.rows[r].begin(), history.rows[r].end());
    if (!history.flag.empty()) append(history.flag[r], record);
    append(row_of(history.stations, r, rows), record);
    append(row_of(history.trailing_edge, r, rows), record);
    append(row_of(history.probes, r, rows), record);
    file.add(row_record, record);
  }
}

void add_shapes(const FlagShapes& shapes, std::size_t first, RecordFile& file) {
  std::vector<double> record;
  for (std::size_t s = first; s < shapes.times.size(); ++s) {
    const auto strains = std::ranges::count_if(shapes.strains[s],
                                               [](const auto& strain) { return !strain.empty(); });
    record = {shapes.times[s], static_cast<double>(shapes.rows),
              static_cast<double>(shapes.columns), static_cast<double>(strains)};
    append(shapes.positions[s], record);
    for (const std::vector<double>& velocity : shapes.velocities[s]) append(velocity, record);
    for (const std::vector<double>& strain : shapes.strains[s]) append(strain, record);
    file.add(shape_record, record);
  }
}

void add_fields(const std::vector<double>& times, std::size_t first, RecordFile& file) {
  for (std::size_t k = first; k < times.size(); ++k) file.add(field_record, {&times[k], 1});
}

void take_row(const std::filesystem::path& file, std::span<const double> record, double last,
              FlagHistory& history) {
  expect_size(file, "row", record, history_columns);
  expect_time(file, history.rows.size(), record[0], time_before(history.rows), last);
  std::ranges::copy(record, history.rows.emplace_back().begin());
}

void take_row(const std::filesystem::path& file, std::span<const double> record,
              const HistoryInCheckpoint& expected, FluidHistory& history) {
  constexpr std::size_t of_station = 3, of_probe = 4;
  const auto planes = static_cast<std::size_t>(expected.planes);
  const std::size_t probes = expected.probes * planes * of_probe;
  const std::size_t of_flag = expected.is_coupled ? coupled_columns + planes * of_station : 0;
  expect_size(file, "row", record, fluid_columns + planes * of_station + of_flag + probes);
  expect_time(file, history.rows.size(), record[0], time_before(history.rows), expected.t);
  std::ranges::copy(taken(record, fluid_columns), history.rows.emplace_back().begin());
  if (expected.is_coupled)
    std::ranges::copy(taken(record, coupled_columns), history.flag.emplace_back().begin());
  append(taken(record, planes * of_station), history.stations);
  if (expected.is_coupled) append(taken(record, planes * of_station), history.trailing_edge);
  append(record, history.probes);
}

void take_shape(const std::filesystem::path& file, std::span<const double> record,
                FlagShapes& shapes) {
  constexpr std::size_t numbers_before = 4, most_strains = 3;
  if (record.size() < numbers_before) fail(file, "has a shape without its size");
  const std::span<const double> before = taken(record, numbers_before);
  const std::size_t rows = count_in(file, before[1], record.size());
  const std::size_t columns = count_in(file, before[2], record.size() / rows);
  const std::size_t strains = count_in(file, before[3], most_strains);
  const std::size_t nodes = rows * columns;
  const std::size_t cells = std::max<std::size_t>(rows - 1, 1) * (columns - 1);
  expect_size(file, "shape", record, 6 * nodes + strains * cells);
  if (!shapes.times.empty() && (shapes.rows != rows || shapes.columns != columns))
    fail(file, fmt::format("has shapes of {} x {} and of {} x {} nodes", shapes.rows,
                           shapes.columns, rows, columns));
  if (!std::isfinite(before[0])) fail(file, "has a shape whose time is not finite");
  shapes.rows = rows;
  shapes.columns = columns;
  shapes.times.push_back(before[0]);
  append(taken(record, 3 * nodes), shapes.positions.emplace_back());
  for (std::vector<double>& velocity : shapes.velocities.emplace_back())
    append(taken(record, nodes), velocity);
  auto& kept = shapes.strains.emplace_back();
  for (std::size_t k = 0; k < strains; ++k) append(taken(record, cells), kept[k]);
}

void take_field(const std::filesystem::path& file, std::span<const double> record,
                std::vector<double>& times) {
  expect_size(file, "field's time", record, 1);
  if (!std::isfinite(record[0])) fail(file, "has a field whose time is not finite");
  times.push_back(record[0]);
}

void write(const RecordsEnd& end, hdf5::Writer& file) {
  file.write_text(rows_text,
                  nlohmann::ordered_json({{"format", format},
                                          {"file", fmt::format("{:016x}", end.file)},
                                          {"bytes", end.bytes},
                                          {"checksum", fmt::format("{:016x}", end.checksum)}})
                      .dump());
}

std::optional<RecordsEnd> records_of(const hdf5::Reader& file) {
  if (!file.contains(rows_text)) return std::nullopt;
  const auto found = nlohmann::json::parse(file.long_text(rows_text), nullptr, false);
  try {
    if (found.at("format") != format)
      file.fail(fmt::format("is of format {}, and this version of pennon reads up to {}",
                            found.at("format").dump(), format));
    if (!found.at("bytes").is_number_unsigned()) throw std::invalid_argument("no number of bytes");
    return RecordsEnd{.file = hexadecimal(found.at("file")),
                      .bytes = found.at("bytes").get<std::uint64_t>(),
                      .checksum = hexadecimal(found.at("checksum"))};
  } catch (const nlohmann::json::exception&) {
  } catch (const std::invalid_argument&) {
  }
  file.fail(fmt::format("has a text {} that cannot be read", rows_text));
}

bool read_history_records(const hdf5::Reader& checkpoint, const TakeRecord& take) {
  const std::optional<RecordsEnd> end = records_of(checkpoint);
  if (!end) return false;
  const std::filesystem::path path =
      checkpoint.path().parent_path() / records_name(checkpoint_stem, end->file);
  read_records(path, *end, [&](std::uint32_t kind, std::span<const double> record) {
    if (kind < row_record || kind > field_record)
      fail(path, fmt::format("has a record of kind {}, which is none", kind));
    take(path, static_cast<HistoryRecord>(kind), record);
  });
  return true;
}

}  // namespace pennon::dns
