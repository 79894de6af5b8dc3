/// Reading what a coupled run left, and what is said of files that are not that.
#include "analysis/signal/run_history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/synthetic_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::analysis {
namespace {

using testing::HasSubstr;

RunHistory some_run() {
  RunHistory run = test::synthetic_run(test::unequal_times(1, 0.02), 2, 4,
                                       [](double x, double t) { return x + 10 * t; });
  test::add_probe(
      run, 2, 0.25, [](double x, double t) { return x * t; },
      [](double x, double t) { return x - t; });
  return run;
}

class ReadRun : public testing::Test {
 protected:
  std::string fault_of(const RunHistory& run, const std::string& kind = "coupled_history") {
    test::write_history(run, folder_ / "history.h5", kind);
    return test::failure_of<InputError>([&] { read_run_history(folder_.path()); });
  }
  test::TemporaryFolder folder_;
};

TEST_F(ReadRun, GivesBackWhatWasWritten) {
  const RunHistory run = some_run();
  test::write_history(run, folder_ / "history.h5");
  const RunHistory read = read_run_history(folder_.path());
  EXPECT_EQ(read.span, 2);
  EXPECT_EQ(read.t, run.t);
  EXPECT_EQ(read.z, run.z);
  EXPECT_EQ(read.columns, run.columns);
  ASSERT_EQ(read.probes.size(), 1U);
  EXPECT_EQ(read.probes[0].y, 2);
  EXPECT_EQ(read.probes[0].z, 0.25);
  EXPECT_EQ(read.probes[0].v, run.probes[0].v);
  EXPECT_EQ(read.probes[0].w, run.probes[0].w);
}

TEST_F(ReadRun, LeavesOutAProbeOutsideTheGrid) {
  RunHistory run = some_run();
  run.probes.push_back(run.probes[0]);
  run.probes[0].w[2][5] = std::numeric_limits<double>::quiet_NaN();
  run.probes[1].y = 3;
  test::write_history(run, folder_ / "history.h5");
  const RunHistory read = read_run_history(folder_.path());
  ASSERT_EQ(read.probes.size(), 1U);
  EXPECT_EQ(read.probes[0].y, 3);
}

TEST_F(ReadRun, SaysThatThereIsNoFolderOrNoHistory) {
  const auto fault = [](const std::filesystem::path& folder) {
    return test::failure_of<InputError>([&] { read_run_history(folder); });
  };
  EXPECT_THAT(fault(folder_ / "none"), HasSubstr("none: there is no such folder"));
  EXPECT_THAT(fault(folder_.path()), HasSubstr("has no history.h5"));
}

TEST_F(ReadRun, SaysWhatAFileHoldsThatIsNoCoupledRun) {
  EXPECT_THAT(fault_of(some_run(), "fluid_history"), HasSubstr("holds fluid_history"));
}

TEST_F(ReadRun, NamesAColumnThatIsMissing) {
  RunHistory run = some_run();
  run.columns.erase("flag_defect");
  EXPECT_THAT(fault_of(run), HasSubstr("has no column flag_defect"));
}

TEST_F(ReadRun, NamesTheRowWhereTimeDoesNotIncrease) {
  RunHistory run = some_run();
  run.columns["t"][7] = run.columns["t"][6];
  EXPECT_THAT(fault_of(run), HasSubstr("in row 7 of /history"));
}

TEST_F(ReadRun, NamesTheRowWhereTheRunBlewUp) {
  RunHistory run = some_run();
  run.columns["C_D"][9] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(fault_of(run), HasSubstr("has nan for C_D in row 9"));
  run = some_run();
  run.z[1][4] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(fault_of(run), HasSubstr("has inf for /trailing_edge in row 4"));
}

TEST_F(ReadRun, SaysThatAHistoryIsTooShort) {
  const RunHistory run =
      test::synthetic_run({0, 0.1, 0.2}, 1, 1, [](double, double) { return 0.0; });
  EXPECT_THAT(fault_of(run), HasSubstr("has 3 rows, but the analysis needs 16"));
}

TEST_F(ReadRun, NamesAnArrayOfAnotherLength) {
  RunHistory run = some_run();
  test::write_history(run, folder_ / "history.h5");
  hdf5::Writer file(folder_ / "history.h5");
  file.attributes({{"kind", "coupled_history"}, {"span", 2.0}});
  const hdf5::Shape shape = {run.t.size(), run.columns.size()};
  std::string names;
  for (const auto& [name, column] : run.columns) names += (names.empty() ? "" : ",") + name;
  std::vector<double> values(run.t.size() * run.columns.size(), 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(k);
  file.write("/history", shape, values, {{"columns", names}});
  file.write("/trailing_edge", {2, 1, 3}, std::vector<double>(6, 0.0));
  file.finish();
  EXPECT_THAT(test::failure_of<InputError>([&] { read_run_history(folder_.path()); }),
              HasSubstr("has an array /trailing_edge of 2 x 1 x 3, where 60 x n x 3 is needed"));
}

}  // namespace
}  // namespace pennon::analysis
