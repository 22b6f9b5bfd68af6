// Blocks worked by hand from the field definitions: each octet says which item it is.
#include <gtest/gtest.h>

#include <cmath>

#include "block_test_helpers.h"

namespace asterix_bridge {
namespace {

constexpr double kNauticalMile = 1852.0;

// All 28 items, so that each is at least passed over rightly: what follows a wrong length is nonsense.
const Octets kFullRecord{
    0xFF, 0xFF, 0xFF, 0xFE,                          // FSPEC
    0x19, 0xC9,                                      // 010: 25/201
    0x54, 0x60, 0x00,                                // 140: 0x546000/128 = 43200 s
    0xF1, 0x80,                                      // 020: Mode S roll-call and PSR, simulated; test target
    0x19, 0x00, 0x20, 0x00,                          // 040: 6400/256 = 25 NM, 45 degrees
    0x0F, 0xFF,                                      // 070: octal 7777
    0x40, 0x29,                                      // 090: garbled, 41/4 = FL 10.25
    0xFE, 0x40, 0x03, 0xBF, 0x20, 0xC0, 0xFE, 0x08,  // 130: see below
    0x4C, 0xA1, 0x52,                                // 220
    0x04, 0x20, 0xF1, 0x83, 0x28, 0x20,              // 240: ABC1 2
    0x02, 1,    2,    3,    4,    5,    6,    7,    8, 1, 2, 3, 4, 5, 6, 7, 8,  // 250: two registers
    0xF1, 0x23,                                            // 161: 0x123, above it four bits without meaning
    0x01, 0x00, 0xFF, 0x00,                                // 042: 256/128 = 2 NM, -2 NM
    0x04, 0x00, 0x40, 0x00,                                // 200: 1024/16384 NM/s, 90 degrees
    0x01, 0x40,                                            // 170
    1,    2,    3,    4,                                   // 210
    0x03, 0x02,                                            // 030
    0x00, 0x00,                                            // 080
    0x00, 0x00, 0x00, 0x00,                                // 100
    0x3F, 0xFE,                                            // 110: -2 * 25 ft
    0xC0, 0x03, 0xFF, 0x01, 1,    2,    3,    4,    5, 6,  // 120: CAL -1 m/s, one RDS
    0x20, 0xFD,                                            // 230
    1,    2,    3,    4,    5,    6,    7,                 // 260
    0x9F,                                                  // 055: not validated, 73
    0x02, 0x9C,                                            // 050: octal 1234
    0x00,                                                  // 065
    0x00, 0x00,                                            // 060
    0x02, 0xAB,                                            // SP
    0x03, 0xAB, 0xCD,                                      // RE
};

// If this fails, every plot of a Mode S radar stands at the wrong place or time.
TEST(Cat048, DecodesPositionTimeAndType) {
  const Block block = decoded(blockOf(48, kFullRecord + kFullRecord));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  ASSERT_EQ(block.reports.size(), 2u);
  const TargetReport& report = block.reports[1];
  EXPECT_EQ(report.source->sac, 25);
  EXPECT_EQ(report.source->sic, 201);
  EXPECT_DOUBLE_EQ(report.time_of_day, 43200.0);
  EXPECT_FALSE(report.is_time_truncated);
  EXPECT_TRUE(report.primary && report.secondary && report.mode_s && report.simulated && report.test_target);
  EXPECT_DOUBLE_EQ(report.range, 25.0 * kNauticalMile);
  EXPECT_DOUBLE_EQ(report.azimuth, 45.0 * kDegree);
  EXPECT_DOUBLE_EQ(report.x, 2.0 * kNauticalMile);
  EXPECT_DOUBLE_EQ(report.y, -2.0 * kNauticalMile);
  EXPECT_TRUE(report.is_track);
  EXPECT_EQ(report.track_number, 0x123);
  EXPECT_DOUBLE_EQ(report.ground_speed, kNauticalMile / 16.0);
  EXPECT_DOUBLE_EQ(report.heading, 90.0 * kDegree);
  EXPECT_DOUBLE_EQ(report.range_rate, -1.0);
}

// If this fails, labels show wrong codes, levels or names.
TEST(Cat048, DecodesIdentityAndHeight) {
  const TargetReport report = decoded(blockOf(48, kFullRecord)).reports.at(0);
  EXPECT_EQ(report.mode_3a.value, 07777);
  EXPECT_TRUE(report.mode_3a.validated);
  EXPECT_EQ(report.mode_2.value, 01234);
  EXPECT_EQ(report.mode_1.value, 073);
  EXPECT_FALSE(report.mode_1.validated);
  EXPECT_DOUBLE_EQ(report.flight_level.level_100ft, 10.25);
  EXPECT_TRUE(report.flight_level.garbled);
  EXPECT_EQ(report.aircraft_address, 0x4CA152u);
  EXPECT_STREQ(report.callsign.data(), "ABC1 2");
  EXPECT_DOUBLE_EQ(report.height_3d, -50.0 * 0.3048);
}

TEST(Cat048, DecodesPlotCharacteristics) {
  const PlotCharacteristics plot = decoded(blockOf(48, kFullRecord)).reports.at(0).characteristics;
  EXPECT_DOUBLE_EQ(plot.ssr_run_length, 64.0 * 360.0 / 8192.0 * kDegree);
  EXPECT_DOUBLE_EQ(plot.ssr_replies, 3.0);
  EXPECT_DOUBLE_EQ(plot.ssr_amplitude_dbm, -65.0);
  EXPECT_DOUBLE_EQ(plot.primary_run_length, 32.0 * 360.0 / 8192.0 * kDegree);
  EXPECT_DOUBLE_EQ(plot.primary_amplitude_dbm, -64.0);
  EXPECT_DOUBLE_EQ(plot.primary_less_ssr_range, -2.0 / 256.0 * kNauticalMile);
  EXPECT_DOUBLE_EQ(plot.primary_less_ssr_azimuth, 8.0 * 360.0 / 16384.0 * kDegree);
}

TEST(Cat048, TellsWhichRadarSawTheTarget) {
  struct Case {
    std::uint8_t type;
    bool primary, secondary, mode_s;
  };
  for (const Case& c : {Case{0, false, false, false},
                        {1, true, false, false},
                        {2, false, true, false},
                        {3, true, true, false},
                        {4, false, true, true},
                        {5, false, true, true},
                        {6, true, true, true},
                        {7, true, true, true}}) {
    const Octets record{0xA0, 1, 2, static_cast<std::uint8_t>(c.type << 5)};
    const TargetReport report = decoded(blockOf(48, record)).reports.at(0);
    EXPECT_EQ(report.type, c.type);
    EXPECT_EQ(report.primary, c.primary) << int{c.type};
    EXPECT_EQ(report.secondary, c.secondary) << int{c.type};
    EXPECT_EQ(report.mode_s, c.mode_s) << int{c.type};
  }
}

TEST(Cat048, RefusesARecordCutAnywhere) {
  for (std::size_t length = 1; length < kFullRecord.size(); ++length) {
    const Octets cut(kFullRecord.begin(), kFullRecord.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_TRUE(decoded(blockOf(48, cut)).fault) << length;
  }
}

// A speed that the radar itself doubts would bend a track.
TEST(Cat048, LeavesADoubtfulDopplerSpeedOut) {
  const Octets record{0x81, 0x01, 0x04, 1, 2, 0x80, 0x80, 0x05};  // FSPEC: 010, 120 (FRN 20)
  const Block block = decoded(blockOf(48, record));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  EXPECT_TRUE(std::isnan(block.reports.at(0).range_rate));
}

}  // namespace
}  // namespace asterix_bridge
