#include "ppi_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

tws_msgs::Track track() {
  tws_msgs::Track track;
  track.number = 17;
  track.uid = 4711;
  track.state = tws_msgs::Track::FIRM;
  track.position.x = 3000.0;
  track.position.y = 4000.0;
  track.position.z = NAN;
  track.velocity.x = 100.0;
  track.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  track.height = NAN;
  return track;
}

// A radar on another site: its north may point elsewhere in the map (meridians converge).
TEST(PpiInput, ATransformTurnsAndMovesWhatTheRadarSees) {
  geometry_msgs::Transform transform;
  transform.translation.x = 1000.0;
  transform.translation.y = 2000.0;
  // A quarter turn counter-clockwise about the vertical: the site's north points west.
  transform.rotation.z = transform.rotation.w = std::sqrt(0.5);
  const PlanarFrame site = planarFrame(transform);
  EXPECT_NEAR(site.turn, 1.5 * tws::kPi, 1e-12);
  const Eigen::Vector2d north = site.placed({0.0, 100.0});
  EXPECT_NEAR(north.x(), 900.0, 1e-9);
  EXPECT_NEAR(north.y(), 2000.0, 1e-9);
  const Eigen::Vector2d east = site.placed({100.0, 0.0});
  EXPECT_NEAR(east.x(), 1000.0, 1e-9);
  EXPECT_NEAR(east.y(), 2100.0, 1e-9);
}

TEST(PpiInput, ADetectionLiesAtItsSlantRangeAndAzimuth) {
  tws_msgs::Detection detection;
  detection.stamp = ros::Time(12.5);
  detection.range = 5000.0;
  detection.azimuth = std::atan2(3.0, 4.0);
  const PlotMark seen = plotMark(detection, {});
  EXPECT_NEAR(seen.position.x(), 3000.0, 1e-9);
  EXPECT_NEAR(seen.position.y(), 4000.0, 1e-9);
  EXPECT_DOUBLE_EQ(seen.time, 12.5);
}

// One NaN would make RViz drop the whole layer.
TEST(PpiInput, ADetectionThatMakesNoSenseIsRefused) {
  tws_msgs::Detection detection;
  detection.azimuth = NAN;
  EXPECT_THROW(plotMark(detection, {}), std::invalid_argument);
  detection.azimuth = 1.0;
  detection.range = -1.0;
  EXPECT_THROW(plotMark(detection, {}), std::invalid_argument);
}

TEST(PpiInput, AMarkOfAnUnknownSectorIsRefused) {
  tws_msgs::SectorMark mark;
  mark.sector = 63;
  EXPECT_EQ(beamMark(mark).sector, 63);
  mark.sector = 64;
  EXPECT_THROW(beamMark(mark), std::invalid_argument);
}

TEST(PpiInput, ATrackIsReportedUnderItsTrackersPrefix) {
  const TrackReport report = trackReport(track(), 1, "S", 100.0, {});
  EXPECT_EQ(report.name, "S17");
  EXPECT_EQ(report.uid, 4711u);
  EXPECT_EQ(report.source, 1u);
  EXPECT_EQ(report.state, TrackState::kFirm);
  EXPECT_EQ(report.position, Eigen::Vector2d(3000.0, 4000.0));
  EXPECT_EQ(report.velocity, Eigen::Vector2d(100.0, 0.0));
  EXPECT_EQ(report.identity, "");
}

TEST(PpiInput, TheBitsOfHandoffAndDesignationAreTakenOver) {
  tws_msgs::Track track;
  track.state = tws_msgs::Track::FIRM;
  const auto report = [&](std::uint16_t bits) {
    track.detection_bits = bits;
    return trackReport(track, 0, "", 5.0, PlanarFrame{});
  };
  EXPECT_TRUE(report(tws_msgs::Track::HANDED_OFF).handed_off);
  EXPECT_FALSE(report(tws_msgs::Track::HANDED_OFF).designated);
  EXPECT_TRUE(report(tws_msgs::Track::ELEVATION_REQUESTED | 3).designated);
  EXPECT_FALSE(report(3).handed_off);
  EXPECT_TRUE(report(tws_msgs::Track::DETECTED_BY_IFF).iff);
  EXPECT_FALSE(report(3).iff);
}

TEST(PpiInput, ACallsignStandsInPlaceOfTheNumber) {
  tws_msgs::Track named = track();
  named.callsign = "SAS123";
  EXPECT_EQ(trackReport(named, 0, "", 100.0, {}).name, "SAS123");
}

// Codes are octal: 2233 decimal is code 4271. 10 668 m are 35 000 ft, level 350.
TEST(PpiInput, CodeAndLevelAreWrittenAsOperatorsSayThem) {
  tws_msgs::Track known = track();
  known.mode_3a = 2233;
  EXPECT_EQ(identityText(known), "4271");
  known.height = 10668.0;
  EXPECT_EQ(identityText(known), "4271 F350");
  known.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  known.height = 300.0;
  EXPECT_EQ(identityText(known), "F010");
}

// If this fails, the operator reads of errors that nobody takes out, or in units that are not said.
TEST(PpiInput, WhatIsTakenOutOfARadarsPlotsIsSaidInWords) {
  tws_msgs::RadarRegistration radar;
  radar.state = tws_msgs::RadarRegistration::APPLIED;
  EXPECT_EQ(alignmentText(radar), "");
  radar.applied[0] = 40.2;
  radar.applied[2] = -0.005;
  EXPECT_EQ(alignmentText(radar), "+40 m -0.29 deg");
  radar.applied[5] = 0.3;
  radar.state = tws_msgs::RadarRegistration::DRIFTING;
  EXPECT_EQ(alignmentText(radar), "drifts +40 m -0.29 deg +0.30 s");
  radar.state = tws_msgs::RadarRegistration::TOO_LARGE;
  EXPECT_EQ(alignmentText(radar), "errors too large");
  radar.applied[2] = NAN;
  EXPECT_THROW(alignmentText(radar), std::invalid_argument);
}

TEST(PpiInput, ATrackThatMakesNoSenseIsRefused) {
  tws_msgs::Track bad = track();
  bad.state = 0;
  EXPECT_THROW(trackReport(bad, 0, "", 100.0, {}), std::invalid_argument);
  bad = track();
  bad.position.x = INFINITY;
  EXPECT_THROW(trackReport(bad, 0, "", 100.0, {}), std::invalid_argument);
}

TEST(PpiInput, ACorrelatedTrackIsKnownByItsOwnIdentityAndKind) {
  using tws_msgs::CorrelatedTrack;
  CorrelatedTrack correlated;
  correlated.identity = 12;
  correlated.track = track();
  correlated.track.number = 12;
  correlated.track.mode_3a = 2233;
  for (const auto& [kind, expected] : {std::pair(CorrelatedTrack::PRIMARY_ONLY, TrackKind::kPrimary),
                                       {CorrelatedTrack::SECONDARY_ONLY, TrackKind::kSecondary},
                                       {CorrelatedTrack::CORRELATED, TrackKind::kCorrelated}}) {
    correlated.kind = kind;
    const TrackReport report = trackReport(correlated, 3, 100.0, {});
    EXPECT_EQ(report.kind, expected);
    EXPECT_EQ(report.uid, 12u);
    EXPECT_EQ(report.name, "12");
    EXPECT_EQ(report.identity, "4271");
  }
  correlated.kind = 0;
  EXPECT_THROW(trackReport(correlated, 3, 100.0, {}), std::invalid_argument);
}

// A final update has no position any more; it must be taken all the same, or a ghost stays.
TEST(PpiInput, ADropNeedsNoPosition) {
  tws_msgs::Track dropped = track();
  dropped.state = tws_msgs::Track::DROPPED;
  dropped.position.x = NAN;
  EXPECT_EQ(trackReport(dropped, 0, "", 100.0, {}).state, TrackState::kDropped);
}

}  // namespace
}  // namespace tws_rviz
