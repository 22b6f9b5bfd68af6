#include "dwell_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

Dwell fullDwell() {
  Dwell dwell = dwellAt(12.345678901, 0.25, -0.5, {measurementAt(70e3, 0.251, -0.499, 35.0)});
  dwell.number = 17;
  dwell.is_track_dwell = true;
  dwell.group_indices = {3, 8};
  dwell.group = 4;
  dwell.expected_group_dwells = 2;
  dwell.range_min = 1000.0;
  dwell.measurements[0].covariance << 100, 1e-5, 2e-5, 1e-5, 1e-6, 3e-7, 2e-5, 3e-7, 2e-6;
  dwell.measurements[0].rcs = 2.5;
  return dwell;
}

std::string counterOf(const std::function<void(tws_msgs::DwellReport&)>& spoil) {
  tws_msgs::DwellReport message = toMessage(fullDwell());
  spoil(message);
  const DwellFault fault = faultOf(message, 12.0, 13.0);
  EXPECT_EQ(fault.reason.substr(0, 10), fault.counter.empty() ? "" : "dwell 17: ");
  return fault.counter;
}

TEST(DwellMessages, ADwellSurvivesTheWayThroughItsMessage) {
  const Dwell dwell = fullDwell();
  std::vector<std::string> faults;
  const Dwell back = toDwell(toMessage(dwell), faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(back.time, dwell.time);
  EXPECT_EQ(back.number, 17U);
  EXPECT_TRUE(back.is_track_dwell);
  EXPECT_EQ(back.group_indices, dwell.group_indices);
  EXPECT_EQ(back.group, 4U);
  EXPECT_EQ(back.expected_group_dwells, 2U);
  EXPECT_EQ(back.u, 0.25);
  EXPECT_EQ(back.v, -0.5);
  EXPECT_EQ(back.beamwidth_u, 0.02);
  EXPECT_EQ(back.beamwidth_v, 0.02);
  EXPECT_EQ(back.range_min, 1000.0);
  EXPECT_EQ(back.range_max, 200e3);
  ASSERT_EQ(back.measurements.size(), 1U);
  EXPECT_EQ(back.measurements[0].range, 70e3);
  EXPECT_EQ(back.measurements[0].covariance, dwell.measurements[0].covariance);
  EXPECT_EQ(back.measurements[0].snr, 35.0);
  EXPECT_EQ(back.measurements[0].rcs, 2.5);
}

TEST(DwellMessages, EachFaultOfADwellHasItsOwnCounter) {
  EXPECT_EQ(counterOf([](auto&) {}), "");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.measurements.clear(); }), "") << "a dwell that saw nothing is normal";
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.dwell_group_indices = {4000000000U}; }), "")
      << "so is a track long deleted";
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.u = kNaN; }), "dwells with NaN");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.beamwidth_v = kNaN; }), "dwells with NaN");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.range_max = kNaN; }), "dwells with NaN");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.u = dwell.v = 0.71; }), "dwells outside the visible region");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.beamwidth_u = 0.0; }), "dwells without a beamwidth");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.beamwidth_v = -0.02; }), "dwells without a beamwidth");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.range_min = 300e3; }), "dwells with a bad receive window");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.stamp = ros::Time(11.9); }), "dwells back in time");
  EXPECT_EQ(counterOf([](auto& dwell) { dwell.stamp = ros::Time(13.1); }), "dwells after their period");
}

// If this fails, one bad number costs a whole dwell, or reaches the filter.
TEST(DwellMessages, LeavesOutAndNamesMeasurementsThatCannotBeUsed) {
  const std::vector<std::function<void(tws_msgs::RuvMeasurement&)>> spoil{[](auto& m) { m.range = kNaN; },
                                                                          [](auto& m) { m.range = -5.0; },
                                                                          [](auto& m) {
                                                                            m.u = 0.9;
                                                                            m.v = 0.9;
                                                                          },
                                                                          [](auto& m) { m.v = kNaN; },
                                                                          [](auto& m) { m.snr = -1.0; },
                                                                          [](auto& m) { m.covariance[0] = 0.0; },
                                                                          [](auto& m) { m.covariance[5] = kNaN; },
                                                                          [](auto& m) { m.covariance[8] = -1e-6; }};
  tws_msgs::DwellReport message = toMessage(fullDwell());
  for (const auto& change : spoil) {
    message.measurements.push_back(message.measurements[0]);
    change(message.measurements.back());
  }
  std::vector<std::string> faults;
  const Dwell dwell = toDwell(message, faults);
  EXPECT_EQ(dwell.measurements.size(), 1U);
  ASSERT_EQ(faults.size(), spoil.size());
  EXPECT_EQ(faults[0], "dwell 17: a measurement's range is nan");
}

TEST(DwellMessages, AFrameSurvivesTheWayThroughItsMessage) {
  Frame frame;
  frame.number = 9;
  frame.closed = true;
  frame.discarded = 3;
  frame.dwells = {fullDwell(), fullDwell()};
  std::vector<std::string> faults;
  const Frame back = toFrame(toMessage(frame), faults);
  EXPECT_EQ(back.number, 9U);
  EXPECT_TRUE(back.closed);
  EXPECT_EQ(back.discarded, 3U);
  ASSERT_EQ(back.dwells.size(), 2U);
  EXPECT_EQ(back.dwells[1].measurements.size(), 1U);
  frame.closed = false;
  EXPECT_EQ(toMessage(frame).status, tws_msgs::Frame::PARTIAL);
}

}  // namespace
}  // namespace esa_frame_builder
