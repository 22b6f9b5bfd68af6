// The node in one process: what it hears of a secondary radar.
#include "iff/iff_interface.h"

#include <gtest/gtest.h>
#include <tws_msgs/SsrPlots.h>

#include "adit_node_test_helpers.h"

namespace adit_tracker {
namespace {

/// Eight aircraft, of which four answer a secondary radar of 5 s at the radars' site.
class IffInterfaceTest : public testing::Test {
 protected:
  void SetUp() override {
    ssr_ = &node_.graph.addNode("ssr");
    plots_ = ssr_->advertise<tws_msgs::SsrPlots>("/ssr/plots");
    for (std::size_t i = 0; i < 4; ++i) beam_.see(aircraft_[i], replies_);
  }

  void tellSite() {
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "ssr";
    site.transform.translation.x = NodeGraph::kEast;
    site.transform.rotation.w = 1.0;
    ssr_->publishStaticTransform(site);
    node_.graph.drain();
  }

  static tws_msgs::SsrPlots messageOf(const tws::RadarSector& sector) {
    tws_msgs::SsrPlots message;
    message.header.stamp = tws_runtime::toTime(kEpoch + sector.leave_time);
    message.header.frame_id = message.radar = "ssr";
    message.sector = static_cast<std::uint8_t>(sector.sector);
    message.running_sector = static_cast<std::uint32_t>(sector.running);
    for (const tws::Plot& plot : sector.plots) {
      tws_msgs::SsrPlot& p = message.plots.emplace_back();
      p.stamp = tws_runtime::toTime(kEpoch + plot.time);
      p.range = plot.range;
      p.azimuth = plot.azimuth;
    }
    return message;
  }

  void send(const tws_msgs::SsrPlots& message) {
    plots_.publish(message);
    node_.graph.drain();
  }

  /// Each reply when its sector has closed; those of `ahead` seconds later.
  void play(double from, double to, double ahead = 0.0) {
    double played = from;
    for (const tws::RadarSector& sector : replies_) {
      if (sector.leave_time <= from + ahead || sector.leave_time > to + ahead) continue;
      node_.play(radars_, played, sector.leave_time - ahead);
      played = sector.leave_time - ahead;
      send(messageOf(sector));
    }
    node_.play(radars_, played, to);
  }

  int answersAlone(double from, double to) {
    int sectors = 0;
    for (const tws::RadarSector& sector : replies_) {
      if (sector.leave_time <= from || sector.leave_time > to) continue;
      send(messageOf(sector));
      ++sectors;
    }
    return sectors;
  }

  /// Which aircraft's believed tracks had the bit, and which had not, in words between these times.
  using Aircraft = std::set<std::size_t>;
  std::pair<Aircraft, Aircraft> bits(double from, double to) const {
    std::pair<Aircraft, Aircraft> with_and_without;
    for (const tws_msgs::Track& update : node_.updates()) {
      const double time = tws_runtime::toSeconds(update.stamp) - kEpoch;
      if (time < from || time > to || update.state != tws_msgs::Track::FIRM) continue;
      const bool bit = (update.detection_bits & tws_msgs::Track::DETECTED_BY_IFF) != 0;
      (bit ? with_and_without.first : with_and_without.second).insert(nearest(update, time));
    }
    return with_and_without;
  }

  std::size_t nearest(const tws_msgs::Track& update, double time) const {
    const auto off = [&](const TestTarget& t) {
      return std::hypot(update.position.x - NodeGraph::kEast - t.x - t.vx * time,
                        update.position.y - t.y - t.vy * time);
    };
    const auto closer = [&](const TestTarget& a, const TestTarget& b) { return off(a) < off(b); };
    return static_cast<std::size_t>(std::min_element(aircraft_.begin(), aircraft_.end(), closer) - aircraft_.begin());
  }

  std::uint64_t count(const char* counter) { return node_.count(counter); }

  static constexpr double kEnd = 110.0;
  const std::pair<Aircraft, Aircraft> four_of_eight_{{0, 1, 2, 3}, {4, 5, 6, 7}};
  const std::pair<Aircraft, Aircraft> none_of_eight_{{}, {0, 1, 2, 3, 4, 5, 6, 7}};
  const std::vector<TestTarget> aircraft_ = eightAircraft();
  const RadarSectors radars_ = flights(kEnd, aircraft_);
  const TestRadar beam_{5.0, 0.2};
  std::vector<tws::RadarSector> replies_ = beam_.sectors(0.0, kEnd);
  NodeGraph node_{"{iff: [{name: ssr}]}"};
  tws_runtime::Bus* ssr_ = nullptr;
  tws_runtime::Publisher<tws_msgs::SsrPlots> plots_;
};

// If this fails, an operator takes who answers for who does not, or the other way round.
TEST_F(IffInterfaceTest, WhoAnswersHasTheBit) {
  tellSite();
  play(0.0, 60.0);
  EXPECT_EQ(bits(25.0, 60.0), four_of_eight_);
  EXPECT_EQ(count("late IFF plots") + count("bad IFF plots") + count("dropped IFF sectors"), 0U);
}

TEST_F(IffInterfaceTest, WhatIsAheadOfTheRadarsWaitsForThem) {
  tellSite();
  play(0.0, 60.0, 8.0);
  EXPECT_EQ(bits(25.0, 60.0), four_of_eight_);
  EXPECT_EQ(count("late IFF plots") + count("dropped IFF sectors"), 0U);
}

// If this fails, a radar that stamps wrongly makes anybody answer.
TEST_F(IffInterfaceTest, PlotsThatMakeNoSenseAreCountedAndLeftOut) {
  tellSite();
  for (tws::RadarSector& sector : replies_)
    for (tws::Plot& plot : sector.plots) plot.time -= plot.time > 50.0 ? 2.5 : 0.0;
  play(0.0, 80.0);
  EXPECT_EQ(bits(25.0, 50.0), four_of_eight_);
  EXPECT_EQ(bits(60.0, 80.0), none_of_eight_);
  std::uint64_t bad = 0;
  for (const tws::RadarSector& sector : replies_)
    if (sector.leave_time <= 80.0 && sector.leave_time > 50.0) bad += sector.plots.size();
  EXPECT_EQ(count("bad IFF plots"), bad);
  EXPECT_GE(bad, 20U);  // six turns, four aircraft, but for the edges

  tws::RadarSector sector = replies_[5];
  sector.plots.assign(3, tws::Plot{});
  for (tws::Plot& plot : sector.plots) plot.range = 1e4;
  tws_msgs::SsrPlots message = messageOf(sector);
  message.plots[0].range = std::nan("");
  message.plots[1].azimuth = 7.0;
  message.plots[2].stamp = ros::Time();
  send(message);
  EXPECT_EQ(count("bad IFF plots"), bad + 3);
}

// If this fails, all plots of a radar whose site nobody told are laid around the first radar.
TEST_F(IffInterfaceTest, ASecondaryRadarWhoseSiteIsNeverToldIsLeftOutAndSaidOnce) {
  play(0.0, 60.0);
  tellSite();  // too late
  play(60.0, 90.0);
  EXPECT_EQ(bits(25.0, 90.0), none_of_eight_);
  EXPECT_EQ(count("unknown sites"), 1U);
  EXPECT_GE(count("unplaced IFF plots"), 60U);  // seventeen turns, four aircraft, but for the edges
  EXPECT_EQ(count("late IFF plots"), 0U);
}

TEST_F(IffInterfaceTest, ASiteThatIsToldWithinTwoTurnsIsInTime) {
  play(0.0, 9.0);
  tellSite();
  play(9.0, 60.0);
  EXPECT_EQ(bits(25.0, 60.0), four_of_eight_);
  EXPECT_EQ(count("unknown sites") + count("unplaced IFF plots"), 0U);
}

// If this fails, a node whose radars are dead grows until the machine is full.
TEST_F(IffInterfaceTest, WhileTheRadarsAreSilentTheOldestIsDropped) {
  tellSite();
  play(0.0, 20.0);
  const int sectors = answersAlone(20.0, 60.0);
  EXPECT_NEAR(static_cast<double>(count("dropped IFF sectors")),
              sectors - static_cast<double>(IffInterface::kMostWaiting),
              2.0);  // some of the last turn were waiting, too
  play(60.0, kEnd);
  EXPECT_EQ(bits(90.0, kEnd), four_of_eight_);
}

// If this fails, tracks of a new run answer with what was said in the old one.
TEST_F(IffInterfaceTest, WhatStillComesOfTheOldRunIsDropped) {
  tellSite();
  play(0.0, 60.0);
  node_.play(radars_, 0.0, 1.5);  // time has gone back
  const auto late = count("late IFF plots");
  const int sectors = answersAlone(60.0, 80.0);
  EXPECT_EQ(count("messages of the old run"), static_cast<std::uint64_t>(sectors));
  node_.tracks.clear();
  play(1.5, 50.0);  // it has gone back, too
  EXPECT_EQ(bits(25.0, 50.0), four_of_eight_);
  node_.play(radars_, 50.0, 80.0);
  EXPECT_EQ(bits(60.0, 80.0), none_of_eight_);
  EXPECT_EQ(count("messages of the old run"), static_cast<std::uint64_t>(sectors));
  EXPECT_EQ(count("late IFF plots"), late);
}

}  // namespace
}  // namespace adit_tracker
