/// How far long work has come, on a terminal and in a log.
#include "common/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "tests/support/captured_errors.hpp"

namespace pennon::test {
namespace {

using ::testing::HasSubstr;
using Target = CapturedErrors::Target;

void outlast_the_quiet() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1050));
}

TEST(Progress, IsSilentWhileWorkIsShort) {
  const CapturedErrors errors(Target::terminal);
  {
    Progress progress("map", 100, true);
    for (int i = 0; i <= 100; ++i) progress.advance_to(i);
  }
  EXPECT_EQ(errors.text(), "");
}

TEST(Progress, DrawsABarOnATerminalAndWipesItAtTheEnd) {
  const CapturedErrors errors(Target::terminal);
  {
    Progress progress("map", 100, true);
    outlast_the_quiet();
    progress.advance_to(25);
    EXPECT_EQ(errors.text(),
              "\r\x1b[Kmap [==========                              ]  25 %  3 s left");
    progress.advance_to(26);
    EXPECT_EQ(errors.text(), "");
  }
  EXPECT_EQ(errors.text(), "\r\x1b[K");
}

TEST(Progress, SurvivesCountsBeyondItsTotal) {
  const CapturedErrors errors(Target::terminal);
  Progress over("a", 10, true);
  Progress far_over("b", 1, true);
  Progress under("c", 10, true);
  Progress none("d", 0, true);
  outlast_the_quiet();
  over.advance_to(11);
  EXPECT_THAT(errors.text(), HasSubstr("] 100 %"));
  far_over.advance_to(std::numeric_limits<std::int64_t>::max());
  EXPECT_THAT(errors.text(), HasSubstr("] 100 %"));
  under.advance_to(-5);
  EXPECT_THAT(errors.text(), HasSubstr("]   0 %"));
  none.advance_to(1);
  EXPECT_EQ(errors.text(), "");
}

TEST(Progress, IsSilentWhereItIsNotToBeShownAndInAYoungLog) {
  const CapturedErrors errors(Target::log);
  Progress hidden("a", 10, false);
  Progress logged("b", 10, true);
  outlast_the_quiet();
  hidden.advance_to(5);
  logged.advance_to(5);
  EXPECT_EQ(errors.text(), "");
}

}  // namespace
}  // namespace pennon::test
