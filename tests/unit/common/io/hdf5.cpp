/// HDF5 files: what is written is read, and a file is whole or absent.
#include "common/io/hdf5.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <numeric>

#include "common/errors.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::hdf5 {
namespace {

using test::ChildEnd;
using test::failure_of;
using test::in_child;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> count_to(std::size_t size) {
  std::vector<double> values(size);
  std::iota(values.begin(), values.end(), 0.1);
  return values;
}

TEST(Hdf5, ReadsWhatWasWritten) {
  const TemporaryFolder folder;
  const auto path = folder / "f.h5";
  Writer writer(path);
  writer.attributes({{"program", std::string("pennon")}, {"empty", std::string()}});
  writer.write("growth", {2, 3}, count_to(6),
               {{"unit", std::string("V/L")}, {"scale", 0.1}, {"count", std::int64_t{6}}});
  writer.write("grid/x", {3}, count_to(3));
  writer.finish();

  const Reader reader(path);
  EXPECT_EQ(reader.read("growth").shape, (Shape{2, 3}));
  EXPECT_EQ(reader.read("growth").values, count_to(6));
  EXPECT_EQ(reader.read("grid/x").values, count_to(3));
  EXPECT_TRUE(reader.contains("grid/x"));
  EXPECT_FALSE(reader.contains("grid/y"));
  EXPECT_FALSE(reader.contains("nothing/x"));
  EXPECT_EQ(reader.text("/", "program"), "pennon");
  EXPECT_EQ(reader.text("/", "empty", "fallback"), "");
  EXPECT_EQ(reader.text("growth", "unit"), "V/L");
  EXPECT_EQ(reader.text("growth", "absent", "fallback"), "fallback");
  EXPECT_EQ(reader.text("growth", "scale", "fallback"), "fallback");
  EXPECT_EQ(reader.number("growth", "scale", 0), 0.1);
  EXPECT_EQ(reader.number("growth", "count", 0), 6);
  EXPECT_EQ(reader.number("growth", "unit", 5), 5);
}

TEST(Hdf5, RowsWrittenOneByOneEqualTheWholeArray) {
  const TemporaryFolder folder;
  constexpr hsize_t rows = 37;
  constexpr hsize_t columns = 11;
  const std::vector<double> values = count_to(rows * columns);
  Writer writer(folder / "f.h5");
  writer.write("whole", {rows, columns}, values);
  writer.declare("streamed", {rows, columns});
  const std::span<const double> all = values;
  for (hsize_t row = 0; row < rows; row += 5) {
    const hsize_t count = std::min<hsize_t>(5, rows - row);
    writer.write_rows("streamed", row, count, all.subspan(row * columns, count * columns));
  }
  writer.finish();
  const Reader reader(folder / "f.h5");
  EXPECT_EQ(reader.read("streamed").values, reader.read("whole").values);
}

TEST(Hdf5, ReadsEverySoManyth) {
  const TemporaryFolder folder;
  Writer writer(folder / "f.h5");
  writer.write("a", {4, 5}, count_to(20));
  writer.write("scalar", {}, count_to(1));
  writer.finish();
  const Reader reader(folder / "f.h5");
  const Array thinned = reader.read_every("a", {3, 2});
  EXPECT_EQ(thinned.shape, (Shape{2, 3}));
  EXPECT_THAT(thinned.values, ElementsAre(0.1, 2.1, 4.1, 15.1, 17.1, 19.1));
  EXPECT_EQ(reader.read_every("a", {1, 1}).values, count_to(20));
  EXPECT_EQ(reader.read("scalar").values, count_to(1));
}

TEST(Hdf5, SaysWhatAFileLacks) {
  const TemporaryFolder folder;
  Writer writer(folder / "f.h5");
  writer.write("group/a", {1}, count_to(1));
  writer.finish();
  const Reader reader(folder / "f.h5");
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.read("b"); }), HasSubstr("has no array b"));
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.shape("group"); }),
              HasSubstr("has no array group"));
  EXPECT_THAT(failure_of<InputError>([&] { Reader(folder / "absent.h5"); }),
              HasSubstr("there is no such file"));
  test::write_text(folder / "text.h5", "text");
  EXPECT_THAT(failure_of<InputError>([&] { Reader(folder / "text.h5"); }),
              HasSubstr("is not an HDF5 file"));
}

TEST(Hdf5, KeepsTheLastWholeFileWhereItsWriterIsKilledOrGivesUp) {
  const TemporaryFolder folder;
  const auto path = folder / "f.h5";
  Writer first(path);
  first.write("a", {1}, count_to(1));
  first.finish();
  { Writer(path).write("a", {100000}, count_to(100000)); }
  const ChildEnd end = in_child([&] {
    Writer second(path);
    second.declare("a", {1000, 1000});
    second.write_rows("a", 0, 1, count_to(1000));
    return raise(SIGKILL);
  });
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_EQ(Reader(path).read("a").values, count_to(1));
}

// Writes more than fits; returns 0 if that fails in words and leaves no file.
int overfill(const TemporaryFolder& folder) {
  const std::string what = failure_of<FileError>([&] {
    Writer writer(folder / "f.h5");
    for (const char* name : {"a", "b", "c"}) writer.write(name, {20000}, count_to(20000));
    writer.finish();
  });
  if (what.find("f.h5") == std::string::npos) return 1;
  return folder.names().empty() ? 0 : 2;
}

TEST(Hdf5, FailsInWordsOnAFullDiskAndLetsTheProcessEnd) {
  const TemporaryFolder folder;
  constexpr unsigned long bytes = 256 << 10;
  const ChildEnd on_full_disk = in_child([&] {
    test::have_small_disk(folder.path(), bytes);
    std::exit(overfill(folder));  // and not _exit: the library must not crash at the end
    return 0;
  });
  EXPECT_EQ(on_full_disk.status, 0) << "signal " << on_full_disk.signal;
  const ChildEnd at_file_limit = in_child([&] {
    test::limit_file_size(bytes);
    std::exit(overfill(folder));
    return 0;
  });
  EXPECT_EQ(at_file_limit.status, 0) << "signal " << at_file_limit.signal;
}

TEST(Hdf5, FailsInWordsWhereTheFolderIsNotThere) {
  EXPECT_THAT(failure_of<FileError>([&] { Writer("/absent/folder/f.h5"); }),
              HasSubstr("/absent/folder/f.h5 cannot be written"));
}

}  // namespace
}  // namespace pennon::hdf5
