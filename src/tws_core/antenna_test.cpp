#include <tws_core/antenna.h>

#include <gtest/gtest.h>

namespace tws {
namespace {

constexpr double kWidth = kSectorWidth;

TEST(Antenna, KnowsNothingBeforeItsFirstCrossing) {
  Antenna antenna(6.0);
  EXPECT_FALSE(antenna.known());
  antenna.cross(0, 0.0);
  EXPECT_TRUE(antenna.known());
}

// If this fails, tracks of a radar that has just been switched on are predicted for the wrong instant.
TEST(Antenna, TurnsByTheGivenPeriodUntilAWholeRevolutionIsSeen) {
  Antenna antenna(6.0);
  for (int i = 0; i < 64; ++i) antenna.cross(i, 0.125 * i);  // It really takes 8 s.
  EXPECT_DOUBLE_EQ(antenna.period(), 6.0);
  antenna.cross(64, 8.0);
  EXPECT_DOUBLE_EQ(antenna.period(), 8.0);
  EXPECT_DOUBLE_EQ(antenna.sectorDuration(), 0.125);
  EXPECT_DOUBLE_EQ(antenna.rate(), 2.0 * 3.14159265358979323846 / 8.0);
}

TEST(Antenna, FollowsAChangeOfItsSpeed) {
  Antenna antenna(8.0);
  for (int i = 0; i <= 64; ++i) antenna.cross(i, 0.125 * i);
  for (int i = 1; i <= 64; ++i) antenna.cross(64 + i, 8.0 + 0.1 * i);
  EXPECT_NEAR(antenna.period(), 6.4, 1e-12);
}

TEST(Antenna, GoesEvenlyBetweenTwoCrossings) {
  Antenna antenna(6.0);
  antenna.cross(10, 1.0);
  antenna.cross(11, 1.2);
  antenna.cross(12, 1.3);
  EXPECT_NEAR(antenna.timeAt(10.0 * kWidth), 1.0, 1e-12);
  EXPECT_NEAR(antenna.timeAt(10.25 * kWidth), 1.05, 1e-12);
  EXPECT_NEAR(antenna.timeAt(11.5 * kWidth), 1.25, 1e-12);
}

TEST(Antenna, GoesOnByItsPeriodBeyondTheNewestCrossing) {
  Antenna antenna(6.4);
  antenna.cross(10, 1.0);
  EXPECT_NEAR(antenna.timeAt(13.0 * kWidth), 1.3, 1e-12);
  EXPECT_NEAR(antenna.timeAt((10.0 + 64.0) * kWidth), 7.4, 1e-12);
}

// If this fails, lost marks bring a wrong period or a time from two turns ago.
TEST(Antenna, BridgesAGapInTheCrossings) {
  Antenna antenna(6.4);
  for (int i = 0; i <= 70; ++i) antenna.cross(i, 0.1 * i);
  antenna.cross(200, 20.0);
  EXPECT_DOUBLE_EQ(antenna.period(), 6.4);
  EXPECT_NEAR(antenna.timeAt(199.0 * kWidth), 19.9, 1e-9);  // Crossings 71 .. 199 are missing.
  EXPECT_NEAR(antenna.timeAt(201.0 * kWidth), 20.1, 1e-9);
}

// If this fails, a tracker believes the beam elsewhere than the crossings say.
TEST(Antenna, SaysWhereTheBeamIsAsItSaysWhenItIsThere) {
  Antenna antenna(6.4);
  for (int i = 0; i <= 100; ++i) antenna.cross(i, 0.1 * i + (i % 2 == 0 ? 0.0 : 0.03));
  for (const double place : {40.0, 62.5, 99.25, 100.0, 117.75}) {
    const double azimuth = antenna.azimuthAt(antenna.timeAt(place * kWidth));
    EXPECT_NEAR(azimuth, wrapTwoPi(place * kWidth), 1e-9);
    EXPECT_EQ(antenna.runningAt(antenna.timeAt(place * kWidth) + 1e-9), static_cast<std::int64_t>(place));
  }
  EXPECT_EQ(antenna.runningAt(10.0), 100);  // the very instant of a crossing
}

// If this fails, a tracker that asks before a whole revolution is misled by the period that it was given.
TEST(Antenna, LearnsItsPeriodFromAPartOfARevolutionWhenItMay) {
  Antenna whole(6.4), half(6.4, kSectors / 2);
  for (int i = 0; i <= 63; ++i) {
    whole.cross(i, 0.2 * i);
    half.cross(i, 0.2 * i);
    EXPECT_EQ(whole.period(), 6.4);
    EXPECT_NEAR(half.period(), i < 32 ? 6.4 : 12.8, 1e-9) << i;
  }
  for (int i = 64; i <= 130; ++i) half.cross(i, 0.2 * 64 + 0.1 * (i - 64));
  EXPECT_NEAR(half.period(), 6.4, 1e-9);
}

// A radar that stands still says nothing of its period.
TEST(Antenna, KeepsItsPeriodWhenCrossingsHaveAllTheSameTime) {
  Antenna antenna(6.5, kSectors / 2);
  for (int i = 0; i < 100; ++i) antenna.cross(i, 5.0);
  EXPECT_EQ(antenna.period(), 6.5);
}

TEST(SteadyBeam, TurnsOnFromWhereItPointedOnce) {
  const SteadyBeam beam{10.0, 0.5, kTwoPi / 6.0};
  EXPECT_NEAR(beam.azimuthAt(13.0), 0.5 + kTwoPi / 2.0, 1e-12);
  EXPECT_NEAR(beam.timeAt(0.5 + kTwoPi / 2.0), 13.0, 1e-12);
}

}  // namespace
}  // namespace tws
