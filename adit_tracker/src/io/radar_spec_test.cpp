#include "io/radar_spec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace adit_tracker {
namespace {

std::string refusalOf(const std::vector<std::string>& texts) {
  try {
    parseRadars(texts);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(RadarSpec, WhatIsLeftOutIsToBeFound) {
  const auto specs = parseRadars({"a", "b:4", "c:4.5:90", "d:6:-180"});
  ASSERT_EQ(specs.size(), 4U);
  EXPECT_EQ(specs[0].id, "a");
  EXPECT_EQ(specs[0].period, 0.0);
  EXPECT_TRUE(std::isnan(specs[0].phase));
  EXPECT_EQ(specs[1].period, 4.0);
  EXPECT_TRUE(std::isnan(specs[1].phase));
  EXPECT_EQ(specs[2].period, 4.5);
  EXPECT_DOUBLE_EQ(specs[2].phase, 3.14159265358979323846 / 2.0);
  EXPECT_DOUBLE_EQ(specs[3].phase, -3.14159265358979323846);
}

// If this fails, a slip of the pen gives another rotation, and tracks that are wrong everywhere.
TEST(RadarSpec, ASlipIsRefusedWithItsText) {
  for (const char* text : {"", ":", ":6", "a:", "a:x", "a:6:", "a:6:x", "a:6:0:1", "a:nan", "a:6:inf", "a:6s"})
    EXPECT_EQ(refusalOf({text}), "--radar " + std::string(text) + ": expected ID[:PERIOD_S[:PHASE_DEG]]");
  for (const char* text : {"a:0", "a:-6", "a:0.49", "a:121:0"})
    EXPECT_EQ(refusalOf({text}), "--radar " + std::string(text) + ": the period is not in [0.5, 120] s");
  EXPECT_EQ(refusalOf({"a:6", "b", "a:8"}), "--radar a:8: that ID stands twice");
}

}  // namespace
}  // namespace adit_tracker
