/// Files to which a run only appends: what was synced is read back, what stands behind it is cut,
/// and another file is refused.
#include "common/io/record_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <utility>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using test::failure_of;
using testing::HasSubstr;
using Records = std::vector<std::pair<std::uint32_t, std::vector<double>>>;

class RecordFiles : public testing::Test {
 protected:
  static Records read(const fs::path& path, const RecordsEnd& end) {
    Records records;
    read_records(path, end, [&](std::uint32_t kind, std::span<const double> values) {
      records.emplace_back(kind, std::vector<double>(values.begin(), values.end()));
    });
    return records;
  }
  fs::path path_of(const RecordsEnd& end) const { return folder_ / records_name("rows", end.file); }
  Records read(const RecordsEnd& end) const { return read(path_of(end), end); }
  std::string refusal(const RecordsEnd& end) const {
    return failure_of<InputError>([&] { read(end); });
  }

  test::TemporaryFolder folder_;
};

TEST_F(RecordFiles, HoldWhatWasAddedInItsOrder) {
  RecordFile file(folder_.path(), "rows");
  const Records expected = {{1, {0.1, -2e300}}, {7, {}}, {2, {3, 4, 5}}};
  for (const auto& [kind, values] : expected) file.add(kind, values);
  EXPECT_EQ(read(file.flush()), expected);
}

// What a checkpoint costs does not depend on what was kept before.
TEST_F(RecordFiles, GrowByWhatIsAddedAlone) {
  RecordFile file(folder_.path(), "rows");
  const std::vector<double> values(50, 1.5);
  file.add(1, values);
  RecordsEnd before = file.flush();
  for (int k = 0; k < 20; ++k) {
    file.add(1, values);
    const RecordsEnd end = file.flush();
    constexpr std::size_t around = 2;  // kind and count, checksum
    EXPECT_EQ(end.bytes - before.bytes, (values.size() + around) * sizeof(double));
    EXPECT_EQ(fs::file_size(path_of(end)), end.bytes);
    before = end;
  }
  EXPECT_EQ(read(before).size(), 21U);
}

TEST_F(RecordFiles, AreReadUpToAnEarlierEndToo) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0});
  const RecordsEnd first = file.flush();
  file.add(1, std::vector{2.0});
  file.flush();
  EXPECT_EQ(read(first), (Records{{1, {1.0}}}));
}

TEST_F(RecordFiles, LoseATornTailWhenTheyAreWrittenOn) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0, 2.0});
  const RecordsEnd end = file.flush();
  const std::string whole = test::read_text(path_of(end));
  for (const std::size_t torn : {1U, 8U, 11U, 40U}) {
    test::write_text(path_of(end), whole + std::string(torn, '\x7f'));
    EXPECT_EQ(read(end), (Records{{1, {1.0, 2.0}}}));
    RecordFile again(folder_.path(), "rows", end);
    again.add(2, std::vector{3.0});
    const RecordsEnd later = again.flush();
    EXPECT_EQ(fs::file_size(path_of(end)), later.bytes);
    EXPECT_EQ(read(later), (Records{{1, {1.0, 2.0}}, {2, {3.0}}}));
  }
}

TEST_F(RecordFiles, LoseRecordsOfALaterTimeWhenTheyAreWrittenOn) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0});
  const RecordsEnd first = file.flush();
  for (double t = 2; t < 10; ++t) file.add(1, std::vector{t});
  const RecordsEnd later = file.flush();
  RecordFile again(folder_.path(), "rows", first);
  again.add(1, std::vector{1.5});
  EXPECT_EQ(read(again.flush()), (Records{{1, {1.0}}, {1, {1.5}}}));
  EXPECT_THAT(refusal(later), HasSubstr("it was cut"));
}

// Of the same length and the same own number.
TEST_F(RecordFiles, RefuseAnEndThatAnotherRunWroteOver) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0});
  const RecordsEnd first = file.flush();
  file.add(1, std::vector{2.0});
  const RecordsEnd later = file.flush();
  RecordFile again(folder_.path(), "rows", first);
  again.add(1, std::vector{3.0});
  const RecordsEnd other = again.flush();
  EXPECT_EQ(other.bytes, later.bytes);
  EXPECT_THAT(refusal(later), HasSubstr("written on by another run"));
  EXPECT_EQ(read(other).size(), 2U);
}

TEST_F(RecordFiles, RefuseToBeAnotherOrNone) {
  RecordFile one(folder_.path(), "rows"), two(folder_.path(), "rows");
  one.add(1, std::vector{1.0});
  two.add(1, std::vector{1.0});
  const RecordsEnd first = one.flush(), second = two.flush();
  EXPECT_NE(first.file, second.file);
  fs::rename(path_of(second), path_of(first));
  EXPECT_THAT(refusal(first), HasSubstr("is another file"));
  EXPECT_THAT(refusal(second), HasSubstr("there is no such file"));
  fs::remove(path_of(first));
  fs::create_directory(path_of(first));
  EXPECT_NE(refusal(first), "");
  fs::remove(path_of(first));
  ASSERT_EQ(mkfifo(path_of(first).c_str(), 0600), 0);
  EXPECT_THAT(refusal(first), HasSubstr("it was cut"));
}

TEST_F(RecordFiles, NoticeEveryTurnedBitAndEveryMissingByte) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0, 2.0});
  file.add(2, std::vector{0.0});
  const RecordsEnd end = file.flush();
  const std::string whole = test::read_text(path_of(end));
  ASSERT_EQ(whole.size(), end.bytes);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string turned = whole;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << (bit % 8)));
    test::write_text(path_of(end), turned);
    EXPECT_NE(refusal(end), "") << "bit " << bit;
  }
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::write_text(path_of(end), whole.substr(0, length));
    EXPECT_THAT(refusal(end), HasSubstr("it was cut")) << length;
  }
}

// An end that a damaged checkpoint may name.
TEST_F(RecordFiles, RefuseEndsThatAreNone) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0, 2.0});
  file.add(2, std::vector{0.0});
  const RecordsEnd end = file.flush();
  for (std::uint64_t bytes = 0; bytes < end.bytes; ++bytes)
    EXPECT_NE(refusal({end.file, bytes, end.checksum}), "") << bytes;
  for (const std::uint64_t bytes : {end.bytes + 8, ~std::uint64_t{0}, ~std::uint64_t{7}})
    EXPECT_NE(refusal({end.file, bytes, end.checksum}), "") << bytes;
  EXPECT_NE(refusal({end.file, end.bytes, end.checksum + 1}), "");
}

TEST_F(RecordFiles, FollowNoSymbolicLink) {
  RecordFile file(folder_.path(), "rows");
  file.add(1, std::vector{1.0});
  const RecordsEnd end = file.flush();
  const fs::path elsewhere = folder_ / "elsewhere";
  fs::rename(path_of(end), elsewhere);
  fs::create_symlink(elsewhere, path_of(end));
  const std::string before = test::read_text(elsewhere);
  EXPECT_NE(refusal(end), "");
  file.add(1, std::vector{2.0});
  EXPECT_THROW(file.flush(), FileError);
  EXPECT_EQ(test::read_text(elsewhere), before);
}

TEST_F(RecordFiles, RemoveThoseOfEarlierRunsAndNothingElse) {
  RecordFile earlier(folder_.path(), "rows"), other(folder_.path(), "more_rows"),
      file(folder_.path(), "rows");
  const RecordsEnd gone = earlier.flush(), stays = other.flush(), own = file.flush();
  test::write_text(folder_ / "rows_mine.rows", "");
  file.remove_others();
  std::vector<std::string> expected = {"rows_mine.rows", records_name("rows", own.file),
                                       records_name("more_rows", stays.file)};
  std::ranges::sort(expected);
  EXPECT_EQ(folder_.names(), expected);
  EXPECT_FALSE(fs::exists(path_of(gone)));
}

}  // namespace
}  // namespace pennon
