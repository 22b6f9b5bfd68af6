#include "clutter/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace radar_sim {
namespace {

constexpr int kFields = 4000;

/// Correlation of the level, over many fields, between the origin at time 0 and that place and time.
double correlation(const TextureParams& params, const Eigen::Vector2d& place, double time) {
  double here = 0.0, there = 0.0, product = 0.0, here2 = 0.0, there2 = 0.0;
  for (int i = 0; i < kFields; ++i) {
    const Texture field(params, static_cast<std::uint64_t>(i), "rain");
    const double a = std::log(field.at({0.0, 0.0}, 0.0)), b = std::log(field.at(place, time));
    here += a, there += b, product += a * b, here2 += a * a, there2 += b * b;
  }
  here /= kFields, there /= kFields;
  return (product / kFields - here * there) /
         std::sqrt((here2 / kFields - here * here) * (there2 / kFields - there * there));
}

// If these fail, clutter is stronger or weaker, or lives longer or shorter, than the scenario says.
TEST(Texture, HasTheMeanOneAndTheSpreadThatIsStated) {
  const TextureParams params{5.0, 2000.0, 300.0};
  double sum = 0.0, level = 0.0, level2 = 0.0;
  for (int i = 0; i < kFields; ++i) {
    const double value = Texture(params, static_cast<std::uint64_t>(i), "rain").at({123.0, 456.0}, 789.0);
    sum += value;
    level += 10.0 * std::log10(value);
    level2 += std::pow(10.0 * std::log10(value), 2);
  }
  level /= kFields;
  EXPECT_NEAR(sum / kFields, 1.0, 4.5 * 1.7 / std::sqrt(kFields));  // the standard deviation of the power is 1.7
  EXPECT_NEAR(std::sqrt(level2 / kFields - level * level), 5.0, 0.25);
}

TEST(Texture, CorrelationFallsOverPlaceAndTimeAsStated) {
  const TextureParams params{5.0, 2000.0, 300.0};
  const double bound = 4.5 / std::sqrt(kFields);
  EXPECT_NEAR(correlation(params, {2000.0, 0.0}, 0.0), std::exp(-0.5), bound);
  EXPECT_NEAR(correlation(params, {0.0, 4000.0}, 0.0), std::exp(-2.0), bound);
  EXPECT_NEAR(correlation(params, {0.0, 0.0}, 300.0), std::exp(-1.0), bound);
  EXPECT_NEAR(correlation(params, {2000.0, 0.0}, 600.0), std::exp(-2.5), bound);
}

TEST(Texture, StaysForEverWhereItIsToAndIsEvenWithoutSpread) {
  const Texture land({8.0, 500.0, std::numeric_limits<double>::infinity()}, 3, "land");
  EXPECT_DOUBLE_EQ(land.at({1e4, 2e4}, 0.0), land.at({1e4, 2e4}, 1e6));
  EXPECT_DOUBLE_EQ(Texture({0.0, 500.0, 10.0}, 3, "even").at({1e4, 2e4}, 5.0), 1.0);
}

}  // namespace
}  // namespace radar_sim
