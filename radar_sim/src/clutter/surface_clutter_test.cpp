// Sea, land, and what bent rays show of them.
#include <map>
#include <set>

#include "clutter/anomalous_propagation.h"
#include "clutter/clutter_test_helpers.h"
#include "clutter/land_clutter.h"
#include "clutter/sea_clutter.h"
#include "clutter/second_time_around.h"
#include "propagation.h"

namespace radar_sim {
namespace {

template <class Kind>
Kind named(double suppression_db) {
  Kind kind;
  kind.name = "clutter";
  kind.from = kTestStart;
  kind.suppression = std::pow(10.0, suppression_db / 10.0);
  return kind;
}

std::size_t countBetween(const std::vector<Echo>& echoes, double least, double greatest) {
  return static_cast<std::size_t>(std::count_if(
      echoes.begin(), echoes.end(), [&](const Echo& echo) { return echo.range >= least && echo.range < greatest; }));
}

std::size_t countTowards(const std::vector<Echo>& echoes, double azimuth) {
  return static_cast<std::size_t>(std::count_if(echoes.begin(), echoes.end(), [&](const Echo& echo) {
    return std::abs(tws::angularDifference(echo.azimuth, azimuth)) < tws::kPi / 6.0;
  }));
}

// The report tabulates, from measurements by many, about -42 dB at 10 GHz, sea state 3 and 1°, and states 2 to 3 dB.
TEST(SeaClutter, ReflectsAsTheEmpiricalModelSays) {
  EXPECT_NEAR(10.0 * std::log10(seaReflectivity(0.03, 3.0, tws::radians(1.0))), -43.3, 0.3);
  EXPECT_GT(seaReflectivity(0.03, 5.0, 0.01), 3.0 * seaReflectivity(0.03, 3.0, 0.01));
  EXPECT_GT(seaReflectivity(0.1, 3.0, 0.02), 2.0 * seaReflectivity(0.1, 3.0, 0.01));
}

TEST(SeaClutter, FallsWithRangeAndEndsAtTheHorizon) {
  const ClutterView view = viewOf("sps12");
  const auto echoes = ClutterScans(named<SeaClutter>(30.0), view).next(3);
  const auto near = countBetween(echoes, 2e3, 5e3), middle = countBetween(echoes, 5e3, 8e3);
  EXPECT_GT(near, 1.5 * static_cast<double>(middle));
  EXPECT_GT(middle, 1.5 * static_cast<double>(countBetween(echoes, 8e3, 11e3)));
  EXPECT_EQ(countBetween(echoes, horizonDistance(view.params.antenna_height) + 200.0, 1e9), 0u);
}

TEST(SeaClutter, IsStrongestUpwindAndWeakestDownwind) {
  SeaClutter sea = named<SeaClutter>(70.0);
  sea.wind_from = tws::radians(290.0);
  sea.texture.spread_db = 0.0;
  const auto echoes = ClutterScans(sea, viewOf("sps12")).next(10);
  const auto up = countTowards(echoes, sea.wind_from), across = countTowards(echoes, sea.wind_from + tws::kPi / 2.0);
  EXPECT_GT(up, 1.15 * static_cast<double>(across));
  EXPECT_GT(across, 1.15 * static_cast<double>(countTowards(echoes, sea.wind_from + tws::kPi)));
  EXPECT_NEAR(10.0 * std::log10(upwindFactor(0.03, 0.0, 0.0) / upwindFactor(0.03, 0.0, tws::kPi)), 6.0, 0.2);
}

TEST(SeaClutter, KeepsToItsArea) {
  SeaClutter sea = named<SeaClutter>(30.0);
  sea.area = Area({{-60e3, -60e3}, {-60e3, 60e3}, {0.0, 60e3}, {0.0, -60e3}});
  const auto echoes = ClutterScans(sea, viewOf("sps12")).next();
  ASSERT_GT(echoes.size(), 100u);
  for (const Echo& echo : echoes) EXPECT_LT(placeOf(echo).x(), 500.0);
}

// Clutter maps and MTI live on land that comes again in the same cells, unlike the sea.
TEST(LandClutter, ComesAgainInTheSameCells) {
  const ClutterView view = viewOf("sps12");
  const auto repeated = [&](const LandClutter& land) {
    std::set<std::pair<long, long>> first;
    for (const Echo& echo : ClutterScans(land, view).next()) first.insert(cellOf(echo, view.params));
    double again = 0.0;
    for (const Echo& echo : ClutterScans(land, view, kTestStart + 120.0).next())
      again += static_cast<double>(first.count(cellOf(echo, view.params)));
    return again / static_cast<double>(first.size());
  };
  const double land = repeated(named<LandClutter>(90.0));
  LandClutter leaves = named<LandClutter>(90.0);
  leaves.steady_share = 0.0;
  leaves.texture.time = 5.0;
  EXPECT_GT(land, 0.6);
  EXPECT_LT(repeated(leaves), 0.5 * land);
}

TEST(LandClutter, IsSeenAsFarAsItIsHigh) {
  LandClutter hills = named<LandClutter>(30.0);
  hills.height = 20.0;
  const double horizon = horizonDistance(25.0) + horizonDistance(20.0);
  const auto low = ClutterScans(hills, viewOf("sps12")).next();
  EXPECT_EQ(countBetween(low, horizon + 200.0, 1e9), 0u);
  hills.height = 500.0;
  EXPECT_GT(countBetween(ClutterScans(hills, viewOf("sps12")).next(), horizon + 200.0, 1e9), 50u);
}

TEST(SecondTimeAround, FoldsMountainsIntoARing) {
  SecondTimeAround ring = named<SecondTimeAround>(30.0);
  ring.range = {170e3, 180e3};
  ring.azimuth = {tws::radians(330.0), tws::radians(370.0)};
  const auto echoes = ClutterScans(ring, viewOf("sps12")).next(3);
  ASSERT_GT(echoes.size(), 50u);
  for (const Echo& echo : echoes) {
    EXPECT_GE(echo.range, 20e3 - 200.0);
    EXPECT_LE(echo.range, 30e3 + 200.0);
    EXPECT_LT(std::abs(tws::angularDifference(echo.azimuth, tws::radians(350.0))), tws::radians(22.5));
  }
}

TEST(AnomalousPropagation, ShowsTheSurfaceBeyondTheHorizonOnly) {
  const ClutterView view = viewOf("sps12");
  const auto echoes = ClutterScans(named<AnomalousPropagation>(45.0), view).next();
  ASSERT_GT(echoes.size(), 100u);
  EXPECT_EQ(countBetween(echoes, 0.0, horizonDistance(view.params.antenna_height) - 200.0), 0u);
}

// A duct forms and goes: what a map learned of it an hour ago is no use.
TEST(AnomalousPropagation, WaxesAndWanesOverItsTime) {
  const ClutterView view = viewOf("sps12");
  const auto repeated = [&](double later) {
    const auto duct = named<AnomalousPropagation>(55.0);
    std::set<std::pair<long, long>> first;
    for (const Echo& echo : ClutterScans(duct, view).next()) first.insert(cellOf(echo, view.params));
    double again = 0.0;
    for (const Echo& echo : ClutterScans(duct, view, kTestStart + later).next())
      again += static_cast<double>(first.count(cellOf(echo, view.params)));
    return again / static_cast<double>(first.size());
  };
  EXPECT_GT(repeated(6.0), 1.5 * repeated(2400.0));
}

}  // namespace
}  // namespace radar_sim
