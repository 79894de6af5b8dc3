/// The record of what made a result.
#include "common/record/record.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "common/record/version.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

TEST(Record, SaysWhatMadeAResult) {
  const TemporaryFolder folder;
  Record record("pennon lsa 'a case.toml'");
  { const Record::Timer timer = record.time("read"); }
  { const Record::Timer timer = record.time("compute"); }
  { const Record::Timer timer = record.time("compute"); }
  record.write(folder / "record.json", 1);
  const auto json = nlohmann::json::parse(read_text(folder / "record.json"));
  EXPECT_EQ(json.at("pennon").at("version"), version());
  EXPECT_EQ(json.at("pennon").at("commit"), commit());
  EXPECT_EQ(json.at("command"), "pennon lsa 'a case.toml'");
  EXPECT_EQ(json.at("ranks"), 1);
  EXPECT_GT(json.at("peak_memory_kB"), 1000);
  EXPECT_EQ(json.at("libraries").size(), library_versions().size());
  EXPECT_EQ(json.at("wall_s").size(), 3U);
  EXPECT_GE(json.at("wall_s").at("total"), json.at("wall_s").at("compute"));
}

// tail keeps what has no end of line.
TEST(Record, CountsTheMemoryOfProgramsThatWereStarted) {
  const TemporaryFolder folder;
  ASSERT_EQ(std::system("head -c 100000000 /dev/zero | tail -n 1 > /dev/null"), 0);
  Record("pennon modes case.toml").write(folder / "record.json", 1);
  const auto json = nlohmann::json::parse(read_text(folder / "record.json"));
  EXPECT_GT(json.at("peak_memory_kB"), 90'000);
}

TEST(Record, IsWrittenWhateverTheCommandLineHolds) {
  const TemporaryFolder folder;
  Record("pennon lsa \xff\xfe.toml").write(folder / "record.json", 1);
  EXPECT_TRUE(nlohmann::json::accept(read_text(folder / "record.json")));
}

}  // namespace
}  // namespace pennon::test
