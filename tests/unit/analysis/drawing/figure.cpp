/// Pictures: drawn whole or not at all, whatever they show and whatever their texts hold.
#include "analysis/drawing/figure.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "analysis/drawing/gnuplot.hpp"
#include "common/errors.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::analysis {
namespace {

using test::failure_of;
using test::in_child;
using test::read_text;
using test::TemporaryFolder;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Figure small_figure() {
  Figure figure;
  figure.title = "small";
  figure.x = {"{/:Italic k_x L}", true, {}, {}};
  figure.y = {"growth", false, {}, {}};
  figure.lines.push_back({{1e-2, 1, 100}, {0, 1, -1}, "line", Stroke::dashed, 1, 1.5});
  figure.marks.push_back({{0.1, 10}, {0.5, 0}, "marks", Marker::circle, false, 2});
  return figure;
}

FigureField small_field() {
  return {{1, 2, 4}, {1, 3}, {-1, nan, 2, 0, 1, infinity}, "value", true};
}

void expect_whole(const std::vector<std::filesystem::path>& files) {
  ASSERT_EQ(files.size(), 2U);
  EXPECT_THAT(read_text(files[0]), StartsWith("\x89PNG\r\n"));
  EXPECT_THAT(read_text(files[1]), AllOf(StartsWith("<?xml"), EndsWith("</svg>\n\n")));
}

TEST(Figure, IsDrawnAsPngAndSvg) {
  const TemporaryFolder folder;
  const auto files = draw(small_figure(), folder / "run.v2");
  EXPECT_THAT(folder.names(), ElementsAre("run.v2.png", "run.v2.svg"));
  expect_whole(files);
  EXPECT_THAT(read_text(files[1]), AllOf(HasSubstr("small"), HasSubstr("growth"), HasSubstr("line"),
                                         HasSubstr("marks")));
}

TEST(Figure, IsDrawnTheSameEachTime) {
  const TemporaryFolder folder;
  Figure figure = small_figure();
  figure.field = small_field();
  draw(figure, folder / "a");
  draw(figure, folder / "b");
  EXPECT_EQ(read_text(folder / "a.png"), read_text(folder / "b.png"));
}

TEST(Figure, IsDrawnWhateverItShows) {
  const TemporaryFolder folder;
  const auto expect_drawn = [&](const Figure& figure) {
    expect_whole(draw(figure, folder / "figure"));
  };
  expect_drawn({});
  for (const bool is_log : {false, true}) {
    Figure figure;
    figure.x.is_log = figure.y.is_log = is_log;
    figure.lines = {{{1}, {1}, "point", Stroke::dotted, 3, 1.5}};
    expect_drawn(figure);
    figure.lines = {{{1, nan, 3, -4, 5}, {nan, 2, infinity, 1e30, 1e-30}, "", {}, 0, 1.5}};
    expect_drawn(figure);
    figure.lines = {{{nan}, {nan}, "nothing", {}, 0, 1.5}, {{}, {}, "empty", {}, -1, 1.5}};
    expect_drawn(figure);
    figure.field = small_field();
    expect_drawn(figure);
    figure.field->values.assign(6, nan);
    expect_drawn(figure);
    figure.field->values.assign(6, 0);
    figure.x.low = 2;
    figure.y.high = 1.5;
    expect_drawn(figure);
    figure.field->is_diverging = false;
    expect_drawn(figure);
  }
}

TEST(Figure, PutsTheKeyBelowWhereEveryCornerIsTaken) {
  const TemporaryFolder folder;
  Figure figure;
  figure.lines = {{{0, 1, 1, 0, 0}, {0, 0, 1, 1, 0}, "frame", Stroke::dash_dotted, 5, 1.5}};
  for (const Marker marker : {Marker::circle, Marker::square, Marker::triangle, Marker::diamond})
    figure.marks.push_back({{0.5}, {0.5}, "marks", marker, true, 7});
  expect_whole(draw(figure, folder / "figure"));
}

TEST(Figure, DrawsAFieldOfTenMillionValuesWithoutDelay) {
  const TemporaryFolder folder;
  Figure figure;
  FigureField field;
  for (int i = 0; i < 4000; ++i) field.x.push_back(i);
  for (int i = 0; i < 2500; ++i) field.y.push_back(i);
  for (const double y : field.y)
    for (const double x : field.x) field.values.push_back(std::sin(1e-2 * x) * std::cos(1e-2 * y));
  figure.field = std::move(field);
  const auto begin = std::chrono::steady_clock::now();
  expect_whole(draw(figure, folder / "figure"));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_LT(std::filesystem::file_size(folder / "figure.svg"), 4U << 20);
}

TEST(Figure, ShowsTextsAndRunsNoneOfThem) {
  const TemporaryFolder folder;
  const std::string mark = (folder / "ran").string();
  const std::vector<std::string> texts = {"'",
                                          "\"",
                                          "\\",
                                          "{",
                                          "}",
                                          "a_b^c@d&e~f",
                                          "<tag> & ]]>",
                                          "\xff\xc3",
                                          "% %d %s",
                                          "#",
                                          "$x",
                                          "",
                                          "`touch " + mark + "`",
                                          "$(touch " + mark + ")",
                                          "'; system('touch " + mark + "'); '",
                                          "'\nsystem(\"touch " + mark + "\")\n#",
                                          "\"; system(\"touch " + mark + "\"); \"",
                                          "@macro `touch " + mark + "`",
                                          "\x1b[2J\r\n\t\x7f",
                                          "旗 µ 🚩"};
  for (const std::string& text : texts) {
    Figure figure = small_figure();
    figure.title = text;
    figure.x.label = figure.y.label = plain(text);
    figure.field = small_field();
    figure.field->label = plain(text);
    figure.lines[0].label = figure.marks[0].label = plain(text);
    expect_whole(draw(figure, folder / "figure"));
  }
  EXPECT_THAT(folder.names(), ElementsAre("figure.png", "figure.svg"));
}

// Numbers whose bytes are lines of gnuplot's language, and such as make the plot command fail: read
// as commands they would leave a file.
TEST(Figure, RunsNoneOfTheNumbersItDraws) {
  const TemporaryFolder folder;
  const std::string mark = (folder / "ran").string();
  std::string commands;
  while (commands.size() < 4096) commands += fmt::format("\nsystem \"touch '{}'\"\n", mark);
  std::vector<double> numbers(commands.size() / sizeof(double));
  std::memcpy(numbers.data(), commands.data(), numbers.size() * sizeof(double));
  for (const double bad : {nan, infinity, -infinity, 1e308}) {
    Figure figure;
    figure.lines = {
        {std::vector<double>(numbers.size(), bad), numbers, "line", Stroke::solid, 0, 1}};
    figure.marks = {
        {numbers, std::vector<double>(numbers.size(), bad), "", Marker::circle, true, 0}};
    failure_of<FileError>([&] { draw(figure, folder / "figure"); });
    EXPECT_FALSE(std::filesystem::exists(mark)) << bad;
    figure.field = {{0, bad}, {0, 1}, {0, 0, 0, 0}, "field", false};
    EXPECT_THAT(failure_of<InputError>([&] { draw(figure, folder / "figure"); }),
                AllOf(HasSubstr("figure"), HasSubstr("number 2 of the grid lines along x")));
    EXPECT_FALSE(std::filesystem::exists(mark)) << bad;
  }
}

TEST(Figure, IsRefusedWhereItsFieldHasNoGrid) {
  const TemporaryFolder folder;
  const auto fault = [&](FigureField field, bool is_log) {
    Figure figure = small_figure();
    figure.x.is_log = is_log;
    figure.field = std::move(field);
    return failure_of<InputError>([&] { draw(figure, folder / "figure"); });
  };
  const std::vector<double> four(4, 0.0);
  EXPECT_THAT(fault({{2, 1}, {0, 1}, four, "", false}, false),
              HasSubstr("number 2 of the grid lines along x is 1; they must be finite, below "
                        "1e300, and increase"));
  EXPECT_THAT(fault({{1, 2}, {nan, 1}, four, "", false}, false),
              HasSubstr("number 1 of the grid lines along y is nan"));
  EXPECT_THAT(fault({{0, 1}, {0, 1}, four, "", false}, true),
              HasSubstr("number 1 of the grid lines along x is 0; they must be positive"));
  EXPECT_THAT(fault({{}, {0, 1}, {}, "", false}, false), HasSubstr("no grid line along x"));
  EXPECT_THAT(fault({{0, 1}, {0, 1}, {0, 0, 0}, "", false}, false),
              HasSubstr("the field has 3 values for 4 points"));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Figure, LeavesOutWhatIsNotFinite) {
  const TemporaryFolder folder;
  Figure figure = small_figure();
  figure.lines[0].y[0] = infinity;
  figure.lines[0].x[1] = nan;
  figure.marks[0].y[0] = -infinity;
  figure.field = small_field();
  figure.field->values[0] = infinity;
  figure.field->values[1] = nan;
  expect_whole(draw(figure, folder / "figure"));
  figure.field->values.assign(figure.field->values.size(), nan);
  expect_whole(draw(figure, folder / "figure"));
}

TEST(Figure, DoesNotDependOnTheUsersGnuplot) {
  const TemporaryFolder folder;
  draw(small_figure(), folder / "usual");
  const test::ChildEnd end = in_child([&] {
    setenv("GNUTERM", "no such terminal", 1);
    draw(small_figure(), folder / "other");
    return 0;
  });
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(read_text(folder / "other.svg"), read_text(folder / "usual.svg"));
}

TEST(Figure, ShowsAPlainTextLetterByLetter) {
  const TemporaryFolder folder;
  Figure figure;
  figure.x.label = plain("a_b^{c}@~\\d");
  const std::string svg = read_text(draw(figure, folder / "figure")[1]);
  EXPECT_THAT(svg, HasSubstr(">a_b^{c}@~\\d<"));
}

TEST(Figure, TakesAnyFileName) {
  const TemporaryFolder folder;
  const std::string name = "it's a `name` \"with\" $(all)\n\xff of it";
  expect_whole(draw(small_figure(), folder / name));
  EXPECT_THAT(folder.names(), ElementsAre(name + ".png", name + ".svg"));
}

TEST(Figure, FailsInWordsWhereTheFolderIsNotThere) {
  EXPECT_THAT(failure_of<FileError>([] { draw(small_figure(), "/absent/folder/figure"); }),
              HasSubstr("No such file or directory"));
}

TEST(Figure, FailsInWordsAndLeavesNothingOnAFullDisk) {
  const TemporaryFolder folder;
  const test::ChildEnd end = in_child([&] {
    test::have_small_disk(folder.path(), 8 << 10);
    if (failure_of<FileError>([&] { draw(small_figure(), folder / "figure"); }).empty()) return 1;
    return folder.names().empty() ? 0 : 2;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(Gnuplot, FailsInItsOwnWords) {
  const TemporaryFolder folder;
  EXPECT_THAT(failure_of<FileError>(
                  [&] { run_gnuplot("nonsense\n", PlotItems("plot"), folder / "figure.png", ""); }),
              AllOf(HasSubstr("figure.png"), HasSubstr("invalid command")));
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Gnuplot, IsNamedWhereItIsMissing) {
  const TemporaryFolder folder;
  const test::ChildEnd end = in_child([&] {
    setenv("PATH", folder.path().c_str(), 1);
    const std::string what =
        failure_of<FileError>([&] { draw(small_figure(), folder / "figure"); });
    return what.find("install gnuplot-nox") != std::string::npos ? 0 : 1;
  });
  EXPECT_EQ(end.status, 0);
}

}  // namespace
}  // namespace pennon::analysis
