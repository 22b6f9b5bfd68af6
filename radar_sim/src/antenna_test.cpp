#include "antenna.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace radar_sim {
namespace {

TEST(Antenna, EntersSectorZeroAtNorthAndEachNextOneASixtyFourthOfATurnLater) {
  const Antenna antenna(6.0, 0.0, 1000.0);
  EXPECT_EQ(antenna.firstSector(), 0);
  EXPECT_DOUBLE_EQ(antenna.entryTime(1), 1000.09375);
  EXPECT_DOUBLE_EQ(antenna.entryTime(64), 1006.0);
  EXPECT_NEAR(antenna.azimuthAt(1001.5), tws::kPi / 2.0, 1e-9);
}

// A radar that starts at 100° is in sector 17 (95.625° to 101.25°) and leaves it 1.25° later.
TEST(Antenna, StartsInsideASector) {
  const Antenna antenna(8.0, tws::radians(100.0), 1000.0);
  EXPECT_EQ(antenna.firstSector(), 17);
  EXPECT_DOUBLE_EQ(antenna.entryTime(17), 1000.0);
  EXPECT_NEAR(antenna.entryTime(18), 1000.0 + 8.0 * 1.25 / 360.0, 1e-9);
  EXPECT_NEAR(antenna.entryTime(64), 1000.0 + 8.0 * 260.0 / 360.0, 1e-9);
}

AzimuthErrors biased(double bias_deg) {
  AzimuthErrors errors;
  errors.bias = tws::radians(bias_deg);
  return errors;
}

// What the gear takes for north is half a sector (2.8125°, at 60 °/s 46.875 ms) before or behind it. With a mark at
// true north a tracker would take plots for those of the wrong sector, or find no bias where there is one.
TEST(Antenna, EntersItsSectorsByTheNorthThatItMeasures) {
  const Antenna ahead(6.0, 0.0, 1000.0, biased(2.8125));
  EXPECT_EQ(ahead.firstSector(), 0);
  EXPECT_NEAR(ahead.entryTime(1), 1000.046875, 1e-9);
  EXPECT_NEAR(ahead.entryTime(64), 1006.0 - 0.046875, 1e-9);
  const Antenna behind(6.0, 0.0, 1000.0, biased(-2.8125));
  EXPECT_EQ(behind.firstSector(), 63);
  EXPECT_EQ(behind.entryTime(63), 1000.0);
  EXPECT_NEAR(behind.entryTime(64), 1000.046875, 1e-9);
  EXPECT_NEAR(behind.measuredAngleAt(1000.0), tws::radians(357.1875), 1e-9);
}

// By hand: θ + 1° sin θ = 90° at 89.00015°; with 36 °/h, 0.01 °/s, a revolution is over after 360 / 60.01 s.
TEST(Antenna, EntersItsSectorsByAnEccentricCircleAndADriftingNorth) {
  AzimuthErrors eccentric;
  eccentric.eccentricity = tws::radians(1.0);
  EXPECT_NEAR(Antenna(6.0, 0.0, 1000.0, eccentric).entryTime(16), 1000.0 + 89.00015 / 60.0, 1e-6);
  AzimuthErrors drifting;
  drifting.north_drift = tws::radians(36.0) / 3600.0;
  EXPECT_NEAR(Antenna(6.0, 0.0, 1000.0, drifting).entryTime(64), 1000.0 + 360.0 / 60.01, 1e-9);
}

// An aircraft of 300 m/s moves 1.8 km in a turn: plots at the wrong instant would lie hundreds of metres off. Brute
// force: walk in steps of 10 us until the beam has passed the target, which bounds the answer to that step.
TEST(BeamCrossing, AgreesWithBruteForceForMovingTargets) {
  const unsigned seed = 5;
  RecordProperty("seed", static_cast<int>(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<> place(-60e3, 60e3);
  std::uniform_real_distribution<> speed(-300.0, 300.0);
  for (int i = 0; i < 20; ++i) {
    const Antenna antenna(6.0, 1.0, 1000.0);
    const double x = place(random), y = place(random), vx = speed(random), vy = speed(random);
    const auto azimuth = [&](double time) { return std::atan2(x + vx * (time - 1000.0), y + vy * (time - 1000.0)); };
    const auto crossing = antenna.crossing(1000.0, azimuth);
    ASSERT_TRUE(crossing.has_value());
    const double step = 1e-5;
    double time = 1000.0;
    const auto missing = [&](double t) { return tws::wrapPi(azimuth(t) - antenna.azimuthAt(t)); };
    while (!(missing(time) >= 0.0 && missing(time) < 0.1 && missing(time + step) < 0.0)) time += step;
    EXPECT_GE(*crossing, time - 1e-9) << "seed " << seed << ", target " << i;
    EXPECT_LE(*crossing, time + step + 1e-9) << "seed " << seed << ", target " << i;
  }
}

TEST(BeamCrossing, OfAPointThatStaysRecursEachTurn) {
  const Antenna antenna(6.0, 0.0, 1000.0);
  const auto east = [](double) { return tws::kPi / 2.0; };
  EXPECT_NEAR(antenna.crossing(1000.0, east).value(), 1001.5, 1e-9);
  EXPECT_NEAR(antenna.crossing(1003.0, east).value(), 1007.5, 1e-9);
}

// Overhead a target may turn with the beam: no crossing, rather than an endless search.
TEST(BeamCrossing, IsNotFoundForATargetThatKeepsPaceWithTheBeam) {
  const Antenna antenna(6.0, 0.0, 1000.0);
  EXPECT_FALSE(antenna.crossing(1000.0, [&](double time) { return antenna.azimuthAt(time) + 1.0; }).has_value());
}

TEST(Antenna, RefusesAPeriodOfZero) { EXPECT_THROW(Antenna(0.0, 0.0, 0.0), std::invalid_argument); }

}  // namespace
}  // namespace radar_sim
