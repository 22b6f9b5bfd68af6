#include "operator/operator_requests.h"

#include <gtest/gtest.h>

#include <set>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// Five aircraft that have flown for 100 s before two radars: due north at 40 km outwards, east at 60 km inwards, south
/// at 80 km inwards and fast, west at 100 km across, and just west of north at 120 km inwards; and one that has just
/// appeared.
class OperatorDesk : public testing::Test {
 protected:
  static constexpr double kNow = 100.0;

  void SetUp() override { fly(paramsFor("default", {6.0, 8.0})); }

  void fly(const AditParams& params) {
    const TestRadar first(6.0), second(8.0, 0.5);
    RadarSectors radars = {first.sectors(0.0, kNow), second.sectors(0.0, kNow)};
    TestTarget appearing = passing(50e3, 50e3, 200.0, 0.0);
    appearing.from = 92.0;
    for (const TestTarget& target :
         {passing(0.0, 40e3, 0.0, 150.0), passing(60e3, 0.0, -200.0, 0.0), passing(0.0, -80e3, 0.0, 300.0),
          passing(-100e3, 0.0, 0.0, 250.0), passing(-4e3, 120e3, 0.0, -100.0), appearing}) {
      first.see(target, radars[0]);
      second.see(target, radars[1]);
    }
    listener.emplace(params);
    feedInOrder(listener->adit, radars);
  }

  /// There and at that velocity when it is kNow.
  static TestTarget passing(double x, double y, double vx, double vy) { return {x - kNow * vx, y - kNow * vy, vx, vy}; }

  OperatorAnswer ask(OperatorAction action, double from = OperatorRequest::kUnused,
                     double to = OperatorRequest::kUnused, std::uint32_t start = 0) {
    OperatorRequest request;
    request.action = action;
    request.from = from;
    request.to = to;
    request.start = start;
    return execute(adit(), request);
  }

  OperatorAnswer order(OperatorAction action, std::uint32_t track, bool cancel = false) {
    OperatorRequest request;
    request.action = action;
    request.track = track;
    request.cancel = cancel;
    return execute(adit(), request);
  }

  OperatorAnswer startAt(double x, double y) {
    OperatorRequest request;
    request.action = OperatorAction::kInitiate;
    request.x = x;
    request.y = y;
    return execute(adit(), request);
  }

  /// The directions of the tracks, to the nearest degree.
  std::set<int> directions(const OperatorAnswer& answer) {
    std::set<int> all;
    for (const auto slot : answer.tracks)
      all.insert(
          static_cast<int>(std::lround(tws::degrees(adit().tracks().extrapolate(slot, kNow).kinematics.azimuth))) %
          360);
    return all;
  }

  /// The number of the track in that direction.
  std::uint32_t numberAt(int direction) {
    for (const auto slot : adit().tracks().living()) {
      OperatorAnswer one;
      one.tracks = {slot};
      if (directions(one).count(direction) > 0) return adit().tracks().at(slot).number;
    }
    ADD_FAILURE() << "no track at " << direction;
    return 0;
  }

  const Track& track(std::uint32_t number) { return adit().tracks().at(*adit().tracks().find(number)); }
  Adit& adit() { return listener->adit; }

  std::optional<Listener> listener;
};

using Set = std::set<int>;
using Action = OperatorAction;

// If this fails, an operator is shown other targets than he asked for. Directions and distances are those of the
// flights.
TEST_F(OperatorDesk, ListsTargetsByAzimuthClockwiseAlsoAcrossNorth) {
  const auto rad = [](double degrees) { return tws::radians(degrees); };
  EXPECT_EQ(directions(ask(Action::kListAzimuth, rad(80), rad(190))), (Set{90, 180}));
  EXPECT_EQ(directions(ask(Action::kListAzimuth, rad(190), rad(80))), (Set{270, 358, 0}));
  EXPECT_EQ(directions(ask(Action::kListAzimuth, rad(350), rad(10))), (Set{358, 0}));
  EXPECT_EQ(ask(Action::kListAzimuth, 0.0, tws::kTwoPi).count, 5U);
  EXPECT_EQ(ask(Action::kListAzimuth, rad(300), rad(310)).count, 0U);
  EXPECT_NE(ask(Action::kListAzimuth, 0.0).refusal, "");
}

TEST_F(OperatorDesk, ListsTargetsInsideOutsideAndBetweenRanges) {
  const double unused = OperatorRequest::kUnused;
  EXPECT_EQ(directions(ask(Action::kListRange, unused, 70e3)), (Set{0, 90}));
  EXPECT_EQ(directions(ask(Action::kListRange, 90e3, unused)), (Set{270, 358}));
  EXPECT_EQ(directions(ask(Action::kListRange, 50e3, 90e3)), (Set{90, 180}));
  EXPECT_NE(ask(Action::kListRange).refusal, "");
  EXPECT_NE(ask(Action::kListRange, 90e3, 50e3).refusal, "");
}

TEST_F(OperatorDesk, ListsTargetsThatCloseFast) {
  EXPECT_EQ(directions(ask(Action::kListClosing, 50.0)), (Set{90, 180, 358}));
  EXPECT_EQ(directions(ask(Action::kListClosing, 250.0)), (Set{180}));
  EXPECT_NE(ask(Action::kListClosing).refusal, "");
}

TEST_F(OperatorDesk, ListsAllTargetsAndApartFromThemTheTentativeTracks) {
  EXPECT_EQ(directions(ask(Action::kListAll)), (Set{0, 90, 180, 270, 358}));
  EXPECT_EQ(directions(ask(Action::kListTentative)), (Set{45}));
}

// If this fails, a track is forgotten or told twice when its list is longer than the display. Three pages of two.
TEST_F(OperatorDesk, LongListsComeInPagesUntilAllIsSaid) {
  AditParams params = paramsFor("default", {6.0, 8.0});
  params.operators.page = 2;
  fly(params);
  Set all;
  std::uint32_t start = 0, left = 5;
  for (int page = 0; page < 3; ++page, left -= 2) {
    const OperatorAnswer answer = ask(Action::kListAll, OperatorRequest::kUnused, OperatorRequest::kUnused, start);
    EXPECT_EQ(answer.count, left);
    EXPECT_EQ(answer.tracks.size(), std::min(left, 2U));
    const Set more = directions(answer);
    all.insert(more.begin(), more.end());
    EXPECT_EQ(answer.next == 0, page == 2);
    start = answer.next;
  }
  EXPECT_EQ(all, (Set{0, 90, 180, 270, 358}));
}

TEST_F(OperatorDesk, OneTracksParametersAreGivenByItsNumberAlsoIfItIsTentative) {
  for (const int direction : {180, 45})
    EXPECT_EQ(directions(order(Action::kParameters, numberAt(direction))), Set{direction});
  EXPECT_EQ(order(Action::kParameters, 99).refusal, "there is no track 99");
}

TEST_F(OperatorDesk, ATrackIsHandedOffAndTheHandoffCancelled) {
  const std::uint32_t number = numberAt(90);
  EXPECT_EQ(directions(order(Action::kHandOff, number)), Set{90});
  EXPECT_TRUE(track(number).handed_off);
  EXPECT_FALSE(track(numberAt(180)).handed_off);
  order(Action::kHandOff, number, true);
  EXPECT_FALSE(track(number).handed_off);
}

TEST_F(OperatorDesk, DesignatedTracksAreListedAsUnderElevationSearch) {
  EXPECT_EQ(ask(Action::kListElevation).count, 0U);
  order(Action::kDesignate, numberAt(90));
  order(Action::kDesignate, numberAt(0));
  EXPECT_EQ(directions(ask(Action::kListElevation)), (Set{0, 90}));
  order(Action::kDesignate, numberAt(0), true);
  EXPECT_EQ(directions(ask(Action::kListElevation)), (Set{90}));
}

TEST_F(OperatorDesk, AnUnknownRequestIsRefusedByItsNumber) {
  EXPECT_EQ(ask(static_cast<Action>(9)).refusal, "request 9 is unknown");
}

/// The tracker goes on for some turns, seeing what of the flights is given.
class OperatorDeskGoesOn : public OperatorDesk {
 protected:
  void goOn(double until, const std::vector<TestTarget>& targets) {
    const TestRadar first(6.0), second(8.0, 0.5);
    RadarSectors radars = {first.sectors(0.0, until), second.sectors(0.0, until)};
    for (const TestTarget& target : targets) {
      first.see(target, radars[0]);
      second.see(target, radars[1]);
    }
    for (std::size_t r = 0; r < 2; ++r) {
      auto& sectors = radars[r];
      sectors.erase(std::remove_if(sectors.begin(), sectors.end(), [](const auto& s) { return s.leave_time <= kNow; }),
                    sectors.end());
    }
    feedInOrder(adit(), radars);
  }

  std::vector<RecordedUpdate> wordsOn(std::uint32_t uid, std::size_t from) {
    std::vector<RecordedUpdate> updates;
    std::copy_if(listener->updates.begin() + static_cast<std::ptrdiff_t>(from), listener->updates.end(),
                 std::back_inserter(updates), [&](const RecordedUpdate& w) { return w.uid == uid; });
    return updates;
  }
};

// If this fails, a dropped track lives on, is never reported as dropped, or its number is lost.
TEST_F(OperatorDeskGoesOn, ADroppedTrackIsGoneAtOnceAndSaysItsLastWordWithTheNextSector) {
  const std::uint32_t number = numberAt(90), uid = track(number).uid;
  const std::size_t said = listener->updates.size();
  EXPECT_EQ(order(Action::kDrop, number).count, 1U);
  EXPECT_FALSE(adit().tracks().find(number).has_value());
  EXPECT_EQ(order(Action::kDrop, number).refusal, "there is no track " + std::to_string(number));
  goOn(kNow + 6.0, {});
  const auto updates = wordsOn(uid, said);
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates[0].event, TrackEvent::kDropped);
  EXPECT_EQ(updates[0].sector_time, listener->updates[said].sector_time);
}

TEST_F(OperatorDeskGoesOn, DropAllEndsEveryTrack) {
  const std::uint32_t before = adit().tracks().size();
  const std::size_t said = listener->updates.size();
  EXPECT_EQ(ask(Action::kDropAll).count, before);
  EXPECT_TRUE(adit().tracks().living().empty());
  goOn(kNow + 2.0, {});
  EXPECT_EQ(listener->updates.size() - said, before);
  EXPECT_EQ(adit().tracks().size(), 0U);
}

// If this fails, an operator cannot help where the tracker sees too little: here an aircraft that had not been detected
// before. Without him, the first detection would only start the track.
TEST_F(OperatorDeskGoesOn, ATrackStartedByHandTakesTheDetectionsThereAndBecomesFirm) {
  const OperatorAnswer answer = startAt(-30.3e3, -70.2e3);
  ASSERT_EQ(answer.refusal, "");
  const std::uint32_t uid = adit().tracks().at(answer.tracks.front()).uid;
  goOn(kNow + 30.0, {passing(-30e3, -70e3, 100.0, 100.0)});
  const auto updates = wordsOn(uid, 0);
  ASSERT_GT(updates.size(), 4U);
  EXPECT_EQ(updates[0].event, TrackEvent::kStarted);
  EXPECT_EQ(updates[1].event, TrackEvent::kUpdated);
  EXPECT_TRUE(updates.back().confirmed);
  EXPECT_NEAR(updates.back().kinematics.vx, 100.0, 30.0);
}

TEST_F(OperatorDeskGoesOn, ATrackStartedByHandWhereNothingIsEnds) {
  const std::uint32_t uid = adit().tracks().at(startAt(30e3, -70e3).tracks.front()).uid;
  goOn(kNow + 40.0, {});
  EXPECT_EQ(wordsOn(uid, 0).back().event, TrackEvent::kDropped);
  EXPECT_LT(wordsOn(uid, 0).back().sector_time, kNow + 25.0);
}

TEST_F(OperatorDesk, APointIsRefusedWhereATargetIsOrWhereNoRadarSees) {
  EXPECT_EQ(startAt(60.2e3, 100.0).refusal, "track " + std::to_string(numberAt(90)) + " is there already");
  EXPECT_NE(startAt(2e7, 0.0).refusal, "");
  EXPECT_NE(startAt(0.0, 0.0).refusal, "");
  EXPECT_NE(startAt(std::nan(""), 5.0).refusal, "");
}

TEST_F(OperatorDesk, ATrackByHandIsRefusedAndCountedWhenAllNumbersAreInUse) {
  AditParams params = paramsFor("default", {6.0, 8.0});
  params.capacity = 7;
  fly(params);
  EXPECT_EQ(startAt(30e3, -70e3).refusal, "all 6 track numbers are in use");
  EXPECT_EQ(adit().counts().refused_tracks, 1U);
}

}  // namespace
}  // namespace adit_tracker
