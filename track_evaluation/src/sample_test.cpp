#include "sample.h"

#include <gtest/gtest.h>

#include <cmath>

namespace track_evaluation {
namespace {

TEST(Sample, AFewValuesAreExact) {
  Sample sample;
  Moments moments;
  for (const double value : {3.0, 1.0, 2.0}) {
    sample.add(value);
    moments.add(value);
  }
  EXPECT_EQ(moments.mean(), 2.0);
  EXPECT_EQ(sample.rootMeanSquare(), std::sqrt(14.0 / 3.0));
  EXPECT_EQ(sample.percentile(50.0), 2.0);
  EXPECT_EQ(sample.percentile(75.0), 2.5);
  EXPECT_EQ(sample.percentile(100.0), 3.0);
}

// If this fails, the figures of a long run are wrong, or its memory grows without end.
TEST(Sample, AMillionValuesAreThinnedEvenlyButForRootMeanSquareAndLargest) {
  Sample sample;
  constexpr int kValues = 1000000;
  for (int i = 0; i < kValues; ++i) sample.add(i == 777777 ? 5.0 : static_cast<double>(i) / kValues);
  EXPECT_NEAR(sample.rootMeanSquare(), std::sqrt(1.0 / 3.0), 1e-4);
  for (const double percent : {5.0, 50.0, 95.0}) EXPECT_NEAR(sample.percentile(percent), percent / 100.0, 1e-3);
  EXPECT_EQ(sample.percentile(100.0), 5.0);
}

TEST(Sample, WithoutValuesNothingIsKnown) {
  EXPECT_TRUE(std::isnan(Moments().mean()));
  EXPECT_TRUE(std::isnan(Sample().rootMeanSquare()));
  for (const double percent : {50.0, 100.0}) EXPECT_TRUE(std::isnan(Sample().percentile(percent)));
}

}  // namespace
}  // namespace track_evaluation
