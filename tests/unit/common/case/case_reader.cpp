/// The reader of case files: what each type accepts, and how it says what is wrong.
#include "common/case/case_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/support/child_process.hpp"
#include "tests/support/every_type_case.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

const std::string flag = "[flag]\nmu = 0.125\n";

// The single fault of a case whose table [types], after [flag], holds this line (line 4).
std::string fault_in_types(const std::string& line) {
  const auto faults = faults_of(flag + "[types]\n" + line + "\n");
  return faults.size() == 1 ? faults.front() : std::to_string(faults.size()) + " faults";
}

// What is thrown for a file; empty if it can be read.
std::string message_for(const std::filesystem::path& file) {
  EveryTypeCase found;
  Schema schema = found.schema();
  try {
    read_case_file(file, {}, schema).raise();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(CaseReader, ReadsAValueOfEachType) {
  EveryTypeCase found;
  found.read(flag +
             "[types]\nnumber = 2\nmaybe_number = -1.5\ninteger = 100\nis_on = true\n"
             "text = \"any # thing\"\nknown_text = 'lamb'\ntriple = [0, -1, 2.5]\n"
             "numbers = []\nintegers = [9, 0]\ntexts = [\"x\", \"y\"]\nshade = \"light\"\n"
             "maybe_shade = \"dark\"\nsweep = { from = 1, to = 100, points = 3, scale = \"log\" }\n"
             "[types.inner]\nnumber = 1e-3\n");
  EXPECT_EQ(found.flag.mu, 0.125);
  EXPECT_EQ(found.number, 2);
  EXPECT_EQ(found.maybe_number, -1.5);
  EXPECT_EQ(found.integer, 100);
  EXPECT_TRUE(found.is_on);
  EXPECT_EQ(found.text, "any # thing");
  EXPECT_EQ(found.known_text, "lamb");
  EXPECT_THAT(found.triple, ElementsAre(0, -1, 2.5));
  EXPECT_THAT(found.numbers, IsEmpty());
  EXPECT_THAT(found.integers, ElementsAre(9, 0));
  EXPECT_THAT(found.texts, ElementsAre("x", "y"));
  EXPECT_EQ(found.shade, Shade::light);
  EXPECT_EQ(found.maybe_shade, Shade::dark);
  ASSERT_TRUE(found.sweep);
  EXPECT_EQ(found.sweep->points, 3);
  EXPECT_EQ(found.sweep->scale, Scale::log);
  EXPECT_EQ(found.inner_number, 1e-3);
  EXPECT_TRUE(found.has_types && found.has_inner);
  EXPECT_FALSE(found.has_flow);
}

TEST(CaseReader, KeepsTheDefaultsOfWhatACaseLeavesOut) {
  EveryTypeCase found;
  found.read(flag + "[types]\nsweep = [1, 2, 4]\n");
  EXPECT_EQ(found.flag.K_S, 500);
  EXPECT_EQ(found.number, 0.5);
  EXPECT_FALSE(found.maybe_number);
  EXPECT_EQ(found.shade, Shade::dark);
  EXPECT_FALSE(found.maybe_shade);
  EXPECT_THAT(found.sweep->list, ElementsAre(1, 2, 4));
}

TEST(CaseReader, SaysTheValueFoundAndWhatWouldBeRight) {
  EXPECT_EQ(
      fault_in_types("number = \"2\""),
      "case.toml:4: types.number must be a finite number >= 0 and <= 10, but is '2' (a text)");
  EXPECT_THAT(fault_in_types("number = 11"), HasSubstr("must be >= 0 and <= 10, but is 11"));
  EXPECT_THAT(fault_in_types("maybe_number = true"), HasSubstr("but is true (true or false)"));
  EXPECT_THAT(fault_in_types("integer = 2.0"), HasSubstr("must be an integer >= 1 and <= 100"));
  EXPECT_THAT(fault_in_types("integer = 0"), HasSubstr("but is 0"));
  EXPECT_THAT(fault_in_types("is_on = 1"), HasSubstr("must be true or false, but is 1"));
  EXPECT_THAT(fault_in_types("text = 5"), HasSubstr("must be a text in quotes"));
  EXPECT_THAT(fault_in_types("known_text = \"lam\""),
              HasSubstr("must be one of wu, lamb, but is 'lam'; did you mean lamb?"));
  EXPECT_THAT(fault_in_types("triple = [1, 2]"), HasSubstr("must be a list of three numbers"));
  EXPECT_THAT(fault_in_types("triple = 1"), HasSubstr("must be a list of three numbers"));
  EXPECT_THAT(fault_in_types("numbers = [1, 9]"), HasSubstr("but is 9"));
  EXPECT_THAT(fault_in_types("integers = [1, 2.5]"), HasSubstr("but is 2.5"));
  EXPECT_THAT(fault_in_types("texts = [\"a\", 1]"), HasSubstr("but is 1"));
  EXPECT_THAT(fault_in_types("shade = \"darc\""),
              HasSubstr("must be one of \"dark\", \"light\", but is 'darc'; did you mean dark?"));
  EXPECT_THAT(fault_in_types("shade = 1"), HasSubstr("but is 1"));
  EXPECT_THAT(fault_in_types("number = 1979-05-27"), HasSubstr("(a date or time)"));
}

TEST(CaseReader, RefusesNumbersThatAreNotFinite) {
  for (const std::string value : {"nan", "+nan", "inf", "-inf"}) {
    EXPECT_THAT(fault_in_types("number = " + value), HasSubstr("must be a finite number")) << value;
    EXPECT_THAT(fault_in_types("numbers = [1, " + value + "]"), HasSubstr("finite")) << value;
    EXPECT_THAT(fault_in_types("sweep = [" + value + "]"), HasSubstr("finite")) << value;
  }
  EXPECT_THAT(fault_in_types("maybe_number = 1e31"), HasSubstr("of magnitude up to 1e+30"));
  EXPECT_THAT(fault_in_types("maybe_number = 1e999"), StartsWith("case.toml:4: is not TOML"));
  EXPECT_THAT(fault_in_types("integer = 9223372036854775807"), HasSubstr("9223372036854775807"));
  EXPECT_THAT(fault_in_types("integer = 9223372036854775808"), HasSubstr("is not TOML"));
}

TEST(CaseReader, SaysWhatARangeLacks) {
  EXPECT_THAT(fault_in_types("sweep = { from = 1, to = 2 }"), HasSubstr("lacks points"));
  EXPECT_THAT(fault_in_types("sweep = { from = 1, to = 2, point = 3, points = 3 }"),
              HasSubstr("has an unknown part point; did you mean points?"));
  EXPECT_THAT(fault_in_types("sweep = { from = 3, to = 2, points = 3 }"),
              HasSubstr("must have from < to, but from = 3 and to = 2"));
  EXPECT_THAT(fault_in_types("sweep = { from = 1, to = 2, points = 1 }"), HasSubstr("but is 1"));
  EXPECT_THAT(fault_in_types("sweep = { from = 1, to = 2, points = 3, scale = \"lin\" }"),
              HasSubstr("which must be \"linear\" or \"log\""));
  EXPECT_THAT(fault_in_types("sweep = []"), HasSubstr("at least one number"));
  EXPECT_THAT(fault_in_types("sweep = 1"), HasSubstr("must be a range { from = a"));
}

TEST(CaseReader, NamesTheSettingAMisspeltKeyMeans) {
  EXPECT_THAT(faults_of("[flag]\nmu = 0.1\nKB = 1e-4\n"),
              ElementsAre("case.toml:3: flag.KB is not a setting; did you mean flag.K_B?"));
  EXPECT_THAT(faults_of(flag + "Re = 100\n"),
              ElementsAre("case.toml:3: flag.Re is not a setting; did you mean flow.Re?"));
  EXPECT_THAT(faults_of(flag + "[flwo]\nU = 1\n"),
              ElementsAre("case.toml:3: flwo is not a table of a case; did you mean flow?"));
  EXPECT_THAT(faults_of(flag + "[types.iner]\nx = 1\n"),
              ElementsAre(HasSubstr("did you mean types.inner?")));
  EXPECT_THAT(faults_of(flag + "qqqqqqq = 1\n"),
              ElementsAre("case.toml:3: flag.qqqqqqq is not a setting"));
  EXPECT_THAT(faults_of(flag + "[[flow]]\nRe = 1\n"), ElementsAre(HasSubstr("must be a table")));
}

TEST(CaseReader, AsksForRequiredKeysOfTheTablesACaseHas) {
  EXPECT_THAT(faults_of("[flag]\n[flow]\n"),
              ElementsAre(AllOf(StartsWith("case.toml:1: flag.mu is missing: mass ratio"),
                                HasSubstr("must be > 0")),
                          StartsWith("case.toml:2: flow.Re is missing")));
  EXPECT_THAT(faults_of("[types]\n"), ElementsAre(StartsWith("case.toml: flag.mu is missing")));
}

TEST(CaseReader, ReportsAllFaultsAtOnceInTheOrderOfTheirLines) {
  const auto faults =
      faults_of("[types]\nnumber = 11\ntxt = 1\ninteger = \"a\"\n[flow]\nRe = -1\n[flag]\nmu = 0\n",
                {"types.shade=none", "flag"});
  ASSERT_THAT(
      faults,
      ElementsAre(StartsWith("case.toml:2: types.number"), StartsWith("case.toml:3: types.txt"),
                  StartsWith("case.toml:4: types.integer"), StartsWith("case.toml:6: flow.Re"),
                  StartsWith("case.toml:8: flag.mu"),
                  StartsWith("--set flag: must have the form table.key=value"),
                  StartsWith("--set types.shade=none: types.shade must be one of")));
}

TEST(CaseReader, ShowsNamesAndValuesShortAndWithoutControlCharacters) {
  const std::string long_name(5000, 'k');
  const auto faults =
      faults_of(flag + long_name + "1 = 1\n" + long_name + "2 = 2\n\"\\u001b[2J\" = 3\n\"\" = 4\n" +
                "[types]\ntext = [\"" + std::string(5000, 'v') + "\"]\n");
  ASSERT_EQ(faults.size(), 5U);
  for (const std::string& fault : faults) {
    EXPECT_LT(fault.size(), 300U);
    EXPECT_EQ(fault.find('\x1b'), std::string::npos);
  }
  EXPECT_THAT(faults[0], StartsWith("case.toml:3: "));
  EXPECT_THAT(faults[1], StartsWith("case.toml:4: "));
}

TEST(CaseReader, CutsALongValueBetweenTwoLetters) {
  for (int shift = 0; shift < 3; ++shift) {
    std::string value(shift, 'a');
    for (int i = 0; i < 100; ++i) value += "\u20ac";
    const std::string fault = fault_in_types("number = \"" + value + "\"");
    const std::size_t end = fault.find("...");
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(fault.substr(end - 3, 3), "\u20ac");
  }
}

TEST(CaseReader, DoesNotTakeAQuotedNameWithADotForATableAndAKey) {
  EXPECT_THAT(
      faults_of("\"flag.mu\" = 0.1\n"),
      ElementsAre(HasSubstr("flag.mu is missing"), HasSubstr("'flag.mu' is not a setting")));
}

TEST(CaseReader, RefusesNamesThatNestTooDeepForTheParser) {
  std::string name = "a";
  for (int i = 0; i < 300000; ++i) name += ".a";
  const std::string what = "no name has more than";
  EXPECT_THAT(faults_of(flag + name + " = 1\n"),
              ElementsAre(AllOf(StartsWith("case.toml:3: "), HasSubstr(what))));
  EXPECT_THAT(faults_of("[" + name + "]\n"), ElementsAre(HasSubstr(what)));
  EXPECT_THAT(faults_of("x = '''\n''' # \"\n[" + name), ElementsAre(StartsWith("case.toml:3: ")));
  EXPECT_THAT(faults_of("x = {y = \"\"\"\"\"\"\"\", " + name + " = 1}"),
              ElementsAre(HasSubstr(what)));
  EXPECT_THAT(faults_of(flag, {name + "=1"}), ElementsAre(HasSubstr("must have the form")));
  EXPECT_THAT(faults_of(flag, {"flag.mu=1\n[" + name + "]"}), ElementsAre(HasSubstr("flag.mu")));
}

TEST(CaseReader, RefusesValuesThatNestTooDeep) {
  const std::string open(100000, '[');
  EXPECT_THAT(faults_of(flag + "K_B = " + open), ElementsAre(HasSubstr("is not TOML")));
  EXPECT_THAT(faults_of(flag, {"flag.K_B=" + open}), ElementsAre(HasSubstr("a finite number")));
}

TEST(CaseReader, TakesDotsInTextsAndNumbersForWhatTheyAre) {
  std::string dots(1000, '.');
  EXPECT_THAT(faults_of(flag + "# " + dots + "\n[types]\ntext = \"" + dots + "\\\"" + dots +
                        "\"\ntexts = ['" + dots + "', '''" + dots + "''']\nnumbers = [0.1, 0.2]\n"),
              IsEmpty());
}

TEST(CaseReader, SaysWhereATextIsNotToml) {
  EXPECT_THAT(faults_of("[flag]\nmu = = 1\n"), ElementsAre(StartsWith("case.toml:2: is not TOML")));
  EXPECT_THAT(faults_of("[flag]\nmu = 1\nmu = 2\n"),
              ElementsAre(StartsWith("case.toml:3: is not")));
  EXPECT_THAT(faults_of(""), ElementsAre(StartsWith("case.toml: is empty")));
  EXPECT_THAT(faults_of("# only a comment\n"), ElementsAre(HasSubstr("is empty")));
  EXPECT_THAT(faults_of(std::string("[flag]\0mu", 9)), ElementsAre(HasSubstr("binary data")));
  EXPECT_THAT(faults_of("\xff\xfe\x01garbage"), ElementsAre(HasSubstr("is not TOML")));
}

TEST(CaseReader, ReadsOverridesLikeTheFile) {
  EveryTypeCase found;
  found.read(flag, {"flag.mu=0.5", "flow.Re=100", "types.known_text=lamb", "types.texts=['a']",
                    "types.inner={ number = 3 }", "types.text=a = b", "flag.mu=0.75"});
  EXPECT_EQ(found.flag.mu, 0.75);
  EXPECT_EQ(found.flow.Re, 100);
  EXPECT_TRUE(found.has_flow);
  EXPECT_EQ(found.known_text, "lamb");
  EXPECT_EQ(found.inner_number, 3);
  EXPECT_EQ(found.text, "a = b");
}

TEST(CaseReader, NamesTheOverrideAFaultIsIn) {
  EXPECT_THAT(faults_of(flag, {"flag.mu=-1"}),
              ElementsAre(StartsWith("--set flag.mu=-1: flag.mu")));
  EXPECT_THAT(faults_of(flag, {"flag.KB=1"}),
              ElementsAre("--set flag.KB=1: flag.KB is not a setting; did you mean flag.K_B?"));
  EXPECT_THAT(faults_of(flag, {"types.inner={ nmber = 3 }"}),
              ElementsAre(StartsWith("--set types.inner={ nmber = 3 }: types.inner.nmber")));
  EXPECT_THAT(faults_of(flag, {"flow.U=1"}),
              ElementsAre(StartsWith("--set flow.U=1: flow.Re is missing")));
  EXPECT_THAT(faults_of(flag, {"flag.mu.x=1"}),
              ElementsAre(HasSubstr("is a value and not a table")));
  for (const std::string bad : {"", "=", "mu=1", "flag.mu", ".mu=1", "flag.=1", "flag..mu=1"})
    EXPECT_THAT(faults_of(flag, {bad}), ElementsAre(HasSubstr("must have the form"))) << bad;
  EXPECT_THAT(faults_of(flag, {"types.text=\xff"}), ElementsAre(HasSubstr("is not text in UTF-8")));
  EXPECT_THAT(faults_of(flag, {"flag.mu="}), ElementsAre(HasSubstr("must be a finite number")));
}

TEST(CaseReader, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_for(folder / "absent.toml"), HasSubstr("there is no such file"));
  EXPECT_THAT(message_for(folder.path()), HasSubstr("is a folder"));
  const auto file = write_text(folder / "case.toml", flag);
  EXPECT_EQ(message_for(file), "");
  EXPECT_THAT(message_for(file / "inside"), HasSubstr("there is no such file"));
  EXPECT_THAT(message_for(folder / std::string(300, 'n')), HasSubstr("File name too long"));
  EXPECT_THAT(message_for(write_text(folder / "empty.toml", "")), HasSubstr("is empty"));
  EXPECT_THAT(message_for(write_text(folder / "large.toml", std::string(2 << 20, '#'))),
              HasSubstr("a case file has at most 1048576"));
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THAT(message_for(folder / "pipe"), HasSubstr("is not a regular file"));
}

TEST(CaseReader, SaysThatAFileMayNotBeRead) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "case.toml", flag);
  ASSERT_EQ(chmod(file.c_str(), 0), 0);
  ASSERT_EQ(chmod(folder.path().c_str(), 0755), 0);
  const ChildEnd end = in_child([&] {
    constexpr uid_t nobody = 65534;
    if (getuid() == 0 && setuid(nobody) != 0) return 1;
    return message_for(file).find("Permission denied") != std::string::npos ? 0 : 2;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(CaseReader, AnswersALargeFileOfFaultsWithoutDelay) {
  std::string text = flag;
  while (text.size() < (1U << 20) - 100) text += fmt::format("k{} = 1\n", text.size());
  EXPECT_GT(faults_of(text).size(), 50000U);
}

}  // namespace
}  // namespace pennon::test
