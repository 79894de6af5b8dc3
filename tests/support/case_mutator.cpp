#include "tests/support/case_mutator.hpp"

#include <algorithm>
#include <utility>

namespace pennon::test {
namespace {

constexpr std::size_t longest_text = 64 << 10;

const std::string physical_case = R"([flag]
mu = 0.125
K_B = 1e-4
K_S = 500.0
nu_s = 0.3
damping = 0.0
gravity = [0, 0, 0]
leading_edge = "pinned"
gamma = 2.0
[flow]
Re = 1000.0
U = 0.0
)";
const std::string case_of_every_type = R"([flag]
mu = 1
[types]
number = 2
maybe_number = -1.5
integer = 100
is_on = true
text = "any # thing"
known_text = 'lamb'
triple = [0, -1, 2.5]
numbers = []
integers = [9, 0]
texts = ["x", "y"]
shade = "light"
maybe_shade = "dark"
sweep = { from = 1, to = 100, points = 3, scale = "log" }
[types.inner]
number = 1e-3
)";
const std::string case_of_rare_syntax = R"(# a case
flag.mu = 1_000.5
flag.K_B = 0x1F
[[types]]
text = """two
lines\
  """
)";
const std::string case_of_inline_tables = R"(flag = { mu = 1.0, gravity = [1e-30, 2, 3,
 4] }
types.inner.number = +inf
)";
const std::string case_of_wrong_types = R"([types.inner]
number = 1
[types]
texts = [[1, 2], ['a'], {}]
number = 1979-05-27T07:32:00Z
)";
const std::string case_with_mark_and_returns =
    "\xef\xbb\xbf[flag]\r\nmu = 0.5\r\n[types]\r\ntext = \"\\u00b5 \\U0001F6A9 \\\\ \\\"\"\r\n";

const std::vector<std::string> seeds = {
    physical_case,       case_of_every_type,         case_of_rare_syntax, case_of_inline_tables,
    case_of_wrong_types, case_with_mark_and_returns, "[flag]\nmu = 1\n",  ""};

const std::vector<std::string> pieces = {
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ".",
    ",",
    "\n",
    "\r",
    "#",
    "\"",
    "'",
    "\"\"\"",
    "'''",
    "\\",
    "\\u0000",
    "\\uD800",
    "\\x",
    "nan",
    "-inf",
    "1e999",
    "-1e-999",
    "1e308",
    "0x",
    "0b102",
    "1__0",
    "-0.0",
    "true",
    "false",
    "07:32:00",
    "mu",
    "K_B",
    "KB",
    "[flag]",
    "[flow]",
    "[types]",
    "[a.b.c]",
    "from = 2",
    "points",
    "= [",
    "= {",
    "= \"",
    "x = 1\n",
    "\"\" = 1",
    "\x80",
    "\xf0\x9f\x9a\xa9",
    "\xed\xa0\x80",
    "\xff",
    "9223372036854775807",
    "-9223372036854775809",
    "types.inner.number = 3\n",
    "[types.inner]\n",
    "[[flag]]\n",
    "\xef\xbb\xbf",
    "1979-05-27",
    "24:61:61",
    "scale = 'log'",
    "points = 1000000000",
    std::string(1, '\0'),
};

const std::vector<std::string> override_seeds = {"flag.mu=0.5",
                                                 "flow.Re=100",
                                                 "types.known_text=lamb",
                                                 "types.inner={ number = 3 }",
                                                 "types.text=a = b",
                                                 "types.triple=[1,2,3]",
                                                 "flag.mu.x=1",
                                                 "types.sweep={from=1,to=2,points=3}",
                                                 "=",
                                                 "flag",
                                                 "flag.mu=",
                                                 "a.b.c.d=[[1]]"};

}  // namespace

std::size_t CaseMutator::below(std::size_t end) {
  return end == 0 ? 0 : random_() % end;
}

const std::string& CaseMutator::any_of(const std::vector<std::string>& choices) {
  return choices[below(choices.size())];
}

std::string CaseMutator::random_bytes(std::size_t most) {
  std::string bytes(below(most), '\0');
  for (char& byte : bytes) byte = static_cast<char>(random_());
  return bytes;
}

// One piece after another many times over: deep values, deep names, long names.
std::string CaseMutator::nest() {
  static const std::vector<std::string> units = {"[", "{a=",  "a.",     "[[",
                                                 "k", "[{a=", "\"a\".", "{a.a="};
  const std::string& unit = any_of(units);
  const std::size_t count = std::size_t{1} << below(14);
  std::string text = below(2) == 0 ? "x = " : "";
  for (std::size_t i = 0; i < count; ++i) text += unit;
  return text + any_of(pieces);
}

void CaseMutator::spoil(std::string& text) {
  const std::size_t place = below(text.size() + 1);
  const std::size_t length = below(std::min<std::size_t>(text.size() - place, 40) + 1);
  switch (below(9)) {
    case 0:
      text.insert(place, any_of(pieces));
      break;
    case 1:
      text.replace(place, length, any_of(pieces));
      break;
    case 2:
      text.erase(place, length);
      break;
    case 3:
      text.insert(below(text.size() + 1), text.substr(place, length));
      break;
    case 4:
      if (place < text.size()) text[place] = static_cast<char>(random_());
      break;
    case 5:
      if (place < text.size()) text[place] = static_cast<char>(text[place] ^ (1 << below(8)));
      break;
    case 6:
      text.insert(place, any_of(seeds));
      break;
    case 7:
      if (below(8) == 0) text.insert(place, nest());
      break;
    default:
      if (below(8) == 0) text.insert(place, random_bytes(200));
  }
}

std::string CaseMutator::text() {
  if (below(50) == 0) return random_bytes(2000);
  std::string text = any_of(seeds);
  for (std::size_t i = below(1 + below(8)); i > 0; --i) spoil(text);
  text.resize(std::min(text.size(), longest_text));
  return text;
}

std::vector<std::string> CaseMutator::overrides() {
  std::vector<std::string> assignments;
  if (below(3) != 0) return assignments;
  for (std::size_t i = below(4); i > 0; --i) {
    assignments.push_back(any_of(override_seeds));
    for (std::size_t j = below(4); j > 0; --j) spoil(assignments.back());
  }
  return assignments;
}

}  // namespace pennon::test
