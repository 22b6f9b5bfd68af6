#include "correlation.h"

#include <gtest/gtest.h>

#include <map>

namespace track_evaluation {
namespace {

// If one of these fails, pilots' codes on the wrong aircraft go uncounted.

using Kind = CorrelationMetrics::Kind;

/// Truth 1 has code 4101 and the identity 7, truth 2 has no transponder and the identity 8, truth 3 code 4103 and none.
Epoch epochAt(double time) {
  Epoch epoch;
  epoch.time = time;
  epoch.truths.resize(3);
  epoch.truths[0].mode_3a = 04101;
  epoch.truths[2].mode_3a = 04103;
  epoch.tracks.resize(2);
  epoch.tracks[0].id = 7;
  epoch.tracks[1].id = 8;
  return epoch;
}

const std::vector<int> kPairs{0, 1, -1};

std::map<std::string, double> valuesOf(const CorrelationMetrics& correlation) {
  const MetricList list = correlation.report();
  return {list.begin(), list.end()};
}

TEST(CorrelationMetrics, CountsTheUpdatesWithTheCodeOfAnotherAircraft) {
  CorrelationMetrics correlation;
  correlation.judge(epochAt(0.0), kPairs);
  correlation.add({7, Kind::kCorrelated, 04101});
  correlation.add({7, Kind::kCorrelated, 04103});
  correlation.add({7, Kind::kCorrelated, 04101});
  correlation.judge(epochAt(10.0), kPairs);
  correlation.add({7, Kind::kCorrelated, 04103});
  correlation.judge(epochAt(1800.0), kPairs);
  const auto values = valuesOf(correlation);
  EXPECT_EQ(values.at("judged_words"), 4.0);
  EXPECT_EQ(values.at("miscorrelations"), 2.0);
  EXPECT_EQ(values.at("miscorrelations_per_hour"), 4.0);
  EXPECT_EQ(values.at("miscorrelated_share"), 0.5);
}

// The track has gone over to the other aircraft and bears its code: that is a swap of tracks, not of codes.
TEST(CorrelationMetrics, TakesTheCodeOfAnAircraftThatIsNearerByFarForRight) {
  for (const auto& [apart, wrong] : {std::pair(40.0, 1.0), {800.0, 0.0}}) {
    Epoch epoch = epochAt(0.0);
    epoch.truths[0].ground.position.x() = apart;  // The other two truths and the tracks lie at 0.
    CorrelationMetrics correlation;
    correlation.add({7, Kind::kCorrelated, 04103});
    correlation.judge(epoch, kPairs);
    EXPECT_EQ(valuesOf(correlation).at("judged_words"), 1.0);
    EXPECT_EQ(valuesOf(correlation).at("miscorrelations"), wrong) << apart;
  }
}

TEST(CorrelationMetrics, JudgesNoUpdateWithoutCodeOrOfAnAircraftWithoutOneOrOfNoAircraft) {
  CorrelationMetrics correlation;
  correlation.add({7, Kind::kCorrelated, kCodeUnknown});
  correlation.add({8, Kind::kCorrelated, 04103});
  correlation.add({9, Kind::kCorrelated, 04103});
  correlation.add({7, Kind::kSecondaryOnly, 04103});
  correlation.judge(epochAt(0.0), kPairs);
  EXPECT_EQ(valuesOf(correlation).at("judged_words"), 0.0);
}

TEST(CorrelationMetrics, CountsUpdatesOfEachKindAlsoWithoutTruth) {
  CorrelationMetrics correlation;
  EXPECT_TRUE(correlation.empty());
  correlation.add({1, Kind::kCorrelated, 04101});
  correlation.add({2, Kind::kPrimaryOnly, kCodeUnknown});
  correlation.add({3, Kind::kSecondaryOnly, 04102});
  correlation.add({4, Kind::kCorrelated, kCodeUnknown});
  const auto values = valuesOf(correlation);
  EXPECT_EQ(values.at("words_correlated"), 2.0);
  EXPECT_EQ(values.at("words_primary_only"), 1.0);
  EXPECT_EQ(values.at("words_secondary_only"), 1.0);
  EXPECT_EQ(values.at("correlated_share"), 0.5);
  EXPECT_EQ(values.count("miscorrelations"), 0u);
}

}  // namespace
}  // namespace track_evaluation
