/// The history of a run as records beside its checkpoint, and what a checkpoint costs.
#include "dns/run/history_records.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "common/errors.hpp"
#include "dns/run/flag_run.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::dns {
namespace {

namespace fs = std::filesystem;
using test::failure_of;
using testing::HasSubstr;

constexpr double t_of_checkpoint = 5;

std::vector<double> numbers(std::size_t count, double first) {
  std::vector<double> values(count);
  for (std::size_t k = 0; k < count; ++k) values[k] = first + static_cast<double>(k) / 8;
  return values;
}

FlagShapes shapes_of(int count, bool has_span) {
  FlagShapes shapes;
  shapes.rows = has_span ? 3 : 1;
  shapes.columns = 4;
  const std::size_t nodes = shapes.rows * shapes.columns, cells = has_span ? 6 : 3;
  for (int s = 0; s < count; ++s) {
    shapes.times.push_back(s);
    shapes.positions.push_back(numbers(3 * nodes, s));
    shapes.velocities.push_back(
        {numbers(nodes, s + 10), numbers(nodes, s + 20), numbers(nodes, s + 30)});
    shapes.strains.push_back({numbers(cells, s + 40)});
    if (has_span)
      shapes.strains.back() = {numbers(cells, s + 40), numbers(cells, s + 50),
                               numbers(cells, s + 60)};
  }
  return shapes;
}

FluidHistory history_of(int rows, std::size_t planes, std::size_t probes, bool is_coupled) {
  FluidHistory history;
  const auto append = [](std::vector<double>& all, const std::vector<double>& values) {
    all.insert(all.end(), values.begin(), values.end());
  };
  for (int r = 0; r < rows; ++r) {
    std::ranges::copy(numbers(fluid_columns, r), history.rows.emplace_back().begin());
    append(history.stations, numbers(3 * planes, r + 100));
    append(history.probes, numbers(4 * planes * probes, r + 200));
    if (!is_coupled) continue;
    std::ranges::copy(numbers(coupled_columns, r + 300), history.flag.emplace_back().begin());
    append(history.trailing_edge, numbers(3 * planes, r + 400));
  }
  return history;
}

void expect_equal(const FlagShapes& a, const FlagShapes& b) {
  EXPECT_EQ(a.rows, b.rows);
  EXPECT_EQ(a.columns, b.columns);
  EXPECT_EQ(a.times, b.times);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.velocities, b.velocities);
  EXPECT_EQ(a.strains, b.strains);
}

class HistoryRecords : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  const fs::path path_ = "checkpoint.rows";

  // Each record as add(file) wrote them, in two parts.
  template <class Add>
  void read_back(const Add& add, const std::function<void(std::span<const double>)>& take) {
    RecordFile file(folder_.path(), checkpoint_stem);
    add(file);
    const RecordsEnd end = file.flush();
    read_records(folder_ / records_name(checkpoint_stem, end.file), end,
                 [&](std::uint32_t, std::span<const double> record) { take(record); });
  }
};

TEST_F(HistoryRecords, HoldTheHistoryOfAFlow) {
  for (const bool is_coupled : {false, true})
    for (const std::size_t probes : {0U, 2U}) {
      const FluidHistory history = history_of(4, 3, probes, is_coupled);
      const HistoryInCheckpoint expected{t_of_checkpoint, 3, probes, is_coupled};
      FluidHistory found = history_of(1, 3, probes, is_coupled);
      read_back([&](RecordFile& file) { add_rows(history, 1, file); },
                [&](auto record) { take_row(path_, record, expected, found); });
      EXPECT_EQ(found.rows, history.rows);
      EXPECT_EQ(found.stations, history.stations);
      EXPECT_EQ(found.probes, history.probes);
      EXPECT_EQ(found.flag, history.flag);
      EXPECT_EQ(found.trailing_edge, history.trailing_edge);
    }
}

TEST_F(HistoryRecords, HoldTheHistoryOfAFlagAndItsShapes) {
  FlagHistory history, found;
  for (int r = 0; r < 3; ++r)
    std::ranges::copy(numbers(history_columns, r), history.rows.emplace_back().begin());
  read_back([&](RecordFile& file) { add_rows(history, 0, file); },
            [&](auto record) { take_row(path_, record, t_of_checkpoint, found); });
  EXPECT_EQ(found.rows, history.rows);
  for (const bool has_span : {false, true}) {
    const FlagShapes shapes = shapes_of(3, has_span);
    FlagShapes read = shapes_of(1, has_span);
    read_back([&](RecordFile& file) { add_shapes(shapes, 1, file); },
              [&](auto record) { take_shape(path_, record, read); });
    expect_equal(read, shapes);
  }
}

TEST_F(HistoryRecords, RefuseRowsOfAnotherCaseOrTime) {
  const HistoryInCheckpoint expected{t_of_checkpoint, 2, 1, true};
  // Forces and trailing edges on two planes, and two probes.
  const std::size_t planes = 2, probes = 2,
                    size = fluid_columns + coupled_columns + planes * 3 + planes * 3 + probes * 4;
  const auto refusal = [&](const std::vector<double>& record) {
    FluidHistory history = history_of(2, 2, 1, true);  // the last at t = 1
    return failure_of<InputError>([&] { take_row(path_, record, expected, history); });
  };
  EXPECT_EQ(refusal(numbers(size, 2)), "");
  for (const std::size_t other : {std::size_t{0}, size - 1, size + 1, size + 4})
    EXPECT_THAT(refusal(numbers(other, 2)), HasSubstr(fmt::format("{} numbers", other)));
  for (const double t : {1.0, 0.5, 5.1, std::nan(""), HUGE_VAL})
    EXPECT_THAT(refusal(numbers(size, t)), HasSubstr("the time of the checkpoint")) << t;
  FlagHistory history;
  EXPECT_THROW(take_row(path_, numbers(history_columns + 1, 0), 5, history), InputError);
  EXPECT_THROW(take_row(path_, numbers(history_columns, 6), 5, history), InputError);
}

TEST_F(HistoryRecords, RefuseShapesOfAnotherSize) {
  const auto refusal = [&](const std::vector<double>& record) {
    FlagShapes shapes = shapes_of(1, false);
    return failure_of<InputError>([&] { take_shape(path_, record, shapes); });
  };
  std::vector<double> good = {1, 1, 4, 1};
  good.resize(4 + 6 * 4 + 3);
  EXPECT_EQ(refusal(good), "");
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_NE(refusal({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}), "");
  for (const std::size_t place : {0U, 1U, 2U, 3U})
    for (const double value : {std::nan(""), HUGE_VAL, -1.0, 1.5, 1e300, 0.0, 9.0}) {
      if (place == 0 && std::isfinite(value)) continue;  // any time does
      std::vector<double> bad = good;
      bad[place] = value;
      EXPECT_NE(refusal(bad), "") << place << ": " << value;
    }
  std::vector<double> longer = {1, 1, 5, 1};  // sound, but not that of the first
  longer.resize(4 + 6 * 5 + 4);
  EXPECT_THAT(refusal(longer), HasSubstr("shapes of 1 x 4 and of 1 x 5 nodes"));
}

TEST_F(HistoryRecords, AreNamedByTheirCheckpoint) {
  const fs::path path = folder_ / "checkpoint.h5";
  const auto found = [&](const std::optional<std::string>& text) {
    hdf5::Writer file(path);
    if (text) file.write_text("/rows", *text);
    file.finish();
    return records_of(hdf5::Reader(path));
  };
  EXPECT_FALSE(found({})) << "an earlier version";
  hdf5::Writer file(path);
  write({0xabcdef0123456789U, 4096, 0xfU}, file);
  file.finish();
  const RecordsEnd end = *records_of(hdf5::Reader(path));
  EXPECT_EQ(end.file, 0xabcdef0123456789U);
  EXPECT_EQ(end.bytes, 4096U);
  EXPECT_EQ(end.checksum, 0xfU);
  const auto refusal = [&](const std::string& text) {
    return failure_of<InputError>([&] { found(text); });
  };
  EXPECT_THAT(refusal(R"({"format":3})"), HasSubstr("is of format 3"));
  const auto rows = [](const std::string& name, const std::string& bytes,
                       const std::string& checksum) {
    return fmt::format(R"({{"format":2,"file":{},"bytes":{},"checksum":{}}})", name, bytes,
                       checksum);
  };
  const std::string number = R"("0123456789abcdef")";
  for (const std::string& bad :
       {std::string("x"), std::string("[]"), std::string("{}"),
        rows(R"("../../../../etc")", "8", number), rows(number, "-8", number),
        rows(number, R"("8")", number), rows(number, "8", "7")})
    EXPECT_THAT(refusal(bad), HasSubstr("/rows")) << bad;
}

// Bytes that this process has written so far.
double written_bytes() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  for (double value = 0; counts >> name >> value;)
    if (name == "wchar:") return value;
  ADD_FAILURE() << "no count of bytes";
  return 0;
}

// A checkpoint after each step of a flag whose shape is kept each step, over `steps` of them.
double bytes_of_checkpoints(int steps) {
  Settings settings;
  settings.is_given = true;
  settings.dt = 0.01;
  settings.t_end = steps * settings.dt;
  settings.n_x = 1;
  settings.flag.n_y = 20;
  settings.initial.angle = 0.1;
  settings.output.shape_interval = settings.dt;
  FlagParameters flag;
  flag.mu = 1;
  flag.K_B = 0.01;
  const auto bytes = [&](double checkpoint_interval) {
    const test::TemporaryFolder folder;
    settings.output.checkpoint_interval = checkpoint_interval;
    const double before = written_bytes();
    run_flag(settings, flag, {}, {}, OutputFolder(folder.path()), false);
    return written_bytes() - before;
  };
  return bytes(settings.dt) - bytes(0);
}

TEST(Checkpoints, CostTheSameHoweverLongTheRunHasGone) {
  const double few = bytes_of_checkpoints(50), many = bytes_of_checkpoints(200);
  EXPECT_GT(few, 50 * 1000);
  EXPECT_NEAR(many / few, 4, 0.1);
}

}  // namespace
}  // namespace pennon::dns
