#include "core/fast_share.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

// If this fails, a radar among jets shows them scans too late, or one that sees none of them chases clutter.
TEST(FastShare, FollowsTheTracksThatBecameFirm) {
  FastShare share(0.02);
  EXPECT_DOUBLE_EQ(share.value(), 0.02);
  for (int k = 0; k < 20; ++k) share.add(true);
  EXPECT_NEAR(share.value(), 0.5, 1e-12);  // Twenty tracks weigh as much as the assumption: 20.4 of 40.
  for (int k = 0; k < 20; ++k) share.add(false);
  EXPECT_NEAR(share.value(), 20.4 / 60.0, 1e-12);
}

// If this fails, a formation of jets makes the tracker deaf to a helicopter.
TEST(FastShare, NeverRulesOutTheUsual) {
  FastShare share(0.02);
  for (int k = 0; k < 10000; ++k) share.add(true);
  EXPECT_DOUBLE_EQ(share.value(), 0.5);
}

// If this fails, a fast one that comes after a day of airliners gets its track scans too late.
TEST(FastShare, DoesNotFallBelowWhatIsAssumed) {
  FastShare share(0.02);
  for (int k = 0; k < 1000; ++k) share.add(false);
  EXPECT_DOUBLE_EQ(share.value(), 0.02);
}

// If this fails, what flew here a day ago outweighs what flies now.
TEST(FastShare, ForgetsWhatWasLongAgo) {
  FastShare share(0.02);
  for (int k = 0; k < 10000; ++k) share.add(true);
  for (int k = 0; k < 1000; ++k) share.add(false);
  EXPECT_LT(share.value(), 0.1);
}

}  // namespace
}  // namespace adit_tracker
