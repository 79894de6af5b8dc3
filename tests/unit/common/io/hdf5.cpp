/// HDF5 files: what is written is read, and a file is whole or absent.
#include "common/io/hdf5.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
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
  EXPECT_EQ(reader.number("growth", "scale", 0), 0.1);
  EXPECT_EQ(reader.number("growth", "count", 0), 6);
  EXPECT_EQ(reader.number("growth", "absent", 5), 5);
  EXPECT_EQ(reader.counted("growth", "count"), 6);
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

TEST(Hdf5, ReadsATextOfAnyLength) {
  const TemporaryFolder folder;
  const std::string text(200'000, 'x');
  Writer writer(folder / "f.h5");
  writer.write_text("/case", text);
  writer.write_text("/none", "");
  writer.write("/number", {1}, count_to(1));
  writer.finish();
  const Reader reader(folder / "f.h5");
  EXPECT_EQ(reader.long_text("/case"), text);
  EXPECT_EQ(reader.long_text("/none"), "");
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.long_text("/number"); }),
              HasSubstr("has /number, where one text"));
}

TEST(Hdf5, SaysWhichShapeAnArrayShouldHave) {
  const TemporaryFolder folder;
  Writer writer(folder / "f.h5");
  writer.write("a", {2, 3}, count_to(6));
  writer.write("none", {0}, {});
  writer.finish();
  const Reader reader(folder / "f.h5");
  EXPECT_EQ(reader.read("a", {any, 3}).values, count_to(6));
  EXPECT_THAT(failure_of<InputError>([&] {
                (void)reader.read("a", {any, 4});
              }),
              HasSubstr("has an array a of 2 x 3, where n x 4 is needed"));
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.list("a"); }),
              HasSubstr("2 x 3, where n is needed"));
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.list("none"); }),
              HasSubstr("of 0, where n is needed"));
  EXPECT_TRUE(reader.list("none", any_or_none).empty());
  EXPECT_THAT(failure_of<InputError>([&] { (void)reader.read_every("a", {1}); }),
              HasSubstr("2 x 3, where 1 indices are needed"));
}

// A file as another program may have written it, or to do harm; the calls are the library's own.
class Foreign : public testing::Test {
 protected:
  Foreign() : file_(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}

  void attribute(const char* name, hid_t type, const std::vector<hsize_t>& extents,
                 const void* values) {
    const hid_t space = extents.empty() ? H5Screate(H5S_SCALAR)
                                        : H5Screate_simple(static_cast<int>(extents.size()),
                                                           extents.data(), nullptr);
    const hid_t made = H5Acreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(made, type, values);
    H5Aclose(made);
    H5Sclose(space);
  }
  void dataset(const char* name, hid_t type, hid_t space, hid_t storage = H5P_DEFAULT) {
    H5Dclose(H5Dcreate2(file_, name, type, space, H5P_DEFAULT, storage, H5P_DEFAULT));
    H5Sclose(space);
  }
  Reader reader() {
    H5Fclose(file_);
    return Reader(path_);
  }

  TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "foreign.h5";
  hid_t file_;
};

TEST_F(Foreign, AttributesOfSeveralValuesAreRefused) {
  const std::vector<double> many = count_to(1000);
  attribute("many", H5T_NATIVE_DOUBLE, {1000}, many.data());
  attribute("none", H5T_NATIVE_DOUBLE, {0}, many.data());
  const double one = 0.5;
  attribute("one", H5T_NATIVE_DOUBLE, {1}, &one);
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 8);
  attribute("texts", text, {1000}, many.data());
  attribute("word", text, {}, "word\0\0\0");
  const Reader file = reader();
  for (const char* name : {"many", "none", "word"})
    EXPECT_THROW((void)file.number("/", name, 0), InputError) << name;
  for (const char* name : {"texts", "one"})
    EXPECT_THROW((void)file.text("/", name), InputError) << name;
  EXPECT_EQ(file.number("/", "one", 0), 0.5);
  EXPECT_EQ(file.text("/", "word"), "word");
}

TEST_F(Foreign, TextsOfVariableLengthAreRead) {
  const hid_t text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, H5T_VARIABLE);
  const char* word = "as h5py writes it";
  attribute("word", text, {}, &word);
  EXPECT_EQ(reader().text("/", "word"), word);
}

TEST_F(Foreign, NumbersThatAreNotFiniteAreRefusedWhereTheyAreNeeded) {
  const double nan = std::nan(""), half = 0.5, negative = -1, whole = 3;
  attribute("nan", H5T_NATIVE_DOUBLE, {}, &nan);
  attribute("half", H5T_NATIVE_DOUBLE, {}, &half);
  attribute("negative", H5T_NATIVE_DOUBLE, {}, &negative);
  attribute("whole", H5T_NATIVE_DOUBLE, {}, &whole);
  const Reader file = reader();
  for (const char* name : {"nan", "half", "negative", "absent"})
    EXPECT_THROW((void)file.counted("/", name), InputError) << name;
  EXPECT_EQ(file.counted("/", "whole"), 3);
  EXPECT_THROW((void)file.number("/", "nan"), InputError);
}

TEST_F(Foreign, ArraysThatHoldLessThanTheySayAreRefusedBeforeMemoryIsTaken) {
  const hsize_t huge[] = {1'000'000, 1'000'000, 1'000'000}, chunk[] = {100, 100, 100};
  const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(storage, 3, chunk);
  dataset("huge", H5T_NATIVE_DOUBLE, H5Screate_simple(3, huge, nullptr), storage);
  H5Pset_deflate(storage, 9);
  dataset("compressed", H5T_NATIVE_DOUBLE, H5Screate_simple(3, huge, nullptr), storage);
  const hsize_t product[] = {1ULL << 33, 1ULL << 33, 4};
  dataset("overflow", H5T_NATIVE_DOUBLE, H5Screate_simple(3, product, nullptr), storage);
  dataset("null", H5T_NATIVE_DOUBLE, H5Screate(H5S_NULL));
  dataset("scalar", H5T_NATIVE_DOUBLE, H5Screate(H5S_SCALAR));
  const Reader file = reader();
  for (const char* name : {"huge", "compressed", "overflow", "null", "scalar"})
    EXPECT_THROW((void)file.read(name), InputError) << name;
}

// 8 x 2^61 values are 0 in 64 bits; the one chunk that is there holds more than 8.
TEST_F(Foreign, ArraysWhoseNumberOfValuesOverflowsAreRefused) {
  const hsize_t written[] = {8, 8}, most[] = {8, H5S_UNLIMITED}, said[] = {8, 1ULL << 61};
  const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(storage, 2, written);
  const hid_t space = H5Screate_simple(2, written, most);
  const hid_t made =
      H5Dcreate2(file_, "overflow", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, storage, H5P_DEFAULT);
  const std::vector<double> values = count_to(64);
  ASSERT_GE(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  ASSERT_GE(H5Dset_extent(made, said), 0);
  H5Sclose(space);
  H5Dclose(made);
  EXPECT_THROW((void)reader().shape("overflow"), InputError);
}

TEST_F(Foreign, ArraysOfAnythingButNumbersAreRefused) {
  const hsize_t two[] = {2};
  dataset("text", H5T_C_S1, H5Screate_simple(1, two, nullptr));
  const hid_t pair = H5Tcreate(H5T_COMPOUND, 16);
  H5Tinsert(pair, "a", 0, H5T_NATIVE_DOUBLE);
  dataset("pair", pair, H5Screate_simple(1, two, nullptr));
  const hsize_t nine[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
  dataset("indices", H5T_NATIVE_DOUBLE, H5Screate_simple(9, nine, nullptr));
  H5Gclose(H5Gcreate2(file_, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  const Reader file = reader();
  for (const char* name : {"text", "pair", "indices", "group"})
    EXPECT_THROW((void)file.read(name), InputError) << name;
}

TEST_F(Foreign, ArraysInOtherFilesAreRefused) {
  Writer writer(folder_ / "other.h5");
  writer.write("a", {1}, count_to(1));
  writer.finish();
  H5Lcreate_external("other.h5", "/a", file_, "external", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/external", file_, "soft", H5P_DEFAULT, H5P_DEFAULT);
  const hsize_t one[] = {1};
  const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(storage, "/etc/passwd", 0, 8);
  dataset("raw", H5T_NATIVE_DOUBLE, H5Screate_simple(1, one, nullptr), storage);
  const Reader file = reader();
  for (const char* name : {"external", "soft", "raw"})
    EXPECT_THROW((void)file.read(name), InputError) << name;
}

// Every byte of a file that matters is under a checksum: where one bit is turned, the values are
// those that were written, or the file is refused.
TEST(Hdf5, NoticesATurnedBit) {
  const TemporaryFolder folder;
  const std::vector<double> values = count_to(300);
  Writer writer(folder / "f.h5");
  writer.attributes({{"t", 0.125}});
  writer.write("a", {100, 3}, values);
  writer.finish();
  const std::string whole = test::read_text(folder / "f.h5");
  int refused = 0;
  constexpr int tried = 400;
  for (int k = 0; k < tried; ++k) {
    std::string damaged = whole;
    const std::size_t bit = static_cast<std::size_t>(k) * (8 * whole.size() - 1) / tried;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    test::write_text(folder / "damaged.h5", damaged);
    try {
      const Reader reader(folder / "damaged.h5");
      EXPECT_EQ(reader.number("/", "t"), 0.125) << bit;
      EXPECT_EQ(reader.read("a", {100, 3}).values, values) << bit;
    } catch (const InputError&) {
      ++refused;
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, tried / 2);
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
