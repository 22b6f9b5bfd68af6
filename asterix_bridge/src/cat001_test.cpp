// Blocks worked by hand from the field definitions: each octet says which item it is.
#include <gtest/gtest.h>

#include <cmath>

#include "block_test_helpers.h"

namespace asterix_bridge {
namespace {

constexpr double kNauticalMile = 1852.0;

// If this fails, every plot of a CAT001 radar stands at the wrong place or time.
TEST(Cat001, DecodesAPlotWithAllItemsOfItsProfile) {
  const Octets record{0xFF, 0xFF, 0x84,        // FSPEC: 15 items of the plot profile, and SP
                      0x14, 0x82,              // 010: SAC 20, SIC 130
                      0x37, 0x80,              // 020: plot, combined, antenna 1, SPI, RAB; extent: test target
                      0x01, 0x40, 0xC0, 0x00,  // 040: 320/128 = 2.5 NM, 270 degrees
                      0xCF, 0xC0,              // 070: V and G set, octal 7700
                      0x05, 0x78,              // 090: 1400/4 = FL 350
                      0x0D, 0x06,              // 130: first octet 6, and one more
                      0xFF, 0x80,              // 141: 65408/128 = 511 s
                      0x02, 0x9C,              // 050: octal 1234
                      0xFE,                    // 120: -2/256 NM/s
                      0xB0,                    // 131: -80 dBm
                      0x00, 0x01,              // 080
                      0x00, 0x00, 0x00, 0x00,  // 100
                      0x0F, 0xFF,              // 060
                      0x03, 0x02,              // 030: two warnings
                      0x80,                    // 150: X-pulse
                      0x03, 0xAA, 0xBB};       // SP: three octets with its length
  const Block block = decoded(blockOf(1, record + plot001()));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  ASSERT_EQ(block.reports.size(), 2u);
  const TargetReport& plot = block.reports[0];
  EXPECT_EQ(plot.source->sac, 20);
  EXPECT_EQ(plot.source->sic, 130);
  EXPECT_FALSE(plot.is_track);
  EXPECT_TRUE(plot.primary && plot.secondary && plot.special_identification && plot.fixed_transponder);
  EXPECT_TRUE(plot.test_target);
  EXPECT_DOUBLE_EQ(plot.range, 2.5 * kNauticalMile);
  EXPECT_DOUBLE_EQ(plot.azimuth, 270.0 * kDegree);
  EXPECT_EQ(plot.mode_3a.value, 07700);
  EXPECT_FALSE(plot.mode_3a.validated);
  EXPECT_TRUE(plot.mode_3a.garbled);
  EXPECT_EQ(plot.mode_2.value, 01234);
  EXPECT_TRUE(plot.mode_2.validated);
  EXPECT_DOUBLE_EQ(plot.flight_level.level_100ft, 350.0);
  EXPECT_EQ(plot.raw_characteristics, 6);
  EXPECT_DOUBLE_EQ(plot.time_of_day, 511.0);
  EXPECT_TRUE(plot.is_time_truncated);
  EXPECT_DOUBLE_EQ(plot.range_rate, -2.0 / 256.0 * kNauticalMile);
  EXPECT_DOUBLE_EQ(plot.received_power_dbm, -80.0);
  EXPECT_DOUBLE_EQ(block.reports[1].range, 64.0 * kNauticalMile);
}

// The other order of the fields: read as a plot, a track would be nonsense.
TEST(Cat001, DecodesATrackByTheOtherProfile) {
  const Octets record{0xFF, 0xFF, 0xFF, 0x80,  // FSPEC: 22 items
                      0x14, 0x82,              // 010
                      0x90,                    // 020: track, sole primary
                      0x01, 0x02,              // 161: number 258
                      0x01, 0x40, 0xC0, 0x00,  // 040
                      0xFF, 0x60, 0x00, 0x00,  // 042: x = -160/64 = -2.5 NM, y = 0
                      0x02, 0x00, 0x80, 0x00,  // 200: 512/16384 NM/s, 180 degrees
                      0x20, 0x09,              // 070: smoothed, octal 0011
                      0x3F, 0xFC,              // 090: -4/4 = FL -1
                      0x00, 0x80,              // 141: 1 s
                      0x00,                    // 130
                      0x00,                    // 131
                      0x01,                    // 120
                      0x81, 0x80,              // 170: initialisation; extent: last report
                      0x00,                    // 210
                      0x00, 0x00,              // 050
                      0x00, 0x00,              // 080
                      0x00, 0x00, 0x00, 0x00,  // 100
                      0x00, 0x00,              // 060
                      0x00,                    // 030
                      0x01,                    // SP: its length alone
                      0x00,                    // RFS: no field
                      0x00};                   // 150
  const Block block = decoded(blockOf(1, record));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  const TargetReport& track = block.reports.at(0);
  EXPECT_TRUE(track.is_track && track.primary);
  EXPECT_FALSE(track.secondary);
  EXPECT_EQ(track.track_number, 258);
  EXPECT_DOUBLE_EQ(track.x, -2.5 * kNauticalMile);
  EXPECT_DOUBLE_EQ(track.y, 0.0);
  EXPECT_DOUBLE_EQ(track.ground_speed, kNauticalMile / 32.0);
  EXPECT_DOUBLE_EQ(track.heading, 180.0 * kDegree);
  EXPECT_EQ(track.mode_3a.value, 011);
  EXPECT_TRUE(track.mode_3a.smoothed);
  EXPECT_DOUBLE_EQ(track.flight_level.level_100ft, -1.0);
}

TEST(Cat001, ReadsFieldsInRandomSequence) {
  const Octets record{0xC1, 0x01, 0x02,   // FSPEC: 010 020 … RFS (21)
                      0x08, 0x09,         // 010
                      0x00,               // 020
                      0x02,               // RFS: two fields
                      0x07, 0x00, 0x80,   // number 7: 141, 1 s
                      0x04, 0x02, 0x9C};  // number 4: 070, octal 1234
  const Block block = decoded(blockOf(1, record));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  EXPECT_DOUBLE_EQ(block.reports.at(0).time_of_day, 1.0);
  EXPECT_EQ(block.reports.at(0).mode_3a.value, 01234);
}

TEST(Cat001, LeavesUnknownWhatWasNotSent) {
  const TargetReport plot = decoded(blockOf(1, {0x80, 0x08, 0x09})).reports.at(0);
  EXPECT_TRUE(std::isnan(plot.range) && std::isnan(plot.time_of_day) && std::isnan(plot.x));
  EXPECT_FALSE(plot.mode_3a.present || plot.flight_level.present || plot.track_number || plot.aircraft_address);
}

}  // namespace
}  // namespace asterix_bridge
