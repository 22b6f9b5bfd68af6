#include "elevation/height_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <tws_core/random_test_helpers.h>
#include <tws_core/refraction.h>

namespace adit_tracker {
namespace {

tws::Plot plotAtHeight(double time, double range, double height, double error = 0.0,
                       double sigma = tws::radians(0.15)) {
  tws::Plot plot;
  plot.time = time;
  plot.range = range;
  plot.elevation = std::asin(tws::sineOfElevation(0.0, height, range)) + error;
  plot.elevation_sigma = sigma;
  return plot;
}

class HeightFileTest : public testing::Test {
 protected:
  ElevationParams params;
  HeightFile file{params};
};

TEST_F(HeightFileTest, ATrackWithoutElevationHasNoHeight) {
  tws::Plot plot;
  plot.range = 50e3;
  file.update(1, plot);
  EXPECT_FALSE(file.at(1, 0.0));
}

// By hand: 0.15° at 100 km and elevation 4.82° (9000 m): 100 km · cos 4.82° · 0.002618 = 260.9 m.
TEST_F(HeightFileTest, TheFirstElevationGivesTheHeightAndItsError) {
  file.update(1, plotAtHeight(0.0, 100e3, 9000.0));
  const auto height = file.at(1, 0.0);
  ASSERT_TRUE(height);
  EXPECT_NEAR(height->height, 9000.0, 1e-6);
  EXPECT_NEAR(height->height_sigma, 260.9, 0.3);
  EXPECT_DOUBLE_EQ(height->climb_sigma, 10.0);
}

// A plot that does not say its error is taken to have the parameter's; at 100 km 0.2° are 349 m.
TEST_F(HeightFileTest, WhatThePlotDoesNotSayIsTheParameters) {
  file.update(1, plotAtHeight(0.0, 100e3, 3000.0, 0.0, tws::Plot::kUnknown));
  EXPECT_NEAR(file.at(1, 0.0)->height_sigma, 349.0, 0.5);
}

// By hand, after 32 s: 260.9² + (10 · 32)² + 0.5 · 32³ / 3 = 419².
TEST_F(HeightFileTest, TheUncertaintyGrowsBetweenSearchesUntilTheHeightIsNotToldAnyMore) {
  file.update(1, plotAtHeight(0.0, 100e3, 9000.0));
  EXPECT_NEAR(file.at(1, 32.0)->height_sigma, std::sqrt(260.9 * 260.9 + 320.0 * 320.0 + 5461.3), 0.5);
  EXPECT_TRUE(file.at(1, 150.0));
  EXPECT_FALSE(file.at(1, 200.0));  // 10 m/s · 200 s alone are 2000 m
  file.update(1, plotAtHeight(210.0, 100e3, 9000.0));
  EXPECT_TRUE(file.at(1, 210.0));
}

// What the filter says of itself must hold: climbing flights, a search each 32 s, e' P^-1 e of the height is 1 in the
// mean of 400 flights, sigma sqrt(2/400).
TEST_F(HeightFileTest, TheStatedErrorIsTheTrueOne) {
  std::mt19937_64 generator = tws::seededGenerator();
  std::normal_distribution<double> normal;
  double sum = 0.0, climb_sum = 0.0;
  for (std::uint32_t flight = 0; flight < 400; ++flight) {
    const double climb = 10.0 * normal(generator), start = 6000.0;
    double velocity = climb, height = start;
    for (int search = 0; search < 5; ++search) {
      file.update(flight, plotAtHeight(32.0 * search, 80e3, height, tws::radians(0.15) * normal(generator)));
      for (int step = 0; step < 320; ++step) {  // Brownian climb rate, 0.5 m²/s³
        height += 0.1 * velocity;
        velocity += std::sqrt(0.5 * 0.1) * normal(generator);
      }
    }
    const auto told = file.at(flight, 160.0);
    ASSERT_TRUE(told);
    sum += std::pow((told->height - height) / told->height_sigma, 2);
    climb_sum += std::pow((told->climb - velocity) / told->climb_sigma, 2);
  }
  EXPECT_NEAR(sum / 400.0, 1.0, 5.0 * std::sqrt(2.0 / 400.0));
  EXPECT_NEAR(climb_sum / 400.0, 1.0, 5.0 * std::sqrt(2.0 / 400.0));
}

// A swap to an aircraft 5 km higher must not drag the height along for minutes.
TEST_F(HeightFileTest, AHeightThatIsFarOffBeginsAnew) {
  for (int i = 0; i < 4; ++i) file.update(1, plotAtHeight(32.0 * i, 80e3, 4000.0));
  file.update(1, plotAtHeight(128.0, 80e3, 9000.0));
  EXPECT_NEAR(file.at(1, 128.0)->height, 9000.0, 1e-6);
  EXPECT_DOUBLE_EQ(file.at(1, 128.0)->climb, 0.0);
}

// Two radars' plots may come in inverse order: time must not run back in the filter.
TEST_F(HeightFileTest, AnEarlierElevationIsUsedWithoutHarm) {
  file.update(1, plotAtHeight(10.0, 80e3, 4000.0));
  const double before = file.at(1, 10.0)->height_sigma;
  file.update(1, plotAtHeight(9.0, 80e3, 4000.0));
  EXPECT_LT(file.at(1, 10.0)->height_sigma, before);
  EXPECT_NEAR(file.at(1, 10.0)->height, 4000.0, 1e-6);
}

TEST_F(HeightFileTest, ATrackThatIsGoneHasNoHeightNorHasItsSuccessor) {
  file.update(1, plotAtHeight(0.0, 80e3, 4000.0));
  file.remove(1);
  EXPECT_FALSE(file.at(1, 0.0));
}

// From the earth's centre: 8000 m above the sea, 150 km away on the ground.
TEST(PlaceAt, PutsATargetOverTheTrueEarth) {
  const double angle = 150e3 / tws::kMeanEarthRadius, radius = tws::kMeanEarthRadius + 8000.0;
  const double ground = radius * std::sin(angle), z = radius * std::cos(angle) - tws::kMeanEarthRadius;
  const auto place = placeAt(std::hypot(ground, z), 8000.0);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->ground, ground, 1e-3);
  EXPECT_NEAR(place->z, z, 1e-3);
  // Seen higher than it is: the ray bends down with the earth by a quarter of the bulge, R/8a.
  EXPECT_NEAR(place->elevation - std::asin(z / std::hypot(ground, z)), 150e3 / (8.0 * tws::kMeanEarthRadius), 1e-5);
}

TEST(PlaceAt, KnowsNoPlaceRightOverTheSiteNorForAHeightAboveTheRange) {
  EXPECT_FALSE(placeAt(5000.0, 4999.0));
  EXPECT_FALSE(placeAt(5000.0, 9000.0));
  EXPECT_TRUE(placeAt(5000.0, 3000.0));
}

}  // namespace
}  // namespace adit_tracker
