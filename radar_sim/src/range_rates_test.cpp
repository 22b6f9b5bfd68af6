#include "range_rates.h"

#include <gtest/gtest.h>

#include <memory>

#include "clutter/clutter_test_helpers.h"
#include "clutter/jammer.h"
#include "clutter/land_clutter.h"
#include "clutter/rain.h"
#include "clutter/sea_clutter.h"

namespace radar_sim {
namespace {

ClutterView doppler(double sigma) {
  ClutterView view = viewOf("sps12");
  view.params.range_rate_sigma = sigma;
  return view;
}

/// Mean and standard deviation of (rate − what is expected of the direction).
template <class Expected>
std::pair<double, double> errors(const std::vector<Echo>& echoes, const Expected& expected) {
  double sum = 0.0, squares = 0.0;
  for (const Echo& echo : echoes) {
    const double error = echo.range_rate - expected(Eigen::Vector2d(placeOf(echo).normalized()));
    sum += error;
    squares += error * error;
  }
  const auto n = static_cast<double>(echoes.size());
  return {sum / n, std::sqrt(squares / n)};
}

TEST(RangeRates, FoldTowardsZero) {
  RadarParams radar;
  EXPECT_EQ(folded(radar, 250.0), 250.0);
  radar.range_rate_ambiguity = 100.0;
  EXPECT_NEAR(folded(radar, 250.0 - 1e-9), 50.0, 1e-6);
  EXPECT_NEAR(folded(radar, -130.0), -30.0, 1e-12);
}

// If it fails, a tracker that tells targets from rain by their speed is tested on rain that hangs still.
TEST(RangeRates, OfRainAreThoseOfTheWind) {
  Rain rain;
  rain.name = "shower";
  rain.from = kTestStart;
  rain.centre = {20e3, 10e3};
  rain.velocity = {12.0, 5.0};
  rain.rate = 20.0 * kMillimetrePerHour;
  rain.suppression = 30.0;
  const auto echoes = ClutterScans(rain, doppler(1.5)).next(10);
  ASSERT_GT(echoes.size(), 100u);
  const auto [mean, spread] =
      errors(echoes, [](const Eigen::Vector2d& direction) { return direction.dot(Eigen::Vector2d(12.0, 5.0)); });
  const double bound = 4.5 / std::sqrt(static_cast<double>(echoes.size()));
  EXPECT_NEAR(mean, 0.0, 2.5 * bound);
  EXPECT_NEAR(spread, 2.5, 2.5 * bound);  // hypot(2, 1.5)
}

TEST(RangeRates, OfLandAreNearNothing) {
  LandClutter land;
  land.name = "land";
  land.from = kTestStart;
  land.suppression = 1e5;
  const auto echoes = ClutterScans(land, doppler(0.4)).next(2);
  ASSERT_GT(echoes.size(), 100u);
  const auto [mean, spread] = errors(echoes, [](const Eigen::Vector2d&) { return 0.0; });
  EXPECT_NEAR(mean, 0.0, 0.2);
  EXPECT_NEAR(spread, 0.5, 0.1);  // hypot(0.3, 0.4)
}

TEST(RangeRates, OfTheSeaGoBeforeTheWind) {
  SeaClutter sea;
  sea.name = "sea";
  sea.from = kTestStart;
  sea.sea_state = 4.0;
  sea.wind_from = 0.0;
  const auto echoes = ClutterScans(sea, doppler(1.0)).next(5);
  ASSERT_GT(echoes.size(), 100u);
  const double drift = driftOfSea(4.0);
  EXPECT_NEAR(drift, 1.9, 0.1);
  const auto mean = errors(echoes, [&](const Eigen::Vector2d& direction) { return -drift * direction.y(); }).first;
  EXPECT_NEAR(mean, 0.0, 6.0 / std::sqrt(static_cast<double>(echoes.size())));
}

TEST(RangeRates, OfAJammerAreThoseOfNoise) {
  Jammer jammer;
  jammer.name = "jammer";
  jammer.from = kTestStart;
  jammer.place = {0.0, 50e3};
  jammer.height = 1000.0;
  jammer.suppression = 1e3;
  const auto echoes = ClutterScans(jammer, doppler(1.0)).next(3);
  ASSERT_GT(echoes.size(), 100u);
  const auto [mean, spread] = errors(echoes, [](const Eigen::Vector2d&) { return 0.0; });
  EXPECT_NEAR(mean, 0.0, 40.0);
  EXPECT_NEAR(spread, 600.0 / std::sqrt(12.0), 20.0);
}

// If it fails, a scenario's clutter changes when its radar learns to measure range rates.
TEST(RangeRates, TakeNoRandomNumbersFromOthers) {
  Rain rain;
  rain.name = "shower";
  rain.from = kTestStart;
  rain.centre = {20e3, 10e3};
  const auto without = ClutterScans(rain, viewOf("sps12")).next(3), with = ClutterScans(rain, doppler(1.0)).next(3);
  ASSERT_EQ(without.size(), with.size());
  ASSERT_FALSE(with.empty());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].range, without[i].range);
    EXPECT_EQ(with[i].power, without[i].power);
    EXPECT_TRUE(std::isnan(without[i].range_rate));
    EXPECT_FALSE(std::isnan(with[i].range_rate));
  }
}

}  // namespace
}  // namespace radar_sim
