#include "elevation/height_guess.h"

#include <gtest/gtest.h>
#include <tws_core/random_test_helpers.h>

#include <random>

namespace adit_tracker {
namespace {

// If these fail, radars at different sites place a target at different places: one aircraft becomes two tracks.

tws::Plot seen(double x, double y, double height, const tws::SiteFrame& site) {
  tws::Plot plot;
  const tws::PlanarView view = site.view(x, y);
  plot.range = std::hypot(view.distance, height);
  plot.azimuth = view.azimuth;
  return plot;
}

TEST(HeightGuess, ATargetBelowAnyHeightIsAlikeLikelyAtAllOfThem) {
  const HeightGuess guess = HeightGuess::below(9000.0, 100e3);
  EXPECT_NEAR(guess.squared, 27e6, 1e3);                         // a third of 81e6
  EXPECT_NEAR(std::sqrt(guess.variance), 0.298142 * 81e6, 2e4);  // of a uniform height's square: sqrt(4/45)
}

TEST(HeightGuess, NobodyLooksSteeperThanThirtyDegrees) {
  const HeightGuess guess = HeightGuess::below(9000.0, 6000.0);
  EXPECT_NEAR(guess.squared, 3e6, 1.0);  // a third of 3000 m squared
  HeightGuess high = HeightGuess::below(9000.0, 100e3);
  high.flatten(6000.0);
  EXPECT_NEAR(high.squared, 9e6, 1.0);
}

TEST(HeightGuess, WithTheRightHeightBothSitesPlaceATargetWhereItIs) {
  const tws::SiteFrame island{38e3, 12e3, 0.008};
  HeightGuess guess;
  guess.squared = 49e6F;
  for (const tws::SiteFrame& site : {tws::SiteFrame{}, island}) {
    const tws::PlanarPosition place = guess.placeOf(seen(25e3, -40e3, 7e3, site), 100.0, 0.005, site).place;
    EXPECT_NEAR(place.x, 25e3, 1e-3);
    EXPECT_NEAR(place.y, -40e3, 1e-3);
  }
}

TEST(HeightGuess, SaysByHowMuchAPlaceMovesWithTheHeight) {
  const tws::SiteFrame island{38e3, 12e3, 0.008};
  const tws::Plot plot = seen(25e3, -40e3, 7e3, island);
  HeightGuess low, high;
  low.squared = 48e6F;
  high.squared = 50e6F;
  const GuessedPlace a = low.placeOf(plot, 100.0, 0.005, island), b = high.placeOf(plot, 100.0, 0.005, island);
  EXPECT_NEAR((b.place.x - a.place.x) / 2e6, a.x_per_squared, 1e-3 * std::abs(a.x_per_squared) + 1e-8);
  EXPECT_NEAR((b.place.y - a.place.y) / 2e6, a.y_per_squared, 1e-3 * std::abs(a.y_per_squared) + 1e-8);
}

TEST(HeightGuess, OneSiteAloneLearnsNothing) {
  const tws::SiteFrame ship;
  const tws::Plot plot = seen(25e3, -40e3, 7e3, ship);
  HeightGuess guess = HeightGuess::below(10e3, plot.range);
  const tws::PlanarPosition track = guess.begin(plot, 100.0, 0.005, ship);
  const float before = guess.variance;
  guess.learn(guess.placeOf(plot, 100.0, 0.005, ship), track, 10e3);
  EXPECT_NEAR(guess.variance / before, 1.0, 1e-3);
}

// Two sites that look at it from different sides, and errors of 30 m: the height comes out as well as it says.
TEST(HeightGuess, TwoSitesTellTheHeight) {
  auto generator = tws::seededGenerator();
  std::normal_distribution<double> normal;
  const tws::SiteFrame ship, island{38e3, 12e3, 0.008};
  double squares = 0.0;
  const int trials = 400;
  for (int i = 0; i < trials; ++i) {
    const double height = tws::uniform(generator, 4e3, 9.5e3), x = 20e3, y = -25e3;
    tws::Plot first = seen(x, y, height, ship), second = seen(x, y, height, island);
    first.range += 30.0 * normal(generator);
    second.range += 30.0 * normal(generator);
    HeightGuess guess = HeightGuess::below(10e3, first.range);
    const tws::PlanarPosition track = guess.begin(first, 30.0, 1e-4, ship);
    guess.learn(guess.placeOf(second, 30.0, 1e-4, island), track, 10e3);
    const double error = guess.squared - height * height;
    squares += error * error / guess.variance;
    EXPECT_TRUE(guess.known());
  }
  EXPECT_NEAR(squares / trials, 1.0, 0.5);  // the mean square of a normal deviate; the model is bent
}

}  // namespace
}  // namespace adit_tracker
