#include "ppi_params.h"

#include <gtest/gtest.h>

#include <tws_core/units.h>

namespace tws_rviz {
namespace {

PpiParams load(const std::string& yaml) { return loadPpiParams(tws_runtime::ParameterReader(YAML::Load(yaml), "ppi")); }

std::string refusal(const std::string& yaml) {
  try {
    load(yaml);
  } catch (const tws_runtime::ParameterError& error) {
    return error.what();
  }
  return "accepted";
}

// The shipped file is the reference of the parameters: what it says must be what happens without it.
TEST(PpiParams, TheShippedFileHoldsTheDefaults) {
  const PpiParams file =
      loadPpiParams(tws_runtime::ParameterReader(tws_runtime::loadParameterFile(PPI_YAML), PPI_YAML));
  const PpiParams none = load("");
  EXPECT_EQ(file.frame, none.frame);
  EXPECT_EQ(file.picture_range, none.picture_range);
  EXPECT_EQ(file.ring_spacing, none.ring_spacing);
  EXPECT_EQ(file.text_scale, none.text_scale);
  EXPECT_EQ(file.redraw_rate, none.redraw_rate);
  EXPECT_EQ(file.track_rate, none.track_rate);
  EXPECT_EQ(file.afterglow, none.afterglow);
  EXPECT_EQ(file.persistence_scans, none.persistence_scans);
  EXPECT_EQ(file.tracks.leader_time, none.tracks.leader_time);
  EXPECT_EQ(file.tracks.trail_time, none.tracks.trail_time);
  EXPECT_EQ(file.tracks.timeout, none.tracks.timeout);
  EXPECT_EQ(file.clutter_topic, none.clutter_topic);
  EXPECT_EQ(file.legend, none.legend);
  EXPECT_EQ(file.truth, none.truth);
  EXPECT_EQ(file.truth_topic, none.truth_topic);
  ASSERT_EQ(file.radars.size(), none.radars.size());
  for (std::size_t i = 0; i < none.radars.size(); ++i) {
    EXPECT_EQ(file.radars[i].name, none.radars[i].name);
    EXPECT_EQ(file.radars[i].detections, none.radars[i].detections);
    EXPECT_EQ(file.radars[i].sector_marks, none.radars[i].sector_marks);
    EXPECT_EQ(file.radars[i].plots, none.radars[i].plots);
  }
  ASSERT_EQ(file.trackers.size(), 2u);
  ASSERT_EQ(none.trackers.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(file.trackers[i].topic, none.trackers[i].topic);
    EXPECT_EQ(file.trackers[i].name, none.trackers[i].name);
    EXPECT_EQ(file.trackers[i].prefix, none.trackers[i].prefix);
  }
  ASSERT_EQ(file.correlators.size(), 1u);
  EXPECT_EQ(file.correlators[0].topic, none.correlators.at(0).topic);
  EXPECT_EQ(file.correlators[0].name, none.correlators[0].name);
  EXPECT_EQ(file.correlators[0].covers, none.correlators[0].covers);
}

TEST(PpiParams, RadarsAndTrackersAreLists) {
  const PpiParams params = load(
      "{radars: [{name: msr, color: [1, 0.5, 0]}, {name: ssr, detections: /ssr/skin, plots: /ssr/replies}],"
      " trackers: [{topic: /adit/tracks}, {topic: /ssr/tracks, prefix: S, symbols_only: true}]}");
  ASSERT_EQ(params.radars.size(), 2u);
  EXPECT_EQ(params.radars[0].sector_marks, "msr/sector_marks");
  EXPECT_EQ(params.radars[0].plots, "msr/plots");
  EXPECT_FLOAT_EQ(params.radars[0].color.g, 0.5f);
  EXPECT_EQ(params.radars[1].detections, "/ssr/skin");
  EXPECT_EQ(params.radars[1].plots, "/ssr/replies");
  ASSERT_EQ(params.trackers.size(), 2u);
  EXPECT_EQ(params.trackers[0].name, "/adit/tracks");
  EXPECT_EQ(params.trackers[1].prefix, "S");
  EXPECT_FALSE(params.trackers[0].symbols_only);
  EXPECT_TRUE(params.trackers[1].symbols_only);
}

// Two radars in one colour cannot be told apart.
TEST(PpiParams, RadarsHaveDistinctColoursByDefault) {
  const PpiParams params = load("");
  for (std::size_t i = 1; i < params.radars.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NE(params.radars[i].color.r + 10 * params.radars[i].color.b,
                params.radars[j].color.r + 10 * params.radars[j].color.b);
}

TEST(PpiParams, AnEmptyListOfRadarsMeansNone) { EXPECT_TRUE(load("radars: []").radars.empty()); }

TEST(PpiParams, AnglesAreGivenInDegreesAndKeptInRadians) {
  EXPECT_DOUBLE_EQ(load("afterglow_deg: 90").afterglow, tws::radians(90.0));
}

// A mistyped parameter that is ignored costs an hour.
TEST(PpiParams, WhatIsWrongIsRefusedByName) {
  EXPECT_NE(refusal("pictur_range: 1000").find("pictur_range"), std::string::npos);
  EXPECT_NE(refusal("picture_range: 0").find("picture_range"), std::string::npos);
  EXPECT_NE(refusal("redraw_rate: .nan").find("redraw_rate"), std::string::npos);
  EXPECT_NE(refusal("ring_spacing: 10").find("ring_spacing"), std::string::npos);
  EXPECT_NE(refusal("radars: [{colour: [1, 1, 1]}]").find("name"), std::string::npos);
  EXPECT_NE(refusal("radars: [{name: a, color: [1, 1]}]").find("radars[0].color"), std::string::npos);
  EXPECT_NE(refusal("trackers: [{name: adit}]").find("topic"), std::string::npos);
}

}  // namespace
}  // namespace tws_rviz
