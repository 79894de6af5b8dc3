/// In what two resolved cases differ.
#include "common/case/case_difference.hpp"

#include <gtest/gtest.h>

#include "common/errors.hpp"

namespace pennon {
namespace {

constexpr const char* one = "[flag]\nmu = 0.1\nA = [0.9, 2.0]\n[dns]\ndt = 0.01\n";
constexpr const char* other = "# a comment\n[flag]\nA = [0.9, 2.0]\nmu = 0.3\n[flow]\nRe = 10.0\n";

TEST(CaseDifference, NamesEachKeyWithBothValues) {
  const auto found = case_differences(one, "one", other);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].text(), "dns.dt = 0.01 there, not set here");
  EXPECT_EQ(found[1].text(), "flag.mu = 0.1 there, 0.3 here");
  EXPECT_EQ(found[2].text(), "flow.Re = not set there, 10.0 here");
  EXPECT_EQ(text_of(found).find(" and "), std::string::npos);
}

TEST(CaseDifference, IsNoneOfOrderAndComments) {
  EXPECT_TRUE(case_differences("[a]\nx = 1\ny = 2\n", "", "# b\n[a]\ny = 2\nx = 1\n").empty());
}

TEST(CaseDifference, IsSoughtAmongTheKeysThatAreWanted) {
  const auto found = case_differences(
      one, "one", other, [](const std::string& key) { return key.starts_with("flag."); });
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].key, "flag.mu");
}

TEST(CaseDifference, IsShortenedWhereThereAreMany) {
  const auto found = case_differences("[a]\nb=1\nc=1\nd=1\ne=1\nf=1\ng=1\n", "", "[h]\ni=1\n");
  EXPECT_TRUE(text_of(found).ends_with("; and 3 more")) << text_of(found);
}

TEST(CaseDifference, NamesACaseThatIsNone) {
  EXPECT_THROW(case_differences("[", "broken", one), InputError);
}

}  // namespace
}  // namespace pennon
