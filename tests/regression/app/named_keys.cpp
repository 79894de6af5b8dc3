/// Every key of a case that a sentence of the program names is one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/commands.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// The string literals of a source, those that follow each other without a comma as one.
std::vector<std::string> literals_of(const std::string& source) {
  std::vector<std::string> literals;
  bool follows = false;  // only white space since the last literal
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.compare(i, 2, "//") == 0) {
      i = std::min(source.find('\n', i), source.size());
    } else if (source[i] == '\'' && i > 0 &&
               !std::isalnum(static_cast<unsigned char>(source[i - 1]))) {
      i = source.find('\'', source[i + 1] == '\\' ? i + 3 : i + 1);
      follows = false;
    } else if (source[i] == '"') {
      std::string text;
      for (++i; i < source.size() && source[i] != '"'; ++i) {
        const bool is_escaped = source[i] == '\\';
        if (is_escaped) ++i;
        text += is_escaped && source[i] == 'n' ? ' ' : source[i];
      }
      if (follows)
        literals.back() += text;
      else
        literals.push_back(text);
      follows = true;
    } else if (!std::isspace(static_cast<unsigned char>(source[i]))) {
      follows = false;
    }
  }
  return literals;
}

/// Words like dns.initial.kick in a text, file names apart.
std::vector<std::string> keys_in(const std::string& text) {
  static const std::regex key(
      R"((^|[^\w./])((flag|flow|lsa|modes|dns|analysis|compare)(\.[A-Za-z]\w*)+))");
  static const std::set<std::string> endings = {"h5",  "csv", "toml", "hpp", "cpp",
                                                "png", "svg", "xdmf", "json"};
  std::vector<std::string> keys;
  for (std::sregex_iterator word(text.begin(), text.end(), key), end; word != end; ++word) {
    const std::string name = (*word)[2];
    if (!endings.contains(name.substr(name.rfind('.') + 1))) keys.push_back(name);
  }
  return keys;
}

class NamedKeys : public test::Commands {
 protected:
  /// The tables and keys of `pennon reference`.
  std::set<std::string> declared() {
    static const std::regex heading(R"(^## \[([\w.]+)\])"), row(R"(^\| `(\w+)` \|)");
    std::set<std::string> names;
    std::istringstream lines(pennon({"reference"}).out);
    std::string table;
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_search(line, match, heading)) names.insert(table = match[1]);
      if (std::regex_search(line, match, row)) names.insert(table + "." + match[1].str());
    }
    return names;
  }
};

TEST_F(NamedKeys, AreDeclared) {
  const std::set<std::string> names = declared();
  ASSERT_TRUE(names.contains("dns.initial.mode_amplitude"));
  int found = 0;
  for (const char* top : {"common", "lsa", "modes", "dns", "analysis", "app"})
    for (const auto& entry : fs::recursive_directory_iterator(test::source / top)) {
      const std::string ending = entry.path().extension();
      if (ending != ".cpp" && ending != ".hpp") continue;
      for (const std::string& literal : literals_of(test::read_text(entry.path())))
        for (const std::string& key : keys_in(literal)) {
          EXPECT_TRUE(names.contains(key))
              << entry.path() << " speaks of " << key << ": " << literal;
          ++found;
        }
    }
  EXPECT_GT(found, 200);
}

// The test can fail.
TEST_F(NamedKeys, AreFoundInLiteralsThatContinue) {
  const std::string source = R"(
    // "dns.in_a_comment"
    fail('"', "a smaller dns.initial."
              "amplitude, or dns.dt. See modes.h5", "flag.", "K_B"); )";
  std::vector<std::string> keys;
  for (const std::string& literal : literals_of(source))
    for (const std::string& key : keys_in(literal)) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("dns.initial.amplitude", "dns.dt"));
  EXPECT_THAT(keys_in("pennon.dns.x of results/modes.csv"), IsEmpty());
}

}  // namespace
}  // namespace pennon
