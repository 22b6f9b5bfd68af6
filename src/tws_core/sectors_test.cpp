#include <tws_core/sectors.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

TEST(SectorOf, FindsTheMiddleOfEverySectorInAnyTurn) {
  for (int sector = 0; sector < 64; ++sector) {
    for (int turn = -3; turn <= 3; ++turn) {
      EXPECT_EQ(sectorOf(radians((sector + 0.5) * 5.625 + turn * 360.0)), sector) << turn;
    }
  }
}

// A detection on a border that is counted in the wrong sector is missing from the one whose mark announces it.
TEST(SectorOf, StartsASectorExactlyAtItsBorder) {
  for (int sector = 0; sector < 64; ++sector) {
    EXPECT_EQ(sectorOf(sectorStart(sector)), sector);
    EXPECT_EQ(sectorOf(std::nextafter(sectorStart(sector), 7.0)), sector);
    const double just_before = sectorStart(sector == 0 ? 64 : sector);
    EXPECT_EQ(sectorOf(std::nextafter(just_before, 0.0)), (sector + 63) % 64);
  }
  EXPECT_EQ(sectorOf(sectorStart(64)), 0);
  EXPECT_EQ(sectorOf(-1e-17), 0);
  EXPECT_EQ(sectorOf(-1e-9), 63);
}

TEST(SectorOf, AgreesWithTheBordersForRandomAzimuths) {
  auto generator = seededGenerator();
  for (int i = 0; i < 100000; ++i) {
    const double azimuth = uniform(generator, 0.0, kTwoPi);
    const int sector = sectorOf(azimuth);
    EXPECT_LE(sectorStart(sector), azimuth);
    EXPECT_GT(sectorStart(sector + 1), azimuth);
  }
}

TEST(SectorOf, RefusesAnAzimuthThatIsNotFinite) {
  EXPECT_THROW(sectorOf(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(sectorOf(std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(SectorArithmetic, WrapsPastNorthBothWays) {
  EXPECT_EQ(wrapSector(64), 0);
  EXPECT_EQ(wrapSector(-1), 63);
  EXPECT_EQ(wrapSector(62 + 3), 1);
  EXPECT_EQ(wrapSector(-129), 63);
}

// The executive compares sectors by it: a wrong sign past north makes it run half a scan behind.
TEST(SectorArithmetic, TakesTheShorterWayAndCountsHalfATurnAsPositive) {
  EXPECT_EQ(sectorDifference(1, 63), 2);
  EXPECT_EQ(sectorDifference(63, 1), -2);
  EXPECT_EQ(sectorDifference(32, 0), 32);
  EXPECT_EQ(sectorDifference(0, 32), 32);
  EXPECT_EQ(sectorDifference(0, 31), -31);
  EXPECT_EQ(sectorDifference(-5, 64), -5);
}

}  // namespace
}  // namespace tws
