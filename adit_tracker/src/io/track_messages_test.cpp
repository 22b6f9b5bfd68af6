#include "io/track_messages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// The message of each track's first update.
std::vector<tws_msgs::Track> firstWords(const AditParams& params, const RadarSectors& radars,
                                        std::uint64_t& from_clutter) {
  std::vector<tws_msgs::Track> messages;
  Adit* tracker = nullptr;
  Adit adit(params, [&](const SectorReport& report) {
    for (const TrackUpdate& update : report.updates)
      if (update.event == TrackEvent::kStarted) messages.push_back(trackMessage(*tracker, update, Site{}));
  });
  tracker = &adit;
  feedInOrder(adit, radars);
  adit.finish();
  from_clutter = adit.counts().to_track;
  return messages;
}

// If this fails, whoever measures how long a target was in cover before its track came measures from another time. A
// track that was a clutter point before begins with the point's latest detection, not with its first.
TEST(TrackMessage, TheFirstDetectionIsTheOneThatStartedTheTrackAlsoFromClutter) {
  // Something that stands for two minutes and then moves away with 60 kn, which the clutter map goes on following.
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 300.0)};
  radar.see({20e3, 30e3, 0.0, 0.0, 0.0, 120.0}, radars[0]);
  const double speed = 60.0 * 1852.0 / 3600.0;
  const TestTarget moving{20e3 - 120.0 * speed * 0.5547, 30e3 - 120.0 * speed * 0.83205, speed * 0.5547,
                          speed * 0.83205, 120.0};
  radar.see(moving, radars[0]);
  std::uint64_t from_clutter = 0;
  const auto messages = firstWords(paramsFor("nrl7952", {6.0}), radars, from_clutter);
  ASSERT_GT(from_clutter, 0U);
  for (const tws_msgs::Track& message : messages) {
    const bool detected = std::any_of(radars[0].begin(), radars[0].end(), [&](const tws::RadarSector& sector) {
      return std::any_of(sector.plots.begin(), sector.plots.end(), [&](const tws::Plot& plot) {
        return std::abs(plot.time - message.first_detection.toSec()) < 1e-6;
      });
    });
    EXPECT_TRUE(detected) << message.first_detection;
    EXPECT_EQ(message.first_detection, message.last_update);
    EXPECT_EQ(message.radar_updates, std::vector<ros::Time>{message.first_detection});
  }
}

// If this fails, a display shows an aircraft that turns to the left as one that turns to the right.
TEST(TrackMessage, TellsATurnToTheRightAsOne) {
  for (const double turn_rate : {0.03, -0.03}) {  // clockwise, to the right
    const TestRadar radar(6.0);
    RadarSectors radars = {radar.sectors(0.0, 120.0)};
    double x = 20e3, y = 40e3, course = 0.0;
    for (double t = 0.0; t < 120.0; t += 1.0) {
      const double vx = 200.0 * std::sin(course), vy = 200.0 * std::cos(course);
      radar.see({x - vx * t, y - vy * t, vx, vy, t, t + 1.0 - 1e-9}, radars[0]);
      x += vx;
      y += vy;
      if (t > 50.0) course += turn_rate;
    }
    tws_msgs::Track last;
    Adit* tracker = nullptr;
    Adit adit(paramsFor("default", {6.0}), [&](const SectorReport& report) {
      for (const TrackUpdate& update : report.updates) last = trackMessage(*tracker, update, Site{});
    });
    tracker = &adit;
    feedInOrder(adit, radars);
    ASSERT_EQ(last.model_probabilities.size(), 4U);
    EXPECT_GT(last.model_probabilities[turn_rate > 0.0 ? 1 : 2], 0.6F) << turn_rate;
  }
}

}  // namespace
}  // namespace adit_tracker
