#include "elevation_loop.h"

#include <gtest/gtest.h>
#include <radar_sim/radar_sim_node.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/run.h>

#include <cmath>
#include <sstream>

namespace radar_sim {
namespace {

/// A height finder, an aircraft due east, and a tracker that answers the marks with lists.
class ElevationLoopTest : public testing::Test {
 protected:
  /// The list that answers the n-th entry into sector 61; `delay`: so many marks late.
  using Answer = std::function<std::optional<tws_msgs::ElevationRequests>(int scan)>;

  static tws_msgs::ElevationRequests east(std::size_t count = 1) {
    tws_msgs::ElevationRequests list;
    list.requests.resize(count);
    for (auto& request : list.requests) {
      request.azimuth = tws::radians(87.0);
      request.range = 50e3;
    }
    return list;
  }

  void run(const Answer& answer, int delay = 0) {
    const tws::TemporaryFolder folder;
    const std::string file =
        folder.write("scenario.yaml",
                     "{duration_s: 79, radars: [{name: sps39, type: SPS-39, false_alarms_per_scan: 0}], targets: "
                     "[{name: alpha, range_m: 50000, azimuth_deg: 90, height_m: 5000, speed_mps: 0, rcs_m2: 100}]}");
    YAML::Node parameters;
    parameters["scenario"] = file;
    tws_runtime::LocalGraph graph(log);
    tws_runtime::Bus& tracker = graph.addNode("tracker");
    auto lists = tracker.advertise<tws_msgs::ElevationRequests>("/sps39/elevation_requests");
    std::deque<std::pair<int, tws_msgs::ElevationRequests>> to_send;
    int scan = 0, mark = 0;
    tracker.subscribe<tws_msgs::SectorMark>("/sps39/sector_marks", [&](const tws_msgs::SectorMark& m) {
      ++mark;
      if (m.sector == 61) {
        if (auto list = answer(scan++)) {
          list->header.stamp = m.header.stamp;
          to_send.emplace_back(mark + delay, *list);
        }
      }
      for (; !to_send.empty() && to_send.front().first <= mark; to_send.pop_front())
        lists.publish(to_send.front().second);
    });
    tracker.subscribe<tws_msgs::Detections>("/sps39/detections", [&](const tws_msgs::Detections& message) {
      text << message;
      for (const auto& d : message.detections) {
        if (!std::isnan(d.elevation)) searched.push_back(static_cast<int>(message.running_sector / 64));
      }
    });
    RadarSimNode source(graph.addNode("radar_sim", parameters));
    tws_runtime::runOffline(graph, {&source});
    for (const auto& reading : graph.counters()) counters[reading.name] = reading.value;
  }

  std::ostringstream log, text;
  std::vector<int> searched;  // turns in which the aircraft's elevation was measured
  std::map<std::string, std::uint64_t> counters;
};

// The list of mark 61 holds for the turn that follows and no other: a tracker counts on when its answer comes.
TEST_F(ElevationLoopTest, AListTakesEffectForTheTurnThatBeginsAtTheNextNorth) {
  run([](int scan) { return scan == 2 || scan == 5 ? east() : east(0); });
  EXPECT_EQ(searched, (std::vector<int>{3, 6}));
  EXPECT_EQ(counters.count("commands late"), 0U);
}

TEST_F(ElevationLoopTest, ALateListTakesEffectATurnLaterAndIsCounted) {
  run([](int scan) { return scan == 2 ? std::optional(east()) : std::nullopt; }, 10);
  EXPECT_EQ(searched, (std::vector<int>{4}));
  EXPECT_EQ(counters["commands late"], 1U);
}

TEST_F(ElevationLoopTest, WhatIsTooMuchOrMakesNoSenseIsRefusedAndCounted) {
  run([](int scan) {
    auto list = east(scan == 2 ? 10 : 0);
    if (scan == 4) list = east(3);
    if (scan == 4) list.requests[0].azimuth = std::nan("");
    if (scan == 4) list.requests[1].range = -1.0;
    return list;
  });
  EXPECT_EQ(searched, (std::vector<int>{3, 5}));
  EXPECT_EQ(counters["refused elevation requests"], 4U);  // two beyond the eighth, two without sense
}

// A run without a tracker of this kind must stay what it was.
TEST_F(ElevationLoopTest, WithoutListsNothingChangesAndNothingIsLate) {
  run([](int) { return std::nullopt; });
  const std::string silent = text.str();
  text.str("");
  run([](int) { return east(0); });
  EXPECT_EQ(text.str(), silent);
  EXPECT_TRUE(searched.empty());
  EXPECT_EQ(counters.count("commands late"), 0U);
}

}  // namespace
}  // namespace radar_sim
