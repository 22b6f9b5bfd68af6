#include "mast.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radar_sim {
namespace {

constexpr double kRunStart = 1000.0;

// A plot with the time of the mark, or later, would belong to the next sector.
TEST(Mast, KeepsAStampInItsSectorAndBeforeTheMark) {
  Mast mast(6.0, 0.0, 0.008, kRunStart);
  const SectorSpan sector = mast.closeSector();
  EXPECT_EQ(sector.running, 0);
  EXPECT_EQ(sector.enter_time, kRunStart);
  EXPECT_NEAR(sector.leave_time, 1000.088, 1e-9);  // 6 s / 64 = 93.75 ms, the last tick gone by
  EXPECT_NEAR(mast.stampWithin(sector, 1000.0501), 1000.048, 1e-9);
  EXPECT_NEAR(mast.stampWithin(sector, 1000.0936), 1000.080, 1e-9);
  EXPECT_EQ(mast.stampWithin(sector, 999.0), kRunStart);
}

TEST(Mast, WithoutTicksTellsTheTimeItself) {
  Mast mast(6.0, 0.0, 0.0, kRunStart);
  const SectorSpan sector = mast.closeSector();
  EXPECT_NEAR(sector.leave_time, 1000.09375, 1e-9);
  EXPECT_EQ(mast.stampWithin(sector, 1000.0501), 1000.0501);
}

// A second fast by 100 millionths: all stamps are of that clock; when things happen is not changed by it.
TEST(Mast, StampsByItsClock) {
  RegistrationErrors errors;
  errors.clock = {1.0, 1e-4};
  Mast mast(6.0, 0.0, 0.0, kRunStart, errors);
  EXPECT_NEAR(mast.nextMark(), 1000.09375, 1e-9);
  EXPECT_NEAR(mast.nextStamp(), 1001.093759375, 1e-9);
  const SectorSpan sector = mast.closeSector();
  EXPECT_NEAR(sector.enter_time, 1001.0, 1e-9);
  EXPECT_NEAR(sector.leave_time, 1001.093759375, 1e-9);
  EXPECT_NEAR(mast.stampWithin(sector, 1000.05), 1001.050005, 1e-9);
  EXPECT_NEAR(mast.rotationPeriod(65), 6.0006, 1e-9);
}

TEST(Mast, KnowsItsPeriodFromTheFirstFullTurnOn) {
  const Mast mast(4.0, 0.0, 0.008, kRunStart);
  EXPECT_TRUE(std::isnan(mast.rotationPeriod(64)));
  EXPECT_NEAR(mast.rotationPeriod(65), 4.0, 1e-9);
}

}  // namespace
}  // namespace radar_sim
