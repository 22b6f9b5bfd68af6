#include "ppi_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

PpiParams params() {
  PpiParams params;
  params.radars = {{"sps12", "", "", {0.0f, 1.0f, 0.0f, 1.0f}, ""}, {"sps39", "", "", {0.0f, 0.0f, 1.0f, 1.0f}, ""}};
  params.trackers = {{"adit", "", ""}, {"ssr", "", "S"}};
  return params;
}

bool says(const Drawing& drawing, const std::string& text) {
  return std::any_of(drawing.labels.begin(), drawing.labels.end(),
                     [&](const Label& label) { return label.text == text; });
}

// "About two scans" is twelve seconds for one radar and sixteen for the other.
TEST(PpiPicture, DetectionsFadeOverTwoScansOfTheirOwnRadar) {
  PpiPicture picture(params());
  picture.add(0, BeamMark{100.0, 0, 0, 6.0}, {});
  picture.add(1, BeamMark{100.0, 0, 0, 8.0}, {});
  picture.add(0, PlotMark{100.0, {1000.0, 0.0}, 0.0});
  picture.add(1, PlotMark{100.0, {2000.0, 0.0}, 0.0});
  EXPECT_EQ(picture.detections(111.0).triangles.size(), 12u);
  const Drawing later = picture.detections(113.0);
  ASSERT_EQ(later.triangles.size(), 6u);
  EXPECT_FLOAT_EQ(later.triangles[0].color.b, 1.0f);
  EXPECT_TRUE(picture.detections(117.0).triangles.empty());
}

// A radar on the coast, its north turned by 10 degrees: its beam starts at its mast and points by its own north.
TEST(PpiPicture, ASweepStartsAtItsRadarsSiteInItsOwnNorth) {
  PpiPicture picture(params());
  const PlanarFrame site{{30e3, -20e3}, tws::kPi / 18.0};
  picture.add(0, BeamMark{100.0, 16, 16, 6.0}, site);
  const Drawing drawing = picture.sweeps(100.0);
  const Vertex& mast = drawing.triangles.front();
  EXPECT_NEAR((mast.position - site.origin).norm(), 0.0, 1e-9);
  const Eigen::Vector2d rim = drawing.triangles[1].position;
  EXPECT_NEAR(rim.norm(), 200e3, 1e-3);
  const Eigen::Vector2d beam = rim - site.origin;
  EXPECT_NEAR(std::atan2(beam.x(), beam.y()), tws::kPi / 2.0 + tws::kPi / 18.0, 1e-9);
}

// A tracker of detections knows no codes: without those of the secondary radar's plots, labels bear numbers only.
TEST(PpiPicture, ATrackBearsTheCodeOfTheSecondaryRadarsPlotAndKeepsIt) {
  PpiPicture picture(params());
  picture.add(IdentityPlot{100.0, {50e3, 0.0}, "1234 F350"});
  TrackReport track;
  track.uid = 7;
  track.state = TrackState::kFirm;
  track.published = track.time = 100.0;
  track.position = {50e3, 100.0};
  track.velocity = {0.0, 0.0};
  track.name = "7";
  picture.add(track);
  EXPECT_TRUE(says(picture.tracks(100.0).others, "7\n0kn\n1234 F350"));
  track.published = track.time = 120.0;  // The plot is too old now.
  picture.add(track);
  EXPECT_TRUE(says(picture.tracks(120.0).others, "7\n0kn\n1234 F350"));
  track.identity = "F350";  // The tracker's own height, of an elevation search, is no code.
  picture.add(IdentityPlot{120.0, {50e3, 0.0}, "1234 F351"});
  picture.add(track);
  EXPECT_TRUE(says(picture.tracks(120.0).others, "7\n0kn\n1234 F351"));
  track.identity = "4321";
  picture.add(track);
  EXPECT_TRUE(says(picture.tracks(120.0).others, "7\n0kn\n4321"));
}

// If this fails, the operator sees every aircraft twice, or none when the correlator has stopped.
TEST(PpiPicture, ACorrelatorsPictureStandsInPlaceOfItsTrackersWhileItPublishes) {
  PpiParams both = params();
  both.trackers[0].topic = "/adit/tracks";
  both.correlators = {{"correlated", "/correlated/tracks", {"/adit/tracks"}}};
  PpiPicture picture(both);
  TrackReport track;
  track.state = TrackState::kFirm;
  track.published = track.time = 100.0;
  track.position = {50e3, 0.0};
  track.velocity = {0.0, 0.0};
  const auto say = [&](std::size_t source, const std::string& name, TrackState state) {
    track.source = source;
    track.name = name;
    track.state = state;
    picture.add(track);
  };
  say(0, "7", TrackState::kFirm);
  EXPECT_TRUE(says(picture.tracks(100.0).others, "7\n0kn"));
  picture.setLatest(0, 100.0);
  picture.setLatest(2, 100.0);
  say(2, "1", TrackState::kFirm);
  const Drawing drawing = picture.tracks(100.0).others;
  EXPECT_TRUE(says(drawing, "1\n0kn"));
  EXPECT_FALSE(says(drawing, "7\n0kn"));
  EXPECT_TRUE(says(picture.status(100.0), "correlated"));
  EXPECT_FALSE(says(picture.status(100.0), "adit"));
  track.published = 131.0;
  say(0, "7", TrackState::kFirm);
  EXPECT_TRUE(says(picture.tracks(131.0).others, "7\n0kn"));
}

// When the tracker stops, its clutter map must not stay as if it were still in use.
TEST(PpiPicture, ClutterAndTruthVanishAfterTheTimeOut) {
  PpiPicture picture(params());
  picture.setClutter(100.0, {{{1000.0, 0.0}, true}, {{2000.0, 0.0}, false}});
  picture.setTruth(100.0, {{3000.0, 0.0}});
  const Drawing clutter = picture.clutter(101.0);
  EXPECT_EQ(clutter.triangles.size(), 24u);
  EXPECT_LT(clutter.triangles.back().color.a, clutter.triangles.front().color.a);
  EXPECT_EQ(picture.truth(101.0).triangles.size(), 12u);
  EXPECT_TRUE(picture.clutter(131.0).triangles.empty());
  EXPECT_TRUE(picture.truth(131.0).triangles.empty());
}

TEST(PpiPicture, TheStatusNamesOnlyWhatHasPublished) {
  PpiPicture picture(params());
  picture.add(1, BeamMark{100.0, 0, 0, 8.0}, {});
  picture.setLatest(0, 100.0);
  const Drawing status = picture.status(101.0);
  EXPECT_TRUE(says(status, "sps39  8.0 s"));
  EXPECT_TRUE(says(status, "adit"));
  EXPECT_FALSE(says(status, "ssr"));
  for (const Label& label : status.labels) EXPECT_EQ(label.text.find("sps12"), std::string::npos);
  EXPECT_TRUE(says(picture.status(105.0), "sps39  silent"));
}

// If this fails, the clutter of a radar that stands elsewhere is drawn round the wrong site.
TEST(PpiPicture, KnowsWhereEachRadarWithAMarkStands) {
  PpiPicture picture(params());
  const PlanarFrame island{{30e3, -2e3}, 0.1};
  picture.add(1, BeamMark{100.0, 0, 0, 8.0}, island);
  ASSERT_TRUE(picture.siteOf("sps39").has_value());
  EXPECT_EQ(picture.siteOf("sps39")->origin, island.origin);
  EXPECT_EQ(picture.siteOf("sps39")->turn, 0.1);
  EXPECT_FALSE(picture.siteOf("sps12").has_value());
  EXPECT_FALSE(picture.siteOf("").has_value());
}

TEST(PpiPicture, TheStatusCountsThePointsOfTheClutterMapThatAbsorb) {
  PpiPicture picture(params());
  picture.setClutter(100.0, {{{1000.0, 0.0}, true}, {{2000.0, 0.0}, false}, {{3000.0, 0.0}, true}});
  EXPECT_TRUE(says(picture.status(101.0), "clutter 2"));
  EXPECT_FALSE(says(picture.status(131.0), "clutter 2"));
}

TEST(PpiPicture, TheLegendCanBeLeftOut) {
  PpiParams bare = params();
  bare.legend = false;
  EXPECT_TRUE(says(PpiPicture(params()).background(), "handed off"));
  EXPECT_FALSE(says(PpiPicture(bare).background(), "handed off"));
}

TEST(PpiPicture, RingsStandAsFarApartAsSaid) {
  PpiParams wide = params();
  wide.ring_spacing = 25e3;
  EXPECT_TRUE(says(PpiPicture(wide).background(), "175"));
  EXPECT_FALSE(says(PpiPicture(params()).background(), "175"));
}

}  // namespace
}  // namespace tws_rviz
