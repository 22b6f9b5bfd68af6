#include "radar_feed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "block_test_helpers.h"

namespace asterix_bridge {
namespace {

Octets timeOfDay(double seconds) {
  const auto units = static_cast<std::uint32_t>(std::lround(seconds * 128.0));
  return {static_cast<std::uint8_t>(units >> 16), static_cast<std::uint8_t>(units >> 8),
          static_cast<std::uint8_t>(units)};
}
// CAT034 north mark with a position: 22 bytes.
Octets northWithPlace(SourceId radar, double seconds) {
  return blockOf(
      34, Octets{0xE1, 0x10, radar.sac, radar.sic, 1} + timeOfDay(seconds) + Octets{0, 100, 0x20, 0, 0, 0x10, 0, 0});
}

class RadarFeedTest : public ::testing::Test {
 protected:
  void open(const RadarFeed::Options& options) {
    RadarFeed::Events events;
    events.sector = [this](SourceId radar, CutSector&&) { sectors_[radar]++; };
    events.position = [this](SourceId radar, const tws::Geodetic&) { placed_.insert(radar); };
    events.fault = [this](const std::string& counter, const std::string&) { ++faults_[counter]; };
    events.left_out = [](const std::string&) {};
    feed_ = std::make_unique<RadarFeed>(DataClock(1.7e9), options, events);
  }
  void add(const Octets& block) {
    for (const FramingStep& step : blocksOfDatagram(bytesOf(block))) feed_->add(step, "there");
  }

  std::map<SourceId, int> sectors_;
  std::set<SourceId> placed_;
  std::map<std::string, int> faults_;
  std::unique_ptr<RadarFeed> feed_;
};

// If this fails, datagrams with made-up numbers open topics and frames until the graph stands.
TEST_F(RadarFeedTest, OpensNoRadarsForNumbersAtRandom) {
  RadarFeed::Options options;
  options.listed = {{8, 9}};
  open(options);
  for (int i = 0; i < 3000; ++i) {
    const double time = 100.0 + 0.02 * i;
    add(northWithPlace({static_cast<std::uint8_t>(100 + i / 250), static_cast<std::uint8_t>(i % 250)}, time));
    if (i % 200 == 0) add(northWithPlace({8, 9}, time));
  }
  EXPECT_GT((sectors_[{8, 9}]), 64);
  EXPECT_EQ(sectors_.size(), 1u);
  EXPECT_EQ(placed_.size(), 1u);
  EXPECT_GT(faults_["records of further radars"], 2000);
}

TEST_F(RadarFeedTest, OpensARadarThatShowsHowItTurns) {
  open({});
  for (int turn = 0; turn < 10; ++turn) add(northWithPlace({1, 2}, 100.0 + 4.0 * turn));
  EXPECT_EQ(placed_.count({1, 2}), 1u);
  EXPECT_GT((sectors_[{1, 2}]), 64);
}

TEST_F(RadarFeedTest, TakesListedRadarsAloneWhenAsked) {
  RadarFeed::Options options;
  options.listed = {{8, 9}};
  options.only_listed = true;
  open(options);
  for (int turn = 0; turn < 10; ++turn) add(northWithPlace({1, 2}, 100.0 + 4.0 * turn));
  EXPECT_TRUE(sectors_.empty());
  EXPECT_EQ(faults_["records of further radars"], 10);
}

}  // namespace
}  // namespace asterix_bridge
