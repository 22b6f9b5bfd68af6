#include "track_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace tws_rviz {
namespace {

const PpiStyle kStyle(200e3);
const TrackLook kLook{60.0, 120.0, 30.0};

TrackReport report(std::uint32_t uid, TrackState state, double published, double x = 1000.0) {
  TrackReport report;
  report.uid = uid;
  report.state = state;
  report.published = published;
  report.position = {x, 50e3};
  report.velocity = {200.0, 0.0};
  report.name = std::to_string(uid);
  report.identity = "4271 F350";
  return report;
}

/// Both layers.
Drawing drawn(TrackPicture& tracks, double time, const std::set<std::size_t>& covered = {}) {
  TrackLayers layers;
  tracks.draw(layers, time, kStyle, covered);
  Drawing drawing = layers.tentative;
  const Drawing& others = layers.others;
  drawing.triangles.insert(drawing.triangles.end(), others.triangles.begin(), others.triangles.end());
  drawing.labels.insert(drawing.labels.end(), others.labels.begin(), others.labels.end());
  return drawing;
}

double eastEnd(const Drawing& drawing) {
  double east = -1e9;
  for (const Vertex& vertex : drawing.triangles) east = std::max(east, vertex.position.x());
  return east;
}

// The leader is how an operator reads speed and course.
TEST(TrackPicture, TheSpeedLeaderEndsWhereTheTrackWillBeInAMinute) {
  TrackPicture tracks(kLook);
  tracks.add(report(7, TrackState::kFirm, 100.0, 1000.0));
  EXPECT_NEAR(eastEnd(drawn(tracks, 100.0)), 1000.0 + 60.0 * 200.0, 1e-6);
}

// A second tracker's tracks must not hide the first one's labels.
TEST(TrackPicture, ATrackerBesideTheMainOneHasSymbolsOnly) {
  TrackPicture tracks(kLook);
  for (double time : {60.0, 80.0, 100.0}) {
    TrackReport beside = report(7, TrackState::kFirm, time, 1000.0);
    beside.symbol_only = true;
    tracks.add(beside);
  }
  const Drawing drawing = drawn(tracks, 100.0);
  EXPECT_TRUE(drawing.labels.empty());
  EXPECT_FALSE(drawing.triangles.empty());
  EXPECT_LT(eastEnd(drawing), 1000.0 + 3.0 * kStyle.symbol);
}

TEST(TrackPicture, ATrackWithoutVelocityHasNeitherLeaderNorSpeed) {
  TrackPicture tracks(kLook);
  TrackReport silent = report(7, TrackState::kFirm, 100.0, 1000.0);
  silent.velocity = {NAN, NAN};
  silent.identity.clear();
  tracks.add(silent);
  const Drawing drawing = drawn(tracks, 100.0);
  EXPECT_LT(eastEnd(drawing), 1000.0 + 2.0 * kStyle.symbol);
  EXPECT_EQ(drawing.labels.at(0).text, "7");
  for (const Vertex& vertex : drawing.triangles) EXPECT_TRUE(vertex.position.allFinite());
}

// 200 m/s are 388.8 kn.
TEST(TrackPicture, TheLabelSaysNumberSpeedAndIdentity) {
  TrackPicture tracks(kLook);
  tracks.add(report(17, TrackState::kFirm, 100.0));
  EXPECT_EQ(drawn(tracks, 100.0).labels.at(0).text, "17\n389kn\n4271 F350");
}

TEST(TrackPicture, ATentativeTrackShowsItsNumberOnly) {
  TrackPicture tracks(kLook);
  tracks.add(report(17, TrackState::kTentative, 100.0));
  EXPECT_EQ(drawn(tracks, 100.0).labels.at(0).text, "17");
}

// If this fails, the numbers of false plots hide the aircraft.
TEST(TrackPicture, ASingleDetectionHasNoLabel) {
  TrackPicture tracks(kLook);
  TrackReport single = report(17, TrackState::kTentative, 100.0);
  single.velocity.setZero();
  tracks.add(single);
  EXPECT_TRUE(drawn(tracks, 100.0).labels.empty());
}

// The operator must see at once which tracks are confirmed and which are tentative.
TEST(TrackPicture, TheThreeStatesDifferInShapeAndColour) {
  std::set<std::size_t> sizes;
  std::set<float> blues;
  std::set<double> widths;
  for (const TrackState state : {TrackState::kTentative, TrackState::kFirm, TrackState::kCoasting}) {
    TrackPicture tracks(kLook);
    TrackReport still = report(1, state, 100.0, 0.0);
    still.velocity = {0.0, 0.0};
    tracks.add(still);
    const Drawing drawing = drawn(tracks, 100.0);
    blues.insert(drawing.triangles.at(0).color.b);
    widths.insert(eastEnd(drawing));
  }
  EXPECT_EQ(blues.size(), 3u);
  EXPECT_EQ(widths.size(), 3u);
}

// If this fails, the operator cannot tell which radar sees an aircraft.
TEST(TrackPicture, ThreeKindsOfFirmTracksLookDifferent) {
  std::set<std::size_t> vertices;
  for (const TrackKind kind : {TrackKind::kPrimary, TrackKind::kSecondary, TrackKind::kCorrelated}) {
    TrackPicture tracks(kLook);
    TrackReport of_kind = report(1, TrackState::kFirm, 100.0);
    of_kind.kind = kind;
    tracks.add(of_kind);
    vertices.insert(drawn(tracks, 100.0).triangles.size());
  }
  EXPECT_EQ(vertices.size(), 3u);
}

// In rain, a thousand of them hide the aircraft. If this fails, they cannot be switched off alone.
TEST(TrackPicture, TentativeTracksHaveALayerOfTheirOwn) {
  TrackPicture tracks(kLook);
  tracks.add(report(1, TrackState::kTentative, 100.0));
  TrackLayers layers;
  tracks.draw(layers, 100.0, kStyle);
  EXPECT_TRUE(layers.others.triangles.empty() && layers.others.labels.empty());
  EXPECT_EQ(layers.tentative.labels.size(), 1u);
  tracks.add(report(1, TrackState::kFirm, 106.0));
  layers = {};
  tracks.draw(layers, 106.0, kStyle);
  EXPECT_TRUE(layers.tentative.triangles.empty() && layers.tentative.labels.empty());
  EXPECT_EQ(layers.others.labels.size(), 1u);
}

// A tentative track of a tracker whose tracks are correlated is shown by nobody else.
TEST(TrackPicture, OfACoveredSourceOnlyWhatWasNeverFirmIsDrawn) {
  TrackPicture tracks(kLook);
  tracks.add(report(1, TrackState::kTentative, 100.0));
  tracks.add(report(2, TrackState::kFirm, 100.0, 60e3));
  tracks.add(report(2, TrackState::kTentative, 106.0, 60e3));
  const Drawing drawing = drawn(tracks, 106.0, {0});
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text, "1");
}

// A dropped track that stayed would be a ghost aircraft.
// If this fails, an operator does not see which tracks he has handed off or designated.
TEST(TrackPicture, HandedOffAndDesignatedTracksAreMarkedEachInItsOwnWay) {
  std::set<std::size_t> sizes;
  for (const bool handed_off : {false, true}) {
    for (const bool designated : {false, true}) {
      TrackPicture tracks(kLook);
      TrackReport marked = report(7, TrackState::kFirm, 100.0);
      marked.handed_off = handed_off;
      marked.designated = designated;
      tracks.add(marked);
      sizes.insert(drawn(tracks, 100.0).triangles.size());
    }
  }
  EXPECT_EQ(sizes.size(), 4U);
}

TEST(TrackPicture, ADroppedTrackVanishes) {
  TrackPicture tracks(kLook);
  tracks.add(report(7, TrackState::kFirm, 100.0));
  tracks.add(report(8, TrackState::kFirm, 100.0, 80e3));
  tracks.add(report(7, TrackState::kDropped, 106.0));
  const Drawing drawing = drawn(tracks, 106.0);
  ASSERT_EQ(drawing.labels.size(), 1u);
  EXPECT_EQ(drawing.labels[0].text.substr(0, 2), "8\n");
}

// When a tracker stops, its picture must not stay as if it were true.
TEST(TrackPicture, TracksOfASilentTrackerVanishAfterTheTimeOut) {
  TrackPicture tracks(kLook);
  tracks.add(report(7, TrackState::kFirm, 100.0));
  tracks.expire(130.0);
  EXPECT_FALSE(drawn(tracks, 130.0).triangles.empty());
  tracks.expire(130.1);
  const Drawing drawing = drawn(tracks, 130.1);
  EXPECT_TRUE(drawing.triangles.empty());
  EXPECT_TRUE(drawing.labels.empty());
}

// Two trackers number their tracks on their own.
TEST(TrackPicture, TracksOfTwoTrackersWithTheSameNumberAreTwo) {
  TrackPicture tracks(kLook);
  TrackReport other = report(7, TrackState::kCoasting, 100.0, 90e3);
  other.source = 1;
  tracks.add(report(7, TrackState::kFirm, 100.0));
  tracks.add(other);
  const Drawing drawing = drawn(tracks, 100.0);
  ASSERT_EQ(drawing.labels.size(), 2u);
  EXPECT_NE(drawing.labels[0].id, drawing.labels[1].id);
  EXPECT_EQ(tracks.counts(0), (std::array<int, 3>{0, 1, 0}));
  EXPECT_EQ(tracks.counts(1), (std::array<int, 3>{0, 0, 1}));
}

TEST(TrackPicture, ALabelKeepsItsNumberWhileTheTrackLives) {
  TrackPicture tracks(kLook);
  tracks.add(report(7, TrackState::kTentative, 100.0));
  const std::uint32_t id = drawn(tracks, 100.0).labels.at(0).id;
  tracks.add(report(7, TrackState::kFirm, 106.0));
  EXPECT_EQ(drawn(tracks, 106.0).labels.at(0).id, id);
}

// The trail shows a turn that the present velocity hides. Dots lie where the track was 10 s, 20 s ... ago.
TEST(TrackPicture, TheTrailShowsWhereTheTrackWas) {
  TrackPicture tracks(kLook);
  for (int i = 0; i <= 30; ++i) tracks.add(report(7, TrackState::kFirm, 10.0 * i, 2000.0 * i));
  double west = 1e9;
  const Drawing drawing = drawn(tracks, 300.0);
  for (const Vertex& vertex : drawing.triangles)
    if (vertex.color.a > 0.0f) west = std::min(west, vertex.position.x());
  // Trail time is 120 s; the dot that is exactly so old has faded to nothing, so the oldest one seen is of 190 s.
  EXPECT_NEAR(west, 2000.0 * 19 - 0.5 * kStyle.dot, 1e-6);
}

// If this fails, a shower is a blob of numbers and lines that hides the aircraft within it.
TEST(TrackPicture, TentativeTracksThatCrowdAreDots) {
  TrackPicture tracks(kLook);
  for (std::uint32_t uid = 0; uid < 5; ++uid) tracks.add(report(uid, TrackState::kTentative, 100.0, 100.0 * uid));
  EXPECT_EQ(drawn(tracks, 100.0).labels.size(), 5U);
  for (std::uint32_t uid = 5; uid < 20; ++uid) tracks.add(report(uid, TrackState::kTentative, 100.0, 100.0 * uid));
  tracks.add(report(20, TrackState::kFirm, 100.0, 500.0));
  const Drawing drawing = drawn(tracks, 100.0);
  ASSERT_EQ(drawing.labels.size(), 1U);
  EXPECT_EQ(drawing.labels[0].text.substr(0, 2), "20");
  EXPECT_NEAR(eastEnd(drawing), 500.0 + 60.0 * 200.0, 1e-6);  // The firm one's leader alone.
}

// Over a long run each track's memory is bounded: 12 dots, whatever the rate of updates.
TEST(TrackPicture, TheTrailHasAtMostADozenDots) {
  TrackPicture tracks(kLook);
  tracks.add(report(7, TrackState::kFirm, 0.0));
  const std::size_t bare = drawn(tracks, 0.0).triangles.size();
  for (int i = 1; i < 10000; ++i) tracks.add(report(7, TrackState::kFirm, 0.1 * i));
  EXPECT_LE(drawn(tracks, 999.9).triangles.size(), bare + std::size_t{13} * 6);
}

}  // namespace
}  // namespace tws_rviz
