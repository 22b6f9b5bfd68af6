// Turbines, birds, jammers.
#include <map>
#include <set>

#include "clutter/angels.h"
#include "clutter/clutter_test_helpers.h"
#include "clutter/jammer.h"
#include "clutter/wind_farm.h"

namespace radar_sim {
namespace {

WindFarm farm() {
  WindFarm farm;
  farm.name = "farm";
  farm.from = kTestStart;
  farm.centre = {10e3, 5e3};
  return farm;
}

TEST(WindFarm, TurbinesStandInRows) {
  const auto places = farm().outlineAt(kTestStart);
  ASSERT_EQ(places.size(), 20u);
  EXPECT_NEAR((places[1] - places[0]).norm(), 700.0, 1e-6);
  EXPECT_NEAR((places[5] - places[0]).norm(), 700.0, 1e-6);
  EXPECT_NEAR((0.5 * (places.front() + places.back()) - farm().centre).norm(), 0.0, 1e-6);
}

TEST(WindFarm, PlotsComeFromItsTurbinesAgainAndAgain) {
  const auto places = farm().outlineAt(kTestStart);
  const auto echoes = ClutterScans(farm(), viewOf("sps12")).next(10);
  EXPECT_GT(echoes.size(), 150u);
  for (const Echo& echo : echoes) {
    double nearest = 1e9;
    for (const Eigen::Vector2d& place : places) nearest = std::min(nearest, (placeOf(echo) - place).norm());
    EXPECT_LT(nearest, 10.0);  // without the errors of the measurement
  }
}

// A flash is seen when a blade stands upright while the beam is there: the rotor's turn during the dwell, 60° apart.
TEST(WindFarm, FlashesAsOftenAsTheDwellCatchesABlade) {
  WindFarm faint = farm();
  faint.rcs = 1e-9;
  faint.flash_rcs = 1e6;
  faint.suppression = 1.0;
  faint.rows = faint.columns = 10;
  const ClutterView view = viewOf("sps12");
  const double dwell = 6.0 / spokes(view.params.azimuth_beamwidth);
  const double chance = (tws::kTwoPi / 5.0 * dwell + view.params.wavelength / 120.0) / (tws::kPi / 3.0);
  const double flashes = static_cast<double>(ClutterScans(faint, view).next(200).size());
  // A small share of the flashes stays below the threshold, and beats make the number more uneven than Poisson's.
  EXPECT_NEAR(flashes / 20000.0, chance, 0.1 * chance);
}

Angels gulls() {
  Angels gulls;
  gulls.name = "gulls";
  gulls.from = kTestStart;
  gulls.rcs = {1.0, 1.0};
  return gulls;
}

TEST(Angels, AsManyFlyAsAreSaidWithinTheirCircle) {
  Angels angels = gulls();
  angels.rcs = {100.0, 100.0};
  const auto echoes = ClutterScans(angels, viewOf("sps12")).next(20);
  EXPECT_NEAR(static_cast<double>(echoes.size()) / 20.0, 30.0, 1.5);
  for (const Echo& echo : echoes) EXPECT_LT(echo.range, 20e3 + 120.0 * 20.0);
}

// If it fails, they do not look like targets, and a tracker is not tested on what birds really do to it.
TEST(Angels, FlyAtBirdsSpeedsFromScanToScan) {
  Angels one = gulls();
  one.count = 1;
  one.rcs = {100.0, 100.0};
  one.life = 1e4;
  one.course = {0.0, 0.0};
  const auto echoes = ClutterScans(one, viewOf("sps12")).next(20);
  ASSERT_GT(echoes.size(), 15u);
  const Eigen::Vector2d flown = placeOf(echoes.back()) - placeOf(echoes.front());
  const double speed = flown.norm() / (echoes.back().time - echoes.front().time);
  EXPECT_GE(speed, 8.0 - 0.1);
  EXPECT_LE(speed, 20.0 + 0.1);
  EXPECT_NEAR(flown.x(), 0.0, 30.0);
}

TEST(Angels, AfterALifeAnotherOneAppearsElsewhere) {
  Angels one = gulls();
  one.count = 1;
  one.rcs = {100.0, 100.0};
  one.life = 60.0;
  ClutterScans scans(one, viewOf("sps12"));
  const auto first = scans.next(9), second = scans.next(9);
  ASSERT_FALSE(first.empty());
  ASSERT_FALSE(second.empty());
  EXPECT_GT((placeOf(second.back()) - placeOf(first.front())).norm(), 18 * 6.0 * 20.0);
}

Jammer jammer() {
  Jammer jammer;
  jammer.name = "jammer";
  jammer.from = kTestStart;
  jammer.place = {0.0, 50e3};
  jammer.velocity = {200.0, 0.0};
  jammer.height = 1000.0;
  jammer.suppression = 1e3;
  return jammer;
}

TEST(Jammer, ItsNoiseFollowsTheOneWayEquation) {
  RadarParams radar;
  radar.beams = {{0.0, 3.0, 0.0}};  // so wide that the gain is the peak's
  const double expected = 1000.0 / 100e6 * 1000.0 * std::pow(0.23 / (4.0 * tws::kPi * 50e3), 2) / (4.0e-21 * 4.0);
  EXPECT_NEAR(jammerToNoise(radar, jammer(), 50e3) / expected, 1.0, 0.05);
  EXPECT_EQ(jammerToNoise(radar, jammer(), 600e3), 0.0);
}

TEST(Jammer, MakesAStrobeAtAllRangesThatFollowsIt) {
  const auto first = ClutterScans(jammer(), viewOf("sps12")).next();
  const auto later = ClutterScans(jammer(), viewOf("sps12"), kTestStart + 132.0).next();
  ASSERT_GT(first.size(), 50u);
  for (const Echo& echo : first) EXPECT_LT(std::abs(tws::wrapPi(echo.azimuth)), tws::radians(6.0));
  const double expected = std::atan2(22 * 6.0 * 200.0, 50e3);
  double azimuth = 0.0, nearest = 1e9, farthest = 0.0;
  for (const Echo& echo : later) {
    azimuth += tws::wrapPi(echo.azimuth) / static_cast<double>(later.size());
    nearest = std::min(nearest, echo.range);
    farthest = std::max(farthest, echo.range);
  }
  EXPECT_NEAR(azimuth, expected, tws::radians(1.5));
  EXPECT_LT(nearest, 10e3);
  EXPECT_GT(farthest, 50e3);
}

TEST(Jammer, Blinks) {
  Jammer blinking = jammer();
  blinking.place = {10e3, 50e3};  // a spoke that does not begin with the scan
  blinking.velocity = {0.0, 0.0};
  blinking.on = 12.0;
  blinking.off = 6.0;
  ClutterScans scans(blinking, viewOf("sps12"));
  EXPECT_FALSE(scans.next(2).empty());
  EXPECT_TRUE(scans.next().empty());  // from 12 to 18 s
  EXPECT_FALSE(scans.next().empty());
}

}  // namespace
}  // namespace radar_sim
