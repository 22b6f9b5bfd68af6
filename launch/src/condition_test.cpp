#include "condition.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tws_launch {
namespace {

// The words "a" and "b" are true. If this fails, a node runs where it has nothing to do, or is missing.
bool holdsHere(const std::string& condition) {
  return holds(condition, [](const std::string& word) { return word == "a" || word == "b"; });
}

TEST(Condition, NotBindsMoreThanAndAndAndMoreThanOr) {
  EXPECT_TRUE(holdsHere(""));
  EXPECT_TRUE(holdsHere("a"));
  EXPECT_FALSE(holdsHere("c"));
  EXPECT_TRUE(holdsHere("not c"));
  EXPECT_TRUE(holdsHere("a and b and not c"));
  EXPECT_FALSE(holdsHere("a and c"));
  EXPECT_TRUE(holdsHere("a or c and c"));
  EXPECT_TRUE(holdsHere("c and c or b"));
  EXPECT_FALSE(holdsHere("not a or c"));
}

TEST(Condition, RefusesWhatIsNone) {
  for (const char* text : {"and", "a b", "a and", "a or or b", "not", "a not b"})
    EXPECT_THROW(holdsHere(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace tws_launch
