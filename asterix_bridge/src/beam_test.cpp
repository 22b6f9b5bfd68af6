#include "beam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

constexpr double kPeriod = 4.0;

// Where a beam is that points north at 1000 s and turns once in 4 s.
double truth(double time) { return tws::kTwoPi * (time - 1000.0) / kPeriod; }

void expectFollows(const Beam& beam, double time, double tolerance_deg) {
  EXPECT_LT(std::abs(tws::angularDifference(beam.azimuthAt(time), truth(time))), tws::radians(tolerance_deg)) << time;
}

// North marks alone are what many radars send: without a beam no tracker gets any sector.
TEST(Beam, IsKnownFromNorthMarksAlone) {
  Beam beam;
  for (int turn = 0; turn < 30; ++turn) {
    const double time = 1000.0 + turn * kPeriod;
    beam.addNorth(time);
    if (beam.learn(time, time - 1.0)) expectFollows(beam, time + 1.3, 0.1);
  }
  ASSERT_TRUE(beam.isKnown());
  EXPECT_NEAR(beam.period(), kPeriod, 1e-3);
}

TEST(Beam, IsKnownFromPlotsAlone) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> gap(0.0, 0.3);
  Beam beam;
  for (double time = 1000.0; time < 1100.0; time += gap(random)) {
    beam.add(time, tws::wrapTwoPi(truth(time)));
    beam.learn(time, time - 1.0);
  }
  ASSERT_TRUE(beam.isKnown());
  EXPECT_NEAR(beam.period(), kPeriod, 1e-3);
  expectFollows(beam, 1099.0, 0.2);
}

// A lost mark must not make the radar seem to turn at half its speed.
TEST(Beam, DoesNotMindALostNorthMark) {
  Beam beam;
  for (int turn = 0; turn < 12; ++turn) {
    if (turn == 1 || turn == 6) continue;
    beam.addNorth(1000.0 + turn * kPeriod);
    beam.learn(1000.0 + turn * kPeriod, 0.0);
  }
  ASSERT_TRUE(beam.isKnown());
  EXPECT_NEAR(beam.period(), kPeriod, 1e-3);
}

// Sectors that were sent are sent: a beam that went back would give one twice.
TEST(Beam, StaysWhatItWasUpToTheTimeThatWasUsed) {
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, tws::radians(0.3));
  Beam beam;
  double used = 1000.0;
  for (double time = 1000.0; time < 1200.0; time += 0.1) {
    const double wander = tws::radians(5.0) * std::sin((time - 1000.0) / 30.0);  // of a motor that drifts
    beam.add(time, tws::wrapTwoPi(truth(time) + wander + noise(random)));
    const bool was_known = beam.isKnown();
    const double before = was_known ? beam.azimuthAt(used) : 0.0;
    beam.learn(time, used);
    if (was_known) {
      ASSERT_NEAR(beam.azimuthAt(used), before, 1e-6);
    }
    if (!beam.isKnown()) continue;
    ASSERT_GT(beam.timeAt(beam.azimuthAt(time) + 0.1), time);
    used = time - 1.0;
  }
  const double wander = tws::radians(5.0) * std::sin(199.0 / 30.0);
  EXPECT_LT(std::abs(tws::angularDifference(beam.azimuthAt(1199.0), truth(1199.0) + wander)), tws::radians(2.0));
}

TEST(Beam, GoesOnCountingTurnsAfterASilence) {
  Beam beam;
  const auto hear = [&](double from, double to) {
    for (double time = from; time < to; time += 0.1) {
      beam.add(time, tws::wrapTwoPi(truth(time)));
      beam.learn(time, time - 1.0);
    }
  };
  hear(1000.0, 1050.0);
  ASSERT_TRUE(beam.isKnown());
  const double before = beam.azimuthAt(1049.0);
  beam.interrupt();
  EXPECT_FALSE(beam.isKnown());
  hear(1150.0, 1160.0);
  ASSERT_TRUE(beam.isKnown());
  EXPECT_NEAR(beam.azimuthAt(1159.0) - before, truth(1159.0) - truth(1049.0), tws::radians(1.0));
}

// A marine radar's turn takes less than the beam is learned in.
TEST(Beam, OfAFastAntennaIsFollowedEvenly) {
  Beam beam;
  double used = 1000.0;
  const auto fast = [](double time) { return tws::kTwoPi * (time - 1000.0) / 0.4; };
  for (int i = 0; i < 12000; ++i) {
    const double time = std::round((1000.0 + i * 0.01) * 128.0) / 128.0;  // as ASTERIX tells it
    beam.add(time, tws::wrapTwoPi(fast(1000.0 + i * 0.01)));
    if (!beam.learn(time, used)) continue;
    used = std::max(used, time - 30.0);
    if (time > 1060.0) {
      ASSERT_LT(std::abs(tws::angularDifference(beam.azimuthAt(used), fast(used))), tws::radians(8.0)) << time;
    }
  }
  EXPECT_NEAR(beam.period(), 0.4, 1e-3);
}

// Twenty plots a turn at even steps agree with a turn in 0.19 s as well.
TEST(Beam, IsNotMistakenForAFasterOneByPlotsAtEvenSteps) {
  for (const bool with_norths : {true, false}) {
    Beam beam;
    for (int i = 0; i < 200; ++i) {
      const double time = 1000.0 + 0.2 * i;
      if (with_norths && i % 20 == 0) beam.addNorth(time);
      beam.add(time + 0.01, tws::wrapTwoPi(truth(time + 0.01)));
      if (beam.learn(time, 1000.0)) {
        ASSERT_NEAR(beam.period(), kPeriod, 0.01) << with_norths << ' ' << time;
      }
    }
    EXPECT_TRUE(beam.isKnown()) << with_norths;
  }
}

// A live picture should begin in less than a turn.
TEST(Beam, IsKnownFromAFewSectorMarks) {
  Beam beam;
  for (int mark = 0; mark < 20; ++mark) beam.addMark(1000.0 + mark * 0.125, tws::kTwoPi * mark / 32.0);
  ASSERT_TRUE(beam.learn(1002.5, 1000.0));
  EXPECT_NEAR(beam.period(), kPeriod, 1e-3);
}

TEST(Beam, IsNotInventedFromPlotsAnywhere) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> azimuth(0.0, tws::kTwoPi);
  Beam beam;
  for (double time = 1000.0; time < 1060.0; time += 0.2) {
    beam.add(time, azimuth(random));
    EXPECT_FALSE(beam.learn(time, time - 1.0));
  }
}

}  // namespace
}  // namespace asterix_bridge
