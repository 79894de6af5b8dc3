/// What a command needs is checked before it computes, whether the case names it or not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/commands.hpp"

namespace pennon {
namespace {

using test::bad_input;
using test::done;
using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Checks : public test::Commands {
 protected:
  std::string case_file(const std::string& text) {
    return test::write_text(folder_ / "case.toml", text).string();
  }
  void expect_fault(const std::vector<std::string>& arguments, const std::string& sentence) {
    std::vector<std::string> words = arguments;
    words.insert(words.end(), {"--output", results()});
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, bad_input) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_FALSE(std::filesystem::exists(results())) << "nothing is computed or written";
  }
};

TEST_F(Checks, OfTheSimulationNeedNoTableOfItsOwn) {
  expect_fault({"dns", case_file("[flag]\nmu = 0.1\ngravity = [1, 0, 0]\n")},
               "flag.gravity acts along x, but without flag.gamma the flag is two-dimensional");
}

TEST_F(Checks, OfTheGlobalModesThatCompareFindsNeedNoTableOfTheirOwn) {
  expect_fault({"compare", case_file("[flag]\nmu = 0.1\ngravity = [0, 1, 0]\n[flow]\nRe = 100\n")},
               "[modes.global] does not know flag.gravity: it must be 0");
}

TEST_F(Checks, OfTheNormalModesKnowThoseThatTheSimulationNeeds) {
  const std::string modes = "[modes.normal]\nfamily = \"in_vacuo\"\nelements = 20\n";
  const std::string flag = "[flag]\nmu = 0.1\nK_B = 0.01\n", flow = "[flow]\nRe = 100\n";
  const std::string sentence =
      ".m = 11 is too many for modes.normal.elements = 20: two elements a mode are the least; take "
      "22 or more";
  expect_fault({"dns", case_file(flag + modes + "[dns.initial]\nmode_amplitude = 0.1\nm = 11\n")},
               "dns.initial" + sentence);
  expect_fault({"dns", case_file(flag + flow + modes + "[dns.motion]\nkind = \"mode\"\nm = 11\n")},
               "dns.motion" + sentence);
}

TEST_F(Checks, OfTheGlobalModesKnowTheGridTheyTakeFromTheSimulation) {
  expect_fault({"modes", case_file("[flag]\nmu = 0.1\n[flow]\nRe = 100\n[dns]\nn_rho = "
                                   "5000\n[modes.global]\n")},
               "modes.global.n_rho = 5000, which dns.n_rho gives, is more than 2000");
}

// What is asked for stands in the resolved case with its defaults, as if it had been given.
TEST_F(Checks, EchoTheTablesOfWhatIsAskedFor) {
  const std::string file = case_file("[flag]\nmu = 0.1\n[flow]\nRe = 100\n");
  const auto echo = [&](const char* command) {
    const Outcome outcome = pennon({command, file, "--check"});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(echo("dns"), AllOf(HasSubstr("[dns]"), Not(HasSubstr("[lsa]"))));
  EXPECT_THAT(echo("lsa"), AllOf(HasSubstr("[lsa]"), Not(HasSubstr("[dns]\n"))));
  EXPECT_THAT(echo("modes"), AllOf(HasSubstr("[modes.normal]"), Not(HasSubstr("[modes.global]"))));
  EXPECT_THAT(echo("compare"), AllOf(HasSubstr("[compare]"), HasSubstr("[modes.global]\n")));
}

}  // namespace
}  // namespace pennon
