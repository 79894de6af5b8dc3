// What the shell offers, and what the manual page says, is what the help says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/commands.hpp"

namespace pennon {
namespace {

using test::done;
using testing::HasSubstr;
using testing::SizeIs;

class Completion : public test::Commands {
 protected:
  std::string help_of(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    words.emplace_back("--help");
    const test::Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, done);
    return outcome.out;
  }

  /// What bash offers after `typed`, of which the last word is the one to be completed.
  std::vector<std::string> offered(const std::string& typed) {
    const test::Outcome script = pennon({"completion"});
    EXPECT_EQ(script.status, done);
    const std::filesystem::path file = folder_ / "completion.bash";
    std::ofstream(file) << script.out << "COMP_WORDS=(" << typed
                        << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_pennon\n"
                        << "printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    const std::filesystem::path answer = folder_ / "answer.txt";
    const pid_t child =
        test::start_program({"/bin/bash", file.string()}, answer, folder_ / "complaints.txt");
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << test::read_text(folder_ / "complaints.txt");
    return lines_of(test::read_text(answer));
  }

  static std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
      if (!line.empty()) lines.push_back(line);
    return lines;
  }

  /// The first group of every match.
  static std::vector<std::string> matches(const std::string& text, const char* pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end;
         ++match)
      found.push_back((*match)[1]);
    return found;
  }

  std::vector<std::string> commands() {
    const std::string help = help_of({});
    return matches(help.substr(help.find("Subcommands:")), "\n  ([a-z]+)");
  }
};

constexpr const char* long_option = "\n  (?:-[a-z],)?(--[a-z]+)";

TEST_F(Completion, OffersEveryCommandAndOptionOfTheHelp) {
  const std::vector<std::string> all = commands();
  ASSERT_THAT(all, SizeIs(testing::Ge(7U)));
  std::vector<std::string> words = matches(help_of({}), long_option);
  words.insert(words.end(), all.begin(), all.end());
  EXPECT_THAT(offered("pennon ''"), testing::UnorderedElementsAreArray(words));
}

TEST_F(Completion, OffersEveryOptionOfACommand) {
  for (const std::string& command : commands()) {
    const std::vector<std::string> options = matches(help_of({command}), long_option);
    EXPECT_THAT(options, testing::Contains("--help")) << command;
    EXPECT_THAT(offered("pennon " + command + " --"), testing::UnorderedElementsAreArray(options))
        << command;
  }
}

TEST_F(Completion, OffersFilesWhereACaseIsMeant) {
  const std::string folder = test::table_1_cases.string();
  EXPECT_THAT(offered("pennon lsa '" + folder + "/C2D.'"),
              testing::ElementsAre(folder + "/C2D.toml"));
}

TEST_F(Completion, TheManualPageHasEveryCommandAndOption) {
  const std::string page = pennon({"manual"}).out;
  for (const std::string& command : commands()) {
    EXPECT_THAT(page, HasSubstr("\n.SS pennon " + command + "\n"));
    for (std::string option : matches(help_of({command}), long_option)) {
      option.replace(0, 2, "\\-\\-");
      EXPECT_THAT(page, HasSubstr(option)) << command;
    }
  }
}

}  // namespace
}  // namespace pennon
