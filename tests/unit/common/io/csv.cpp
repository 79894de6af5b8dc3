/// Tables as CSV.
#include "common/io/csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;

class Csv : public ::testing::Test {
 protected:
  CsvTable table(const std::string& text) {
    return CsvTable(write_text(folder_ / "table.csv", text));
  }
  TemporaryFolder folder_;
};

TEST_F(Csv, ReadsCellsByColumnAndSkipsCommentsAndEmptyLines) {
  const CsvTable read = table("# source\n\nname, mu ,growth\r\nA, 0.1 ,-2e-3\n\n# more\nB,,7");
  ASSERT_EQ(read.rows(), 2U);
  EXPECT_EQ(read.text(0, read.column("name")), "A");
  EXPECT_EQ(read.number(0, read.column("mu")), 0.1);
  EXPECT_EQ(read.number(0, read.column("growth")), -2e-3);
  EXPECT_EQ(read.number(1, read.column("mu")), std::nullopt);
  EXPECT_THAT(read.place(1), EndsWith("table.csv:7"));
}

TEST_F(Csv, SaysWhichLineIsAtFault) {
  EXPECT_THAT(failure_of<InputError>([&] { table("a,b\n1,2\n1,2,3\n"); }),
              HasSubstr("table.csv:3: has 3 cells, but the header names 2 columns"));
  const CsvTable read = table("a,b\nx,nan\n1e999,1\n");
  EXPECT_THAT(failure_of<InputError>([&] { (void)read.number(0, 0); }),
              HasSubstr("table.csv:2: a must be a finite number, but is \"x\""));
  EXPECT_NE(failure_of<InputError>([&] { (void)read.number(0, 1); }), "");
  EXPECT_NE(failure_of<InputError>([&] { (void)read.number(1, 0); }), "");
  EXPECT_THAT(failure_of<InputError>([&] { (void)read.column("c"); }),
              HasSubstr("has no column c; its columns are a, b"));
}

TEST_F(Csv, ReadsWhatSpreadsheetsWrite) {
  const CsvTable read =
      table("\xef\xbb\xbfname,\"mu\"\r\n\"A, \"\"first\"\"\",0.5\r\n \"\" , \"2\" \n");
  EXPECT_EQ(read.text(0, read.column("name")), "A, \"first\"");
  EXPECT_EQ(read.number(0, read.column("mu")), 0.5);
  EXPECT_EQ(read.text(1, 0), "");
  EXPECT_EQ(read.number(1, 1), 2);
  for (const char* open : {"a,b\n\"x,1\n", "a,b\n1,\"x\n2,3\n", "a,b\n\"x\"y,1\n", "\"a,b\n"})
    EXPECT_THAT(failure_of<InputError>([&] { table(open); }),
                HasSubstr("has a quoted cell that does not end"))
        << open;
}

TEST_F(Csv, RefusesColumnsThatAreNotKnownAndRowsThatAreRepeated) {
  EXPECT_THAT(failure_of<InputError>([&] { table("a,b,a\n"); }),
              HasSubstr("table.csv:1: names the column a twice"));
  const CsvTable read = table("t,y,z\n0,1,2\n0.0,3,2\n1,1,2.0\n");
  EXPECT_THAT(failure_of<InputError>([&] {
                read.expect_only({"y", "z"});
              }),
              HasSubstr("has columns that are not known here: t; it must have y, z"));
  EXPECT_NO_THROW(read.expect_only({"t", "y", "z"}));
  EXPECT_NO_THROW(read.expect_each_once({"t", "y"}, "the place"));
  EXPECT_THAT(failure_of<InputError>([&] {
                read.expect_each_once({"y", "z"}, "the place");
              }),
              HasSubstr("table.csv:4: repeats the place of line 2; each stands once"));
}

TEST_F(Csv, SaysWhyThereIsNoTable) {
  EXPECT_THAT(failure_of<InputError>([&] { CsvTable(folder_ / "absent.csv"); }),
              HasSubstr("no such file"));
  EXPECT_THAT(failure_of<InputError>([&] { CsvTable(folder_.path()); }), HasSubstr("no such file"));
  EXPECT_THAT(failure_of<InputError>([&] { table("# nothing\n\n"); }), HasSubstr("is empty"));
}

TEST_F(Csv, WritesNumbersThatReadBackToTheSameBits) {
  std::mt19937_64 random(11);
  CsvText written("random doubles", {"name", "value"});
  std::vector<double> values = {0.0, -0.0, std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::max()};
  while (values.size() < 1000)
    if (const double value = std::bit_cast<double>(random()); std::isfinite(value))
      values.push_back(value);
  for (const double value : values) written.row({value}, {"x"});
  written.row({std::nan("")}, {"none"});
  const CsvTable read = table(written.text());
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(std::bit_cast<std::uint64_t>(*read.number(i, 1)),
              std::bit_cast<std::uint64_t>(values[i]));
  EXPECT_FALSE(read.number(values.size(), 1));
}

}  // namespace
}  // namespace pennon::test
