#include "elevation/elevation_handler.h"

#include <gtest/gtest.h>

#include <map>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// Radars of 6 and 8 s, of which the second one searches; its beam passes north at 0.5 + 8 n seconds.
class ElevationHandlerTest : public testing::Test {
 protected:
  static constexpr double kEnd = 120.0;

  /// Flies the targets past both radars in the order of `arrival`, and designates the tracks that are firm once that
  /// time has come.
  void fly(const std::vector<TestTarget>& targets, double designate_at, double skew = 0.0, std::uint64_t seed = 1) {
    RadarSectors radars = {first_.sectors(0.0, kEnd), second_.sectors(0.0, kEnd)};
    for (const TestTarget& target : targets) {
      first_.see(target, radars[0]);
      second_.see(target, radars[1]);
    }
    lists.clear();
    std::optional<Adit> adit;
    std::optional<ElevationHandler> handler;
    adit.emplace(params, [&](const SectorReport& report) {
      if (report.radar == 1 && report.enter_time >= designate_at) {
        for (const auto slot : adit->tracks().living()) {
          if (adit->tracks().at(slot).firm && designate) adit->manual().designate(slot, true);
        }
        designate_at = kEnd;
      }
      for (const TrackUpdate& update : report.updates) {
        if (update.event == TrackEvent::kDropped) dropped[adit->tracks().at(update.slot).number] = report.enter_time;
      }
      if (auto list = handler->afterSector(*adit, report)) lists.push_back(*list);
    });
    handler.emplace(*adit);
    std::mt19937_64 generator(seed);
    feed(*adit, radars, skew, generator);
  }

  std::string bytes() const {
    std::ostringstream out;
    out << std::hexfloat;
    for (const ElevationList& list : lists) {
      out << list.time << ':';
      for (const ElevationSearch& s : list.searches) out << ' ' << s.track << ' ' << s.azimuth << ' ' << s.range;
      out << '\n';
    }
    return out.str();
  }

  AditParams params = paramsFor("default", {6.0, 8.0});
  bool designate = true;
  TestRadar first_{6.0}, second_{8.0, 0.5};
  std::vector<ElevationList> lists;
  std::map<std::uint32_t, double> dropped;
};

/// Twelve aircraft in all directions.
std::vector<TestTarget> twelve() {
  std::vector<TestTarget> targets;
  for (int i = 0; i < 12; ++i) {
    const double azimuth = tws::radians(30.0 * i + 10.0), course = tws::radians(70.0 * i), range = 50e3 + 4e3 * i;
    targets.push_back(
        {range * std::sin(azimuth), range * std::cos(azimuth), 200.0 * std::sin(course), 200.0 * std::cos(course)});
  }
  return targets;
}

// The radar waits for its list on each scan, also when nobody is designated.
TEST_F(ElevationHandlerTest, AListComesOnEachScanWhenTheAntennaEntersSector61) {
  fly({}, kEnd);
  ASSERT_EQ(lists.size(), 14U);
  for (std::size_t scan = 0; scan < lists.size(); ++scan) {
    EXPECT_NEAR(lists[scan].time, 0.5 + 8.0 * (static_cast<double>(scan) + 61.0 / 64.0), 1e-9);
    EXPECT_TRUE(lists[scan].searches.empty());
  }
}

// The search begins 3° before the place where the beam will meet the aircraft, and looks at its range then.
TEST_F(ElevationHandlerTest, ASearchBeginsThreeDegreesBeforeTheAircraft) {
  const TestTarget target{60e3, 20e3, -200.0, 100.0};
  fly({target}, 70.0);
  int searches = 0;
  for (const ElevationList& list : lists) {
    if (list.searches.empty()) continue;
    ++searches;
    const double north = list.time + 8.0 * 3.0 / 64.0;
    double meeting = north;
    for (int i = 0; i < 10; ++i) meeting = north + 8.0 * target.azimuth(meeting) / tws::kTwoPi;
    const ElevationSearch& search = list.searches.front();
    EXPECT_NEAR(tws::angularDifference(search.azimuth, target.azimuth(meeting)), tws::radians(-3.0), 1e-3);
    EXPECT_NEAR(search.range, target.range(meeting), 30.0);
  }
  EXPECT_EQ(searches, 2);  // of the six lists after 70 s: at once, and four scans later
}

// 1° east of north: the radar begins at 358°, at the end of its turn, and meets the aircraft after the next north. An
// interval at the range of a turn before would miss a fast one.
TEST_F(ElevationHandlerTest, ASearchAcrossNorthAimsAtTheMeetingAfterIt) {
  const TestTarget target{0.0, 100e3, 4.0, -400.0};
  fly({target}, 70.0);
  const auto first = std::find_if(lists.begin(), lists.end(), [](const auto& list) { return !list.searches.empty(); });
  ASSERT_NE(first, lists.end());
  const double meeting = first->time + 8.0 * 3.0 / 64.0 + 8.0;
  EXPECT_NEAR(first->searches.front().azimuth, tws::radians(357.0) + target.azimuth(meeting), 2e-4);
  EXPECT_NEAR(first->searches.front().range, target.range(meeting), 60.0);
}

// A shift register that compares azimuths one after the other needs them in order.
TEST_F(ElevationHandlerTest, TwelveTracksGetTheirSearchesInOrderOfAzimuthAndNeverMoreThanEight) {
  fly(twelve(), 30.0);
  std::map<std::uint32_t, std::vector<double>> times;
  for (const ElevationList& list : lists) {
    EXPECT_LE(list.searches.size(), 8U);
    EXPECT_TRUE(std::is_sorted(list.searches.begin(), list.searches.end(),
                               [](const auto& a, const auto& b) { return a.azimuth < b.azimuth; }));
    for (const ElevationSearch& search : list.searches) times[search.track].push_back(list.time);
  }
  ASSERT_EQ(times.size(), 12U);
  for (const auto& [track, at] : times) {
    for (std::size_t i = 1; i < at.size(); ++i) EXPECT_NEAR(at[i] - at[i - 1], 32.0, 1e-6) << track;
  }
}

// Replays and offline runs get their messages in another order: the radar must be sent to the same places.
TEST_F(ElevationHandlerTest, TheListsAreTheSameHoweverTheRadarsInterleave) {
  fly(twelve(), 30.0);
  const std::string expected = bytes();
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    fly(twelve(), 30.0, 0.5, seed);
    EXPECT_EQ(bytes(), expected) << "seed " << seed;
  }
}

TEST_F(ElevationHandlerTest, DroppedTracksLeaveTheLists) {
  TestTarget target{60e3, 20e3, -200.0, 100.0};
  target.to = 60.0;
  fly({target}, 40.0);
  ASSERT_EQ(dropped.size(), 1U);
  std::size_t before = 0, after = 0;
  for (const ElevationList& list : lists) {
    (list.time > dropped.begin()->second + 8.0 ? after : before) += list.searches.size();
  }
  EXPECT_GT(before, 0U);
  EXPECT_EQ(after, 0U);
}

TEST_F(ElevationHandlerTest, NobodyIsSearchedForUnlessDesignatedOrAutomatic) {
  designate = false;
  fly(twelve(), 30.0);
  for (const ElevationList& list : lists) EXPECT_TRUE(list.searches.empty());
  params.elevation.automatic = true;
  fly(twelve(), 30.0);
  std::set<std::uint32_t> tracks;
  for (const ElevationList& list : lists) {
    for (const ElevationSearch& search : list.searches) tracks.insert(search.track);
  }
  EXPECT_EQ(tracks.size(), 12U);
}

TEST_F(ElevationHandlerTest, TheRadarIsTheReferenceRadarUnlessNamed) {
  params.elevation.radar = "r0";
  fly({}, kEnd);
  ASSERT_GT(lists.size(), 2U);
  EXPECT_NEAR(lists[1].time - lists[0].time, 6.0, 1e-9);
  params.elevation.radar = "r7";
  EXPECT_THROW(Adit(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace adit_tracker
