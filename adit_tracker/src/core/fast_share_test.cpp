#include "core/fast_share.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

// If this fails, a radar among jets shows them scans too late, or one that sees none of them chases clutter.
TEST(FastShare, FollowsTheTracksThatBecameFirm) {
  FastShare share(0.02);
  EXPECT_DOUBLE_EQ(share.value(), 0.02);
  for (int k = 0; k < 20; ++k) share.add(false);
  EXPECT_DOUBLE_EQ(share.value(), 0.01);  // Twenty tracks weigh as much as the assumption.
  for (int k = 0; k < 20; ++k) share.add(true);
  EXPECT_NEAR(share.value(), 20.4 / 60.0, 1e-12);
}

// If this fails, a formation of jets makes the tracker deaf to a helicopter.
TEST(FastShare, NeverRulesOutTheUsual) {
  FastShare share(0.02);
  for (int k = 0; k < 10000; ++k) share.add(true);
  EXPECT_DOUBLE_EQ(share.value(), 0.5);
}

// If this fails, what flew here a day ago outweighs what flies now.
TEST(FastShare, ForgetsWhatWasLongAgo) {
  FastShare share(0.02);
  for (int k = 0; k < 10000; ++k) share.add(true);
  for (int k = 0; k < 1000; ++k) share.add(false);
  EXPECT_LT(share.value(), 0.1);
  EXPECT_GT(share.value(), 0.0);
}

}  // namespace
}  // namespace adit_tracker
