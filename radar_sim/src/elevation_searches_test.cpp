#include "elevation_searches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include <tws_core/angles.h>
#include <tws_core/refraction.h>

#include "flight_path.h"
#include "radar_presets.h"
#include "rotating_radar.h"

namespace radar_sim {
namespace {

RadarParams heightFinder() {
  RadarParams radar = radarPreset("SPS-39");
  radar.name = "sps39";
  radar.false_alarms_per_scan = 0.0;
  radar.azimuth_lsb = radar.range_lsb = 0.0;
  return radar;
}

constexpr double degrees(double value) { return tws::radians(value); }

// The radar of the report takes eight pairs a turn, in a shift register.
TEST(ElevationSearches, TakesEightForATurnAndLeavesTheRest) {
  ElevationSearches searches(heightFinder());
  std::vector<ElevationOrder> orders;
  for (int i = 0; i < 10; ++i) orders.push_back({degrees(20.0 * i), 50e3});
  EXPECT_EQ(searches.set(orders, tws::kTwoPi), 8U);
  EXPECT_GT(searches.gainAt(tws::kTwoPi + degrees(143.0), 50e3), 0.0);  // the eighth
  EXPECT_EQ(searches.gainAt(tws::kTwoPi + degrees(163.0), 50e3), 0.0);  // the ninth
  EXPECT_EQ(ElevationSearches(radarPreset("SPS-12")).set(orders, 0.0), 0U);
}

// 7° from where it begins, 3 km to either side.
TEST(ElevationSearches, LookInsideTheirWindowOnly) {
  ElevationSearches searches(heightFinder());
  searches.set({{degrees(40.0), 50e3}}, tws::kTwoPi);
  const auto looks = [&](double azimuth, double range) {
    return searches.gainAt(tws::kTwoPi + degrees(azimuth), range) > 0.0;
  };
  EXPECT_TRUE(looks(40.1, 47.1e3));
  EXPECT_TRUE(looks(46.9, 52.9e3));
  EXPECT_FALSE(looks(39.9, 50e3));
  EXPECT_FALSE(looks(47.1, 50e3));
  EXPECT_FALSE(looks(43.0, 46.9e3));
  EXPECT_FALSE(looks(43.0, 53.1e3));
  EXPECT_FALSE(looks(43.0 - 360.0, 50e3));  // the turn before
}

// Begun at 358°, a search ends 5° east of north: the list of the next turn must not cut it short.
TEST(ElevationSearches, GoOnAcrossNorth) {
  ElevationSearches searches(heightFinder());
  searches.set({{degrees(358.0), 50e3}}, 0.0);
  searches.set({{degrees(90.0), 60e3}}, tws::kTwoPi);
  EXPECT_GT(searches.gainAt(tws::kTwoPi + degrees(4.0), 50e3), 0.0);
  EXPECT_GT(searches.gainAt(tws::kTwoPi + degrees(93.0), 60e3), 0.0);
  searches.set({}, 2.0 * tws::kTwoPi);
  EXPECT_EQ(searches.gainAt(tws::kTwoPi + degrees(93.0), 60e3), 0.0);
}

// By hand: four scans, 1.75° apart, of a beam of 1.5°: right on one of them 1 plus two neighbours of 2^(-8 (1.75/1.5)²)
// each; half way between two of them 2 · 2^(-8 (0.875/1.5)²).
TEST(ElevationSearches, TheScansOfASearchAddUp) {
  ElevationSearches searches(heightFinder());
  searches.set({{0.0, 50e3}}, 0.0);
  EXPECT_NEAR(searches.gainAt(degrees(2.625), 50e3), 1.0 + 2.0 * std::exp2(-8.0 * 49.0 / 36.0), 1e-4);
  EXPECT_NEAR(searches.gainAt(degrees(3.5), 50e3), 2.0 * std::exp2(-8.0 * 49.0 / 144.0), 1e-4);
}

class SearchedTargets : public testing::Test {
 protected:
  static constexpr double kStart = 1000.0;

  void add(const std::string& name, double azimuth_deg, double range, double height) {
    PathStart start;
    start.time = kStart;
    start.position = range * Eigen::Vector2d(std::sin(degrees(azimuth_deg)), std::cos(degrees(azimuth_deg)));
    start.height = height;
    Target target;
    target.name = name;
    target.reflection.rcs = 20.0;
    target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
    targets.push_back(target);
  }

  /// All plots of so many turns, with the same orders for each from the second one on.
  std::vector<tws::Plot> turn(int turns, const std::vector<ElevationOrder>& orders) {
    RotatingRadar radar(params, Eigen::Isometry3d::Identity(), targets, {}, 11, kStart);
    std::vector<tws::Plot> plots;
    for (int i = 0; i < turns * tws::kSectors; ++i) {
      if (radar.isNorthNext()) radar.setElevationSearches(orders);
      const tws::RadarSector sector = radar.closeSector();
      plots.insert(plots.end(), sector.plots.begin(), sector.plots.end());
    }
    return plots;
  }

  RadarParams params = heightFinder();
  std::vector<Target> targets;
};

bool hasElevation(const tws::Plot& plot) { return !std::isnan(plot.elevation); }

// Mean and scatter of many searches against the elevation over the 4/3 earth: a bias would become a wrong height.
TEST_F(SearchedTargets, TheElevationIsThatOfTheTargetWithTheStatedError) {
  add("alpha", 63.0, 60e3, 6000.0);
  const double range = std::hypot(60e3, 6000.0);
  const double expected = std::asin(tws::sineOfElevation(35.0, 6000.0, range));
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const tws::Plot& plot : turn(400, {{degrees(60.0), 60e3}})) {
    if (!hasElevation(plot)) continue;
    EXPECT_DOUBLE_EQ(plot.elevation_sigma, degrees(0.15));
    const double error = (plot.elevation - expected) / plot.elevation_sigma;
    sum += error;
    squares += error * error;
    ++count;
  }
  ASSERT_GT(count, 200.0);
  EXPECT_LT(std::abs(sum / count), 4.0 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1.0, 4.0 * std::sqrt(2.0 / count));
}

TEST_F(SearchedTargets, OfTwoInTheIntervalBothAreMeasuredAndOneOutsideIsNot) {
  add("alpha", 63.0, 60e3, 6000.0);
  add("beta", 63.5, 62e3, 3000.0);
  add("gamma", 63.2, 70e3, 6000.0);
  std::map<int, int> measured;  // by range [km]
  for (const tws::Plot& plot : turn(60, {{degrees(60.0), 60e3}})) {
    if (hasElevation(plot)) ++measured[static_cast<int>(std::lround(plot.range / 1000.0))];
  }
  EXPECT_GT(measured[60], 30);
  EXPECT_GT(measured[62], 30);
  EXPECT_EQ(measured.count(70), 0U);
}

// Searches must not disturb what else there is: a scenario's results would depend on who is designated.
TEST_F(SearchedTargets, ASearchChangesNoOtherPlot) {
  params.false_alarms_per_scan = 20.0;
  add("alpha", 63.0, 60e3, 6000.0);
  add("beta", 63.2, 90e3, 4000.0);
  add("gamma", 200.0, 60e3, 6000.0);
  const auto without = turn(50, {}), with = turn(50, {{degrees(60.0), 60e3}});
  std::size_t i = 0;
  int searched = 0;
  for (const tws::Plot& plot : with) {
    searched += hasElevation(plot);
    if (i < without.size() && plot.time == without[i].time && plot.range == without[i].range &&
        plot.azimuth == without[i].azimuth)
      ++i;
    else
      EXPECT_TRUE(hasElevation(plot)) << "a plot at " << plot.time << " that neither search made";
  }
  EXPECT_EQ(i, without.size());
  EXPECT_GT(searched, 20);
}

// The beams of the search end at 20°; the scans go up to 45°.
TEST_F(SearchedTargets, WhatFliesAboveTheSearchBeamsIsFoundByTheScans) {
  add("alpha", 63.0, 20e3, 11000.0);  // 29°
  add("beta", 103.0, 10e3, 12000.0);  // 50°
  for (const tws::Plot& plot : turn(30, {})) ADD_FAILURE() << "seen at " << plot.range;
  const auto plots = turn(30, {{degrees(60.0), 22.8e3}, {degrees(100.0), 15.6e3}});
  EXPECT_GT(plots.size(), 20U);
  for (const tws::Plot& plot : plots) EXPECT_NEAR(plot.azimuth, degrees(63.0), degrees(2.0));
}

}  // namespace
}  // namespace radar_sim
