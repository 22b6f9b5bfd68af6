// The node when something is wrong with time: late, doubled and missing data, clocks that jump, runs that begin anew.
#include <gtest/gtest.h>

#include "adit_node_test_helpers.h"

namespace adit_tracker {
namespace {

class WhenTimeIsWrong : public testing::TestWithParam<std::string> {
 protected:
  std::string set() const { return "{set: " + GetParam() + "}"; }
};
INSTANTIATE_TEST_SUITE_P(Sets, WhenTimeIsWrong, testing::Values("default", "nrl7952"),
                         [](const auto& info) { return info.param; });

/// Sends all sectors in the order in which they close; `error` is that of the radar's clock by then.
template <class Error>
void playWithClock(NodeGraph& node, const RadarSectors& radars, const Error& error) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t r = 0; r < radars.size(); ++r)
    for (std::size_t i = 0; i < radars[r].size(); ++i) order.emplace_back(radars[r][i].leave_time, r, i);
  std::sort(order.begin(), order.end());
  for (const auto& [time, r, i] : order) node.send(r, radars[r][i], error(r, time));
}

/// Are all these tracks in the picture, and believed?
bool stillThere(const NodeGraph& node, const std::set<std::uint32_t>& before) {
  const std::set<std::uint32_t> now = node.confirmed();
  return std::includes(now.begin(), now.end(), before.begin(), before.end());
}

// If this fails, a clock that is set takes tracks with it. Both radars' clocks jump, or only one's.
TEST_P(WhenTimeIsWrong, AJumpOfUpToHalfASecondDeletesNoTrack) {
  auto generator = tws::seededGenerator();
  const RadarSectors radars = flights(110.0, eightAircraft());
  for (const double jump : {-0.5, -0.3, -0.1, -0.02, 0.02, 0.1, 0.3, 0.5}) {
    for (const int jumping : {0, 1, 2}) {
      const double when = tws::uniform(generator, 60.0, 68.0);
      NodeGraph node(set());
      std::set<std::uint32_t> before;
      playWithClock(node, radars, [&](std::size_t radar, double time) {
        if (time <= when) before = node.confirmed();
        return time > when && (jumping == 2 || radar == static_cast<std::size_t>(jumping)) ? jump : 0.0;
      });
      EXPECT_GE(before.size(), 6U);
      EXPECT_TRUE(stillThere(node, before)) << "a jump of " << jump << " s at " << when << " s of radar " << jumping;
      EXPECT_EQ(node.count("new runs"), 0U);
    }
  }
}

// If this fails, the clocks of a running system must not be disciplined: it jumps again and again, here every two
// seconds.
TEST_P(WhenTimeIsWrong, ManySmallJumpsDeleteNoTrackEither) {
  auto generator = tws::seededGenerator();
  const RadarSectors radars = flights(110.0, eightAircraft());
  NodeGraph node(set());
  std::set<std::uint32_t> before;
  std::map<int, double> errors;
  for (int i = 30; i < 55; ++i) errors[i] = tws::uniform(generator, -0.25, 0.25);
  playWithClock(node, radars, [&](std::size_t, double time) {
    if (time <= 60.0) before = node.confirmed();
    return errors[static_cast<int>(time / 2.0)];
  });
  EXPECT_GE(before.size(), 6U);
  EXPECT_TRUE(stillThere(node, before));
}

// If this fails, a bag that is played in a loop, or a simulation that is started again, meets tracks of the run before.
TEST_P(WhenTimeIsWrong, TimeThatGoesBackFarBeginsANewRunThatIsLikeTheFirst) {
  const RadarSectors radars = flights(60.0, eightAircraft());
  NodeGraph node(set());
  node.play(radars, 0.0, 60.0);
  node.ask(tws_msgs::OperatorRequest::LIST_ALL);
  const std::vector<tws_msgs::Tracks> first = node.tracks;
  node.tracks.clear();
  node.play(radars, 0.0, 60.0);
  node.ask(tws_msgs::OperatorRequest::LIST_ALL);
  EXPECT_EQ(node.count("new runs"), 1U);
  ASSERT_EQ(node.tracks.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    std::ostringstream once, again;
    for (const auto& track : first[i].tracks) once << track;
    for (const auto& track : node.tracks[i].tracks) again << track;
    ASSERT_EQ(once.str(), again.str()) << "sector " << i;
  }
  EXPECT_EQ(node.told.at(0).run, 0U);
  EXPECT_EQ(node.told.at(1).run, 1U);
}

// If this fails, a radar that was off stays lost, or its outage costs tracks that the other radar sees.
TEST_P(WhenTimeIsWrong, ADeadRadarIsSaidToBeStaleAndResumes) {
  RadarSectors radars = flights(150.0, eightAircraft());
  auto& off = radars[0];
  off.erase(
      std::remove_if(off.begin(), off.end(), [](const auto& s) { return s.leave_time > 60 && s.enter_time < 100; }),
      off.end());
  NodeGraph node(set());
  node.play(radars, 0.0, 59.0);
  const std::set<std::uint32_t> before = node.confirmed();
  node.play(radars, 59.0, 150.0);
  EXPECT_GE(before.size(), 6U);
  EXPECT_TRUE(stillThere(node, before));
  for (const auto& status : node.statuses) {
    const double t = status.header.stamp.toSec() - kEpoch;
    EXPECT_EQ(status.stale.at(0) != 0, t > 61.5 && t < 99.5) << t;
    EXPECT_EQ(status.stale.at(1), 0) << t;
  }
  for (const auto& [uid, update] : node.picture()) EXPECT_EQ(update.detection_bits, 3U) << "both radars see it again";
}

/// One aircraft, whose plots come late by so many sectors: `message` times the sectors' messages, `plot` only the
/// plots, in the messages of later sectors.
RadarSectors latePlots(std::size_t sectors) {
  RadarSectors radars = flights(80.0, {TestTarget{60e3, 20e3, -240.0, 180.0}});
  for (auto& radar : radars) {
    for (std::size_t i = radar.size(); i-- > sectors;) {
      radar[i].plots = radar[i - sectors].plots;
      radar[i - sectors].plots.clear();
    }
  }
  return radars;
}

// If this fails, plots of a radar whose extractor takes its time are lost, or such as belong nowhere make false tracks.
TEST_P(WhenTimeIsWrong, PlotsLateByUpToASectorAreUsedAndLaterOnesCountedAndDropped) {
  NodeGraph late(set()), too_late(set());
  late.play(latePlots(1), 0.0, 80.0);
  EXPECT_EQ(late.confirmed().size(), 1U);
  EXPECT_EQ(late.picture().size(), 1U);
  EXPECT_EQ(late.count("late detections"), 0U);
  too_late.play(latePlots(3), 0.0, 80.0);
  EXPECT_EQ(too_late.updates().size(), 0U);
  const std::size_t plots = plotsIn(flights(80.0, {TestTarget{60e3, 20e3, -240.0, 180.0}}));
  EXPECT_EQ(too_late.count("late detections"), plots);
  EXPECT_LE(too_late.statuses.back().late_detections, plots);
  EXPECT_GE(too_late.statuses.back().late_detections + 4, plots);
}

// If this fails, a message that comes twice, or a plot that is reported twice, makes a second track or moves the first.
TEST_P(WhenTimeIsWrong, DoubledMessagesAndPlotsChangeNothing) {
  const RadarSectors radars = flights(80.0, eightAircraft());
  NodeGraph once(set()), twice(set());
  once.play(radars, 0.0, 80.0);
  RadarSectors doubled = radars;
  for (auto& radar : doubled) {
    for (std::size_t i = radar.size(); i-- > 0;) {
      const auto plots = radar[i].plots;
      if (i % 2 == 0) radar[i].plots.insert(radar[i].plots.end(), plots.begin(), plots.end());
      if (i % 2 == 0 && i + 1 < radar.size())
        radar[i + 1].plots.insert(radar[i + 1].plots.begin(), plots.begin(), plots.end());
    }
  }
  playWithClock(twice, doubled, [&](std::size_t, double) { return 0.0; });
  for (std::size_t i = 0; i < 5; ++i) twice.send(0, radars[0][radars[0].size() - 10 + i]);
  EXPECT_EQ(NodeGraph::bytesOf(twice.tracks), NodeGraph::bytesOf(once.tracks));
  EXPECT_GT(twice.count("duplicate detections"), 50U);
  EXPECT_EQ(twice.count("duplicate messages"), 10U);
}

}  // namespace
}  // namespace adit_tracker
