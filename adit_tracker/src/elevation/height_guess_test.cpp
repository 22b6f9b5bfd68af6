#include "elevation/height_guess.h"

#include <gtest/gtest.h>
#include <tws_core/random_test_helpers.h>

#include <random>

namespace adit_tracker {
namespace {

// If these fail, radars at different sites place a target at different places: one aircraft becomes two tracks.

const tws::EarthPlane kPlane;
const tws::EarthSite kShip(kPlane, tws::SiteFrame{}), kIsland(kPlane, tws::SiteFrame{38e3, 12e3, 0.008});

TEST(HeightGuess, ATargetBelowAnyHeightIsAlikeLikelyAtAllOfThem) {
  const HeightGuess guess = HeightGuess::below(9000.0, 100e3);
  EXPECT_NEAR(guess.height, 9000.0 / std::sqrt(3.0), 1.0);  // root of the mean square
  EXPECT_NEAR(guess.variance, 9e3 * 9e3 / 12.0 + std::pow(guess.height - 4500.0, 2), 1e4);
}

TEST(HeightGuess, NobodyLooksSteeperThanThirtyDegrees) {
  const HeightGuess guess = HeightGuess::below(9000.0, 6000.0);
  EXPECT_NEAR(guess.height, 3000.0 / std::sqrt(3.0), 1.0);
  HeightGuess high = HeightGuess::below(9000.0, 100e3);
  high.flatten(6000.0, 200.0);
  EXPECT_NEAR(high.height, 3200.0, 1.0);
}

TEST(HeightGuess, OneSiteAloneLearnsNothing) {
  const tws::SiteView seen = kShip.view(25e3, -40e3, 7e3);
  HeightGuess guess = HeightGuess::below(10e3, seen.range);
  const auto place = kShip.placeOf(seen.range, seen.azimuth, 100.0, 0.005, guess.height);
  guess.begin(place);
  const float before = guess.variance;
  guess.learn(place, place.place, 10e3);
  EXPECT_NEAR(guess.variance / before, 1.0, 1e-3);
}

// Two sites that look at it from different sides once each, and errors of 30 m: the height comes out, and no worse than
// it says. It says too much, as ground range bends with the height that it started from.
TEST(HeightGuess, TwoSitesTellTheHeight) {
  auto generator = tws::seededGenerator();
  std::normal_distribution<double> normal;
  double squares = 0.0, errors = 0.0;
  const int trials = 400;
  for (int i = 0; i < trials; ++i) {
    const double height = tws::uniform(generator, 4e3, 9.5e3), x = 20e3, y = -25e3;
    tws::SiteView first = kShip.view(x, y, height), second = kIsland.view(x, y, height);
    first.range += 30.0 * normal(generator);
    second.range += 30.0 * normal(generator);
    HeightGuess guess = HeightGuess::below(10e3, first.range);
    const auto place = kShip.placeOf(first.range, first.azimuth, 30.0, 1e-4, guess.height);
    guess.begin(place);
    guess.learn(kIsland.placeOf(second.range, second.azimuth, 30.0, 1e-4, guess.height), place.place, 10e3);
    const double error = guess.height - height;
    squares += error * error / guess.variance;
    errors += error * error;
  }
  EXPECT_LT(squares / trials, 1.5);  // the mean square of a normal deviate is 1
  EXPECT_LT(std::sqrt(errors / trials), 400.0);
}

}  // namespace
}  // namespace adit_tracker
