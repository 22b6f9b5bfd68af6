#include "heartbeats.h"

#include <gtest/gtest.h>

namespace tws_launch {
namespace {

// If these fail, a run whose tracker stands looks like one that goes well, to its end.

TEST(Heartbeats, WhoStopsSpeakingIsNamedWithTheTimeSince) {
  Heartbeats beats;
  beats.expect("adit", 0.0);
  beats.expect("sps12", 0.0);
  for (double t = 0.0; t <= 100.0; t += 1.0) {
    beats.heard("sps12", t);
    if (t <= 50.0) beats.heard("adit", t);
    EXPECT_EQ(beats.silent(t).empty(), t < 60.0) << t;
  }
  EXPECT_EQ(beats.silent(100.0), "adit for 50 s");
  EXPECT_EQ(beats.silent(130.0), "adit for 80 s, sps12 for 30 s");
  beats.heard("adit", 131.0);
  beats.heard("sps12", 131.0);
  EXPECT_EQ(beats.silent(132.0), "");
}

TEST(Heartbeats, WhoNeverSpokeIsNamedToo) {
  Heartbeats beats;
  beats.expect("adit", 5.0);
  EXPECT_EQ(beats.silent(14.0), "");
  EXPECT_EQ(beats.silent(15.0), "adit for 10 s");
}

TEST(Heartbeats, WhoSpeaksSeldomMayBeSilentForLonger) {
  Heartbeats beats;
  for (double t = 0.0; t <= 200.0; t += 20.0) beats.heard("slow", t);
  EXPECT_EQ(beats.silent(290.0), "");
  EXPECT_EQ(beats.silent(300.0), "slow for 100 s");
}

}  // namespace
}  // namespace tws_launch
