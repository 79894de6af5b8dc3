/// The known name that a misspelt one means.
#include "common/case/nearest_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pennon {
namespace {

const std::vector<std::string> known = {"mu", "K_B", "K_S", "nu_s", "leading_edge", "gamma", "Re"};

TEST(NearestName, IsFoundThroughEachKindOfSlip) {
  EXPECT_EQ(nearest_name("KB", known), "K_B");
  EXPECT_EQ(nearest_name("k_s", known), "K_S");
  EXPECT_EQ(nearest_name("re", known), "Re");
  EXPECT_EQ(nearest_name("gama", known), "gamma");
  EXPECT_EQ(nearest_name("gammma", known), "gamma");
  EXPECT_EQ(nearest_name("gmama", known), "gamma");
  EXPECT_EQ(nearest_name("leading-edge", known), "leading_edge");
  EXPECT_EQ(nearest_name("um", known), "mu");
}

TEST(NearestName, IsTheNameItselfWhereThatIsKnown) {
  for (const std::string& name : known) EXPECT_EQ(nearest_name(name, known), name);
}

TEST(NearestName, IsEmptyWhereNoneIsMeant) {
  EXPECT_EQ(nearest_name("temperature", known), "");
  EXPECT_EQ(nearest_name("", known), "");
  EXPECT_EQ(nearest_name("gamma", {}), "");
  EXPECT_EQ(nearest_name(std::string(100000, 'g'), known), "");
}

TEST(NearestName, BecomesAQuestionAtTheEndOfASentence) {
  EXPECT_EQ(did_you_mean("gama", known), "; did you mean gamma?");
  EXPECT_EQ(did_you_mean("temperature", known), "");
}

}  // namespace
}  // namespace pennon
