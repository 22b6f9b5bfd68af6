// Blocks worked by hand from the field definitions: each octet says which item it is.
#include <gtest/gtest.h>

#include <cmath>

#include "block_test_helpers.h"

namespace asterix_bridge {
namespace {

const Octets kFull002{0xFF, 0xF4,                    // FSPEC: 010 000 020 030 041 050 060 / 070 100 090 080 - SP
                      0x14, 0x82,                    // 010
                      0x02,                          // 000: sector crossing
                      0x40,                          // 020: 64/256 of a turn
                      0x00, 0x64, 0x40,              // 030: 25664/128 = 200.5 s
                      0x02, 0x01,                    // 041: 513/128 s
                      0x03, 0x02,                    // 050
                      0x02,                          // 060
                      0x02, 0x11, 0x22, 0x33, 0x44,  // 070: two counts
                      1,    2,    3,    4,    5,    6, 7, 8,  // 100
                      0x01, 0xFF,                             // 090
                      0x02,                                   // 080
                      0x01};                                  // SP
// Turns without marks are guessed; a mark at the wrong time or azimuth is worse.
TEST(Cat002, DecodesMarks) {
  const Block block = decoded(blockOf(2, kFull002 + Octets{0xD0, 0x08, 0x09, 0x01, 0x00, 0x00, 0x80}));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  ASSERT_EQ(block.messages.size(), 2u);
  const ServiceMessage& sector = block.messages[0];
  EXPECT_EQ(sector.source->sic, 130);
  EXPECT_EQ(sector.type, kSectorCrossing);
  EXPECT_DOUBLE_EQ(sector.sector_azimuth, 90.0 * kDegree);
  EXPECT_DOUBLE_EQ(sector.time_of_day, 200.5);
  EXPECT_DOUBLE_EQ(sector.antenna_period, 513.0 / 128.0);
  const ServiceMessage& north = block.messages[1];
  EXPECT_EQ(north.type, kNorthMarker);
  EXPECT_DOUBLE_EQ(north.time_of_day, 1.0);
  EXPECT_TRUE(std::isnan(north.sector_azimuth) && std::isnan(north.antenna_period));
}

const Octets kFull034{0xFF, 0xFE,                                      // FSPEC: all 14
                      0x19, 0x0D,                                      // 010
                      0x01,                                            // 000: north marker
                      0x54, 0x60, 0x00,                                // 030: 43200 s
                      0xC0,                                            // 020
                      0x02, 0x80,                                      // 041: 5 s
                      0x9C, 0x80, 0x01, 0x02, 0x03, 0x04,              // 050: COM (NOGO), PSR, SSR, MDS
                      0x9C, 0x01, 0x02, 0x03, 0x04,                    // 060: COM, PSR, SSR, MDS
                      0x01, 0x08, 0x01,                                // 070: one count
                      1,    2,    3,    4,    5,    6,    7,    8,     // 100
                      0x01,                                            // 110
                      0xFF, 0xF6, 0x20, 0x00, 0x00, 0xF0, 0x00, 0x00,  // 120: -10 m, 45 degrees, -22.5 degrees
                      0x01, 0x02,                                      // 090
                      0x02, 0xAA,                                      // RE
                      0x03, 0xAA, 0xBB};                               // SP

// If this fails, a radar stands elsewhere on the map.
TEST(Cat034, DecodesMarksAndTheRadarsPosition) {
  const Block block = decoded(blockOf(34, kFull034 + kFull034));
  ASSERT_FALSE(block.fault) << block.fault->reason;
  ASSERT_EQ(block.messages.size(), 2u);
  const ServiceMessage& message = block.messages[1];
  EXPECT_EQ(message.type, kNorthMarker);
  EXPECT_DOUBLE_EQ(message.time_of_day, 43200.0);
  EXPECT_DOUBLE_EQ(message.sector_azimuth, 270.0 * kDegree);
  EXPECT_DOUBLE_EQ(message.antenna_period, 5.0);
  ASSERT_TRUE(message.position && message.is_operational);
  EXPECT_FALSE(*message.is_operational);
  EXPECT_DOUBLE_EQ(message.position->altitude, -10.0);
  EXPECT_DOUBLE_EQ(message.position->latitude, 45.0 * kDegree);
  EXPECT_DOUBLE_EQ(message.position->longitude, -22.5 * kDegree);
}

TEST(ServiceMessages, AreRefusedWhenCutAnywhere) {
  for (std::size_t length = 1; length < kFull002.size(); ++length)
    EXPECT_TRUE(decoded(blockOf(2, Octets(kFull002.data(), kFull002.data() + length))).fault) << length;
  for (std::size_t length = 1; length < kFull034.size(); ++length)
    EXPECT_TRUE(decoded(blockOf(34, Octets(kFull034.data(), kFull034.data() + length))).fault) << length;
}

TEST(Cat034, RefusesALatitudeBeyondThePole) {
  const Octets record{0x81, 0x10, 0x19, 0x0D, 0x00, 0x00, 0x60, 0x00, 0x00, 0x00, 0x00, 0x00};  // 135 degrees
  const Block block = decoded(blockOf(34, record));
  ASSERT_TRUE(block.fault);
  EXPECT_NE(block.fault->reason.find("I034/120: latitude 135"), std::string::npos) << block.fault->reason;
}

}  // namespace
}  // namespace asterix_bridge
