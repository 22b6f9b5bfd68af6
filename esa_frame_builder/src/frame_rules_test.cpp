#include "frame_rules.h"

#include <gtest/gtest.h>

#include "dwell_test_helpers.h"
#include "frame_window.h"

namespace esa_frame_builder {
namespace {

Frame frameOf(std::uint32_t number, const std::vector<Dwell>& dwells) {
  Frame frame;
  frame.number = number;
  frame.closed = true;
  frame.dwells = dwells;
  return frame;
}

TEST(FrameRules, AProperFrameBreaksNone) {
  const Frame first = frameOf(3, {dwellAt(1.0, 0.0, 0.0), dwellAt(1.0, 0.1, 0.0), dwellAt(1.5, 0.2, 0.0)});
  EXPECT_TRUE(brokenRules(first, nullptr).empty());
  EXPECT_TRUE(brokenRules(frameOf(4, {dwellAt(1.2, 0.0, 0.0)}), &first).empty()) << "frames may overlap in time";
}

TEST(FrameRules, EachBrokenRuleIsNamed) {
  const Frame first = frameOf(3, {dwellAt(1.0, 0.0, 0.0)});
  const auto rules = [](const Frame& frame, const Frame* previous) {
    const auto broken = brokenRules(frame, previous);
    return broken.size() == 1 ? broken[0] : std::to_string(broken.size()) + " rules";
  };
  EXPECT_EQ(rules(frameOf(4, {}), &first), "frame 4: it has no field of view");
  EXPECT_EQ(rules(frameOf(4, {dwellAt(2.0, 0.0, 0.0), dwellAt(1.9, 0.0, 0.0)}), &first),
            "frame 4: its dwells are not in order of time");
  EXPECT_EQ(rules(frameOf(4, {dwellAt(0.9, 0.0, 0.0)}), &first), "frame 4: it begins before the one before it");
  EXPECT_EQ(rules(frameOf(5, {dwellAt(2.0, 0.0, 0.0)}), &first), "frame 5: it follows frame 3");
}

// By hand: errors of 10 m each, so 40 m apart is (40² / 200) = 8, and 50 m is 12.5.
TEST(FrameRules, OfTwoMeasurementsThatErrorsExplainTheWeakerGoes) {
  Frame frame =
      frameOf(0, {dwellAt(0.0, 0.0, 0.0, {measurementAt(50e3, 0.01, 0.0, 20), measurementAt(70e3, 0.0, 0.0, 9)}),
                  dwellAt(0.0, 0.01, 0.0,
                          {measurementAt(50050, 0.01, 0.0, 8), measurementAt(50e3 - 40, 0.01, 0.0, 30),
                           measurementAt(70e3, 0.01, 0.0, 9)})});
  EXPECT_EQ(removeDuplicates(frame, 11.3), 1U);
  ASSERT_EQ(frame.dwells[0].measurements.size(), 1U);
  EXPECT_EQ(frame.dwells[0].measurements[0].range, 70e3);
  EXPECT_EQ(frame.dwells[1].measurements.size(), 3U) << "50 m apart, or another direction: others";
}

// One dwell parts what it can part: two close measurements of it are two targets.
TEST(FrameRules, MeasurementsOfOneDwellAreNeverDuplicates) {
  Frame frame = frameOf(0, {dwellAt(0.0, 0.0, 0.0, {measurementAt(50e3, 0.0, 0.0), measurementAt(50001, 0.0, 0.0)})});
  EXPECT_EQ(removeDuplicates(frame, 11.3), 0U);
}

TEST(FrameWindow, ShiftsAndForgetsTheOldest) {
  FrameWindow window(3);
  for (std::uint32_t n = 0; n < 4; ++n) {
    window.look(frameOf(n, {}));
    EXPECT_EQ(window.open().size(), 1U);
    window.shift(frameOf(n, {}));
    EXPECT_TRUE(window.open().empty());
  }
  ASSERT_EQ(window.closed().size(), 2U) << "and frame 1 is the open one";
  EXPECT_EQ(window.closed()[0].number, 3U);
  EXPECT_EQ(window.closed()[1].number, 2U);
}

}  // namespace
}  // namespace esa_frame_builder
