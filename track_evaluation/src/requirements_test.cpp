#include "requirements.h"

#include <gtest/gtest.h>
#include <tws_runtime/parameters.h>

#include <cmath>

#include "epoch_test_helpers.h"
#include "requirements_reader.h"

namespace track_evaluation {
namespace {

// If one of these fails, a radar system passes, or fails, a standard that it does not.

RequirementProfile everyTenSeconds() {
  RequirementProfile profile;
  profile.name = "p";
  profile.update_interval = 10.0;
  profile.update_probability = 0.9;
  profile.long_gap = 25.0;
  profile.long_gap_share = 0.1;
  profile.false_share = 0.5;
  return profile;
}

/// One truth for 100 s, an epoch a second; its track was last updated at the newest of these times.
std::vector<RequirementRow> updatedAt(const std::vector<double>& updates) {
  RequirementCounter counter(everyTenSeconds());
  for (double time = 0.0; time <= 100.0; time += 1.0) {
    Epoch epoch;
    epoch.time = time;
    epoch.truths = {truthAt(1, 0, 0)};
    TrackState track = trackAt(5, 0, 0);
    for (const double update : updates)
      if (update <= time) track.last_update = update;
    if (!std::isnan(track.last_update)) epoch.tracks = {track};
    counter.add(epoch, {epoch.tracks.empty() ? -1 : 0}, {false});
  }
  std::vector<RequirementRow> rows;
  counter.report(rows);
  return rows;
}

double valueOf(const std::vector<RequirementRow>& rows, const std::string& name) {
  for (const RequirementRow& row : rows)
    if (row.name == name) return row.value;
  throw std::out_of_range(name);
}

TEST(Requirements, AnUpdateInEachIntervalIsAProbabilityOfOne) {
  const auto rows = updatedAt({5, 15, 25, 35, 45, 55, 65, 75, 85, 95});
  EXPECT_EQ(valueOf(rows, "probability of update"), 1.0);
  EXPECT_EQ(valueOf(rows, "long gaps"), 0.0);
}

TEST(Requirements, GapsMissTheIntervalsTheySpan) {
  // Ten intervals; 5 to 40 s misses three, and is one long gap; 40 to 95 in steps of 10 s or less misses none.
  const auto rows = updatedAt({5, 40, 50, 60, 70, 80, 90, 95});
  EXPECT_NEAR(valueOf(rows, "probability of update"), 0.7, 1e-12);
  EXPECT_NEAR(valueOf(rows, "long gaps"), 0.1, 1e-12);
}

TEST(Requirements, ATargetNeverUpdatedIsOneLongGap) {
  const auto rows = updatedAt({});
  EXPECT_NEAR(valueOf(rows, "probability of update"), 0.1, 1e-12);  // 100 s span ten intervals: nine are between.
  EXPECT_NEAR(valueOf(rows, "long gaps"), 0.1, 1e-12);
}

TEST(Requirements, WithoutAnyValueARowNeitherPassesNorFails) {
  RequirementProfile profile = everyTenSeconds();
  profile.mode_3a_probability = 0.98;
  RequirementCounter counter(profile);
  std::vector<RequirementRow> rows;
  counter.report(rows);
  ASSERT_EQ(rows.size(), 4U);
  for (const RequirementRow& row : rows) EXPECT_FALSE(row.known()) << row.name;
}

TEST(Requirements, OnlyTheRightCodeAndHeightCount) {
  RequirementProfile profile = everyTenSeconds();
  profile.mode_3a_probability = profile.mode_c_probability = 0.5;
  RequirementCounter counter(profile);
  for (int i = 0; i < 4; ++i) {
    Epoch epoch;
    epoch.time = i;
    epoch.truths = {truthAt(1, 0, 0)};
    epoch.truths[0].mode_3a = 01234;
    epoch.truths[0].height = 5000.0;
    epoch.tracks = {trackAt(5, 0, 0)};
    epoch.tracks[0].mode_3a = i == 0 ? kCodeUnknown : 01234;
    epoch.tracks[0].height = i < 2 ? 5300.0 : 5050.0;
    counter.add(epoch, {0}, {false});
  }
  std::vector<RequirementRow> rows;
  counter.report(rows);
  EXPECT_EQ(valueOf(rows, "Mode 3/A detection"), 0.75);
  EXPECT_EQ(valueOf(rows, "Mode C detection"), 0.5);
}

TEST(Requirements, TheShippedLimitsAreThoseOfTheirSource) {
  const std::string path = std::string(EVALUATION_CONFIG) + "/requirements.yaml";
  const auto profiles = readRequirements(tws_runtime::loadParameterFile(path), path);
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(profiles[0].update_interval, 8.0);
  EXPECT_EQ(profiles[0].long_gap, 16.4);
  EXPECT_EQ(profiles[0].horizontal_rms, 350.0);
  EXPECT_EQ(profiles[1].update_interval, 5.0);
  EXPECT_EQ(profiles[1].long_gap_share, 0.001);
  for (const RequirementProfile& profile : profiles) {
    EXPECT_EQ(profile.update_probability, 0.97);
    EXPECT_EQ(profile.mode_3a_probability, 0.98);
    EXPECT_EQ(profile.mode_c_probability, 0.96);
  }
}

TEST(Requirements, AnUnknownKeyIsNamed) {
  try {
    readRequirements(YAML::Load("profiles: [{name: a, long_gapp_s: 3}]"), "f.yaml");
    FAIL() << "no exception";
  } catch (const tws_runtime::ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("long_gapp_s"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace track_evaluation
