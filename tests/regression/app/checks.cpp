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

// What a run would refuse once it builds its grid, its flag or its start, --check refuses with the
// line of the key.
TEST_F(Checks, OfTheSimulationBuildWhatItStartsWith) {
  const std::string file = case_file(
      "[flag]\nmu = 0.1\n[flow]\nRe = 100\n[dns]\nn_rho = 24\nn_theta = 48\n"
      "wall_spacing = 0.03\n[dns.initial]\nA = [0.05]\n");
  const auto expect_refused = [&](const std::string& setting, const std::string& sentence) {
    expect_fault({"dns", file, "--check", "--set", setting}, sentence);
    expect_fault({"dns", file, "--set", setting}, sentence);
  };
  EXPECT_EQ(pennon({"dns", file, "--check"}).status, done);
  expect_refused("dns.n_rho=6", "case.toml:8: dns.wall_spacing = 0.03 does not reach dns.R");
  expect_refused("dns.initial.A=[1.0]", "case.toml:9: dns.initial makes a shape that is steeper");
  test::write_text(folder_ / "junk.h5", "junk");
  expect_fault({"dns", file, "--check", "--set", "dns.initial.A=[]", "--set",
                "dns.initial.mode_amplitude=1e-4", "--set",
                "dns.initial.global_modes=" + (folder_ / "junk.h5").string()},
               "junk.h5: is not an HDF5 file");
}

TEST_F(Checks, SayHowMuchMemoryTheFieldsTake) {
  expect_fault(
      {"dns", case_file("[flag]\nmu = 0.1\ngamma = 1\n[flow]\nRe = 100\n[dns]\n"
                        "n_x = 1000\nn_rho = 1000\nn_theta = 1000\n")},
      "dns.n_rho = 1000 makes 1e+09 cells with n_theta and n_x, which take some 9.1e+02 GB");
}

TEST_F(Checks, NameThePartOfARangeThatIsWrong) {
  expect_fault({"lsa", case_file("[flag]\nmu = 0.1\n[flow]\nRe = 100\n[lsa.curve]\n"
                                 "k_x = { from = 1, to = 2, points = 0 }\n")},
               "lsa.curve.k_x has a range whose points must be >= 2");
}

TEST_F(Checks, SayWhichSettingsHaveNoEffect) {
  const auto notes = [&](const std::string& command, const std::string& text) {
    const Outcome outcome = pennon({command, case_file(text), "--check"});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return outcome.out.substr(0, outcome.out.find("\n["));
  };
  const std::string flag = "[flag]\nmu = 0.1\n", flow = "[flow]\nRe = 100\n",
                    clamped = "[flag]\nmu = 0.1\nleading_edge = \"clamped\"\n",
                    bent = "[dns.initial]\nA = [0.1]\n",
                    motion = "[dns.motion]\nkind = \"heave\"\namplitude = 0.1\n";
  EXPECT_THAT(notes("lsa", clamped + flow), HasSubstr("# Note: flag.leading_edge"));
  EXPECT_THAT(notes("lsa", flag + flow), Not(HasSubstr("Note")));
  EXPECT_THAT(notes("modes", clamped + flow), HasSubstr("# Note: flag.leading_edge"));
  EXPECT_THAT(notes("modes", flag), HasSubstr("have omega = 0"));
  EXPECT_THAT(notes("dns", flag + flow), HasSubstr("starts flat and nothing disturbs it"));
  EXPECT_THAT(notes("dns", flag), HasSubstr("nothing acts on it"));
  EXPECT_THAT(notes("dns", flag + flow + bent), Not(HasSubstr("Note")));
  EXPECT_THAT(notes("dns", flag + flow + bent + motion), HasSubstr("[dns.initial] has no effect"));
  expect_fault({"dns", case_file(flag + motion)}, "dns.motion moves a flag in a flow, but [flow]");
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
