#include "core/range_bins.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace adit_tracker {
namespace {

TEST(RangeBins, WhatLiesBeyondTheLastHasABinOfItsOwn) {
  const RangeBins bins;
  EXPECT_DOUBLE_EQ(bins.reach(), 10e3);
  EXPECT_EQ(bins.binOf(0.0), 0);
  EXPECT_EQ(bins.binOf(-1.0), 0);
  EXPECT_EQ(bins.binOf(9.99e3), RangeBins::kBins - 1);
  EXPECT_EQ(bins.binOf(10e3), RangeBins::kBins);
  EXPECT_EQ(bins.binOf(1e12), RangeBins::kBins);
}

// If this fails, what was learned near a radar stands elsewhere as soon as it sees farther.
TEST(RangeBins, TwiceAsDeepTheyHoldWhatTwoHeld) {
  RangeBins bins;
  std::array<double, RangeBins::kBins> values;
  std::iota(values.begin(), values.end(), 0.0);
  const int before = bins.binOf(5e3);
  bins.doubleDepth();
  RangeBins::sumUp(values.data());
  EXPECT_DOUBLE_EQ(bins.reach(), 20e3);
  EXPECT_EQ(bins.binOf(5e3), before / 2);
  for (int bin = 0; bin < RangeBins::kBins; ++bin) {
    EXPECT_DOUBLE_EQ(values[static_cast<std::size_t>(bin)], bin < RangeBins::kBins / 2 ? 4.0 * bin + 1.0 : 0.0) << bin;
  }
}

}  // namespace
}  // namespace adit_tracker
