#include "sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

// The drawn beam must be where the radar's is at that data time, or detections appear before the beam has come by.
TEST(Sweep, AtItsMarkTheBeamIsAtTheSectorsStart) {
  Sweep sweep;
  sweep.mark({100.0, 16, 1040, 6.0});
  EXPECT_NEAR(*sweep.azimuthAt(100.0), tws::kPi / 2.0, 1e-12);
}

TEST(Sweep, AnEighthOfAPeriodLaterTheBeamHasTurnedFortyFiveDegrees) {
  Sweep sweep;
  sweep.mark({100.0, 60, 60, 8.0});  // 337.5 degrees
  EXPECT_NEAR(*sweep.azimuthAt(101.0), 22.5 * tws::kPi / 180.0, 1e-12);
}

TEST(Sweep, AnUnknownPeriodIsTakenFromTwoMarks) {
  Sweep sweep;
  sweep.mark({100.0, 0, 640, NAN});
  EXPECT_FALSE(sweep.azimuthAt(100.0));
  sweep.mark({100.25, 2, 642, NAN});  // two of 64 sectors in a quarter of a second: 8 s a turn
  EXPECT_NEAR(sweep.rotationPeriod(), 8.0, 1e-12);
  EXPECT_NEAR(*sweep.azimuthAt(101.25), (2.0 / 64.0 + 1.0 / 8.0) * tws::kTwoPi, 1e-12);
}

// A radar that has failed must not seem to turn on.
TEST(Sweep, ARadarSilentForHalfATurnShowsNoBeam) {
  Sweep sweep;
  sweep.mark({100.0, 0, 0, 6.0});
  EXPECT_TRUE(sweep.azimuthAt(102.9));
  EXPECT_FALSE(sweep.azimuthAt(103.1));
  sweep.mark({200.0, 0, 64, 6.0});
  EXPECT_TRUE(sweep.azimuthAt(200.5));
}

// A mark that arrives late must not throw the beam back.
TEST(Sweep, AnEarlierMarkIsIgnored) {
  Sweep sweep;
  sweep.mark({100.0, 32, 32, 6.0});
  sweep.mark({99.0, 21, 21, 6.0});
  EXPECT_NEAR(*sweep.azimuthAt(100.0), tws::kPi, 1e-12);
}

TEST(Sweep, TheBeamEndsAtTheRimOfThePicture) {
  EXPECT_DOUBLE_EQ(distanceToRim({0.0, 0.0}, {0.6, 0.8}, 100.0), 100.0);
  // From (60, 0) straight north to the circle of 100: 80, by 3-4-5.
  EXPECT_DOUBLE_EQ(distanceToRim({60.0, 0.0}, {0.0, 1.0}, 100.0), 80.0);
  EXPECT_DOUBLE_EQ(distanceToRim({60.0, 0.0}, {-1.0, 0.0}, 100.0), 160.0);
  EXPECT_DOUBLE_EQ(distanceToRim({100.0, 100.0}, {0.0, -1.0}, 100.0), 0.0);
}

// The glow trails the beam. Ahead of it, it would show the turn the wrong way round.
TEST(Sweep, TheAfterglowLiesBehindTheBeamAndFades) {
  Drawing drawing;
  const double azimuth = tws::kPi / 2.0;
  addSweep(drawing, {0.0, 0.0}, azimuth, {{0.0f, 1.0f, 0.0f, 1.0f}, tws::kPi / 3.0, 1000.0, 2.0});
  ASSERT_GT(drawing.triangles.size(), 6u);
  const std::size_t beam = drawing.triangles.size() - 6;
  for (std::size_t i = 0; i < beam; i += 3) {
    for (const std::size_t rim : {i + 1, i + 2}) {
      const Eigen::Vector2d& p = drawing.triangles[rim].position;
      const double behind = azimuth - std::atan2(p.x(), p.y());
      EXPECT_GE(behind, -1e-9);
      EXPECT_LE(behind, tws::kPi / 3.0 + 1e-9);
    }
    EXPECT_GT(drawing.triangles[i + 1].color.a, drawing.triangles[i + 2].color.a);
  }
  EXPECT_NEAR(drawing.triangles[beam - 1].color.a, 0.0f, 1e-6f);
  // The beam itself: a line to the east.
  for (std::size_t i = beam; i < drawing.triangles.size(); ++i)
    EXPECT_NEAR(drawing.triangles[i].position.y(), 0.0, 1.0 + 1e-9);
}

}  // namespace
}  // namespace tws_rviz
