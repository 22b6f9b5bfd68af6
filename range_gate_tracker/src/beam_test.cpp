#include "beam.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>

namespace range_gate_tracker {
namespace {

tws::RadarSector sectorOf(std::int64_t n, double period) {
  return {
      static_cast<int>(n % 64), n, static_cast<double>(n) * period / 64, static_cast<double>(n + 1) * period / 64, {}};
}

// If this fails, windows open before or after the beam has passed their targets.
TEST(Beam, KnowsWhereItPointsFromItsLatestTurn) {
  Beam beam(10.0);
  for (std::int64_t n = 0; n <= 200; ++n) beam.hear(sectorOf(n, 6.0));
  EXPECT_NEAR(beam.period(), 6.0, 1e-12);
  EXPECT_NEAR(beam.azimuthAt(6.0 * 4.25), tws::kPi / 2.0, 1e-9);
  EXPECT_NEAR(beam.azimuthAt(6.0 * 2.75), 1.5 * tws::kPi, 1e-9);  // in the past
  EXPECT_EQ(beam.runningAt(6.0 * 4.25 + 0.01), 4 * 64 + 16);
  EXPECT_NEAR(beam.now(), 201 * 6.0 / 64, 1e-12);
}

TEST(Beam, TakesThePeriodThatItWasToldUntilHalfATurnWasHeard) {
  Beam beam(6.5);
  for (std::int64_t n = 0; n < 30; ++n) beam.hear(sectorOf(n, 6.0));
  EXPECT_EQ(beam.period(), 6.5);
}

TEST(Beam, KeepsItsPeriodWhenSectorsHaveAllTheSameTime) {
  Beam beam(6.5);
  for (std::int64_t n = 0; n < 100; ++n) beam.hear({static_cast<int>(n % 64), n, 5.0, 5.0, {}});
  EXPECT_EQ(beam.period(), 6.5);
}

}  // namespace
}  // namespace range_gate_tracker
