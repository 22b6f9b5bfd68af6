#include "adit.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// What the tracker said of one track in one sector.
struct Word {
  double sector_time;
  std::size_t radar;
  std::int64_t running;
  std::uint32_t uid, number;
  TrackEvent event;
  bool believed;
  Kinematics kinematics;
};

/// The tracker with all that it says.
class Listener {
 public:
  explicit Listener(const AditParams& params) : adit(params, [this](const SectorReport& r) { hear(r); }) {}

  void hear(const SectorReport& report) {
    ++sectors;
    for (const TrackWord& w : report.words) {
      const Track& track = adit.tracks().at(w.slot);
      words.push_back({report.enter_time, report.radar, report.running, track.uid, track.number, w.event,
                       adit.believed(track), adit.at(w.slot, w.time).kinematics});
    }
  }

  std::vector<Word> of(TrackEvent event) const {
    std::vector<Word> result;
    std::copy_if(words.begin(), words.end(), std::back_inserter(result),
                 [&](const Word& w) { return w.event == event; });
    return result;
  }

  /// Identities of tracks that were believed at any time.
  std::set<std::uint32_t> believed() const {
    std::set<std::uint32_t> uids;
    for (const Word& w : words) {
      if (w.believed) uids.insert(w.uid);
    }
    return uids;
  }

  /// Every bit of all that was said.
  std::string bytes() const {
    std::ostringstream out;
    out << std::hexfloat;
    for (const Word& w : words) {
      const Kinematics& k = w.kinematics;
      out << w.sector_time << ' ' << w.radar << ' ' << w.running << ' ' << w.uid << ' ' << w.number << ' '
          << static_cast<int>(w.event) << ' ' << w.believed << ' ' << k.time << ' ' << k.range << ' ' << k.azimuth
          << ' ' << k.range_rate << ' ' << k.azimuth_rate << ' ' << k.x << ' ' << k.y << ' ' << k.vx << ' ' << k.vy
          << '\n';
    }
    return out.str();
  }

  std::vector<Word> words;
  int sectors = 0;
  Adit adit;
};

void feed(Adit& adit, const RadarSectors& radars, double skew, std::mt19937_64& generator) {
  for (const auto& [radar, index] : arrivalOf(radars, skew, generator)) adit.add(radar, radars[radar][index]);
}

void feedInOrder(Adit& adit, const RadarSectors& radars) {
  std::mt19937_64 generator(1);
  std::vector<std::tuple<double, std::size_t, std::size_t>> order;
  for (std::size_t r = 0; r < radars.size(); ++r) {
    for (std::size_t i = 0; i < radars[r].size(); ++i) order.emplace_back(radars[r][i].leave_time, r, i);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [time, r, i] : order) adit.add(r, radars[r][i]);
}

/// Both sets on radars of 6 and 8 s.
class BothSets : public testing::TestWithParam<std::string> {
 protected:
  AditParams params() const { return paramsFor(GetParam(), {6.0, 8.0}); }

  RadarSectors twoRadars(double to, const std::vector<TestTarget>& targets) const {
    RadarSectors radars = {first_.sectors(0.0, to), second_.sectors(0.0, to)};
    for (const TestTarget& target : targets) {
      first_.see(target, radars[0]);
      second_.see(target, radars[1]);
    }
    return radars;
  }

  TestRadar first_{6.0}, second_{8.0, 0.5};
};
INSTANTIATE_TEST_SUITE_P(Sets, BothSets, testing::Values("default", "nrl7952"),
                         [](const auto& info) { return info.param; });

std::size_t plotsIn(const RadarSectors& radars) {
  std::size_t count = 0;
  for (const auto& sectors : radars) {
    for (const auto& sector : sectors) count += sector.plots.size();
  }
  return count;
}

// If this fails, one aircraft is no track, or several.
TEST_P(BothSets, OneAircraftSeenByTwoRadarsIsOneFirmTrackUpdatedByEveryPlot) {
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  const RadarSectors radars = twoRadars(240.0, {aircraft});
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  ASSERT_EQ(listener.believed().size(), 1U);
  const std::uint32_t uid = *listener.believed().begin();
  const auto updates = listener.of(TrackEvent::kUpdated);
  const auto own = static_cast<std::size_t>(
      std::count_if(updates.begin(), updates.end(), [&](const Word& w) { return w.uid == uid; }));
  std::size_t absorbed = 0;
  for (const ClutterMap& map : listener.adit.clutter()) absorbed += map.absorbed();
  // Every plot starts a track, updates one, or goes into the clutter map; the letter's map takes some of an aircraft's.
  // A point that is found to move then starts one more.
  const std::size_t started = listener.of(TrackEvent::kStarted).size() - listener.adit.counts().to_track;
  EXPECT_EQ(started + updates.size() + absorbed, plotsIn(radars));
  EXPECT_GE(own + absorbed, plotsIn(radars) - 3);
  if (GetParam() == "default") {
    EXPECT_EQ(absorbed, 0U);
  }
  const Word& last = *std::find_if(updates.rbegin(), updates.rend(), [&](const Word& w) { return w.uid == uid; });
  EXPECT_NEAR(last.kinematics.x, aircraft.x + aircraft.vx * last.kinematics.time, 300.0);
  EXPECT_NEAR(last.kinematics.y, aircraft.y + aircraft.vy * last.kinematics.time, 300.0);
  EXPECT_NEAR(last.kinematics.vx, aircraft.vx, 20.0);
  EXPECT_NEAR(last.kinematics.vy, aircraft.vy, 20.0);
  EXPECT_EQ(listener.adit.counts().plots, plotsIn(radars));
}

// If this fails, an aircraft is lost or doubled whenever it crosses north, either way round.
TEST_P(BothSets, AnAircraftAcrossNorthStaysOneTrack) {
  for (const double vx : {200.0, -200.0}) {
    Listener listener(params());
    feedInOrder(listener.adit, twoRadars(240.0, {{-120.0 * vx, 60e3, vx, 0.0}}));
    listener.adit.finish();
    EXPECT_EQ(listener.believed().size(), 1U);
    const auto coasted = listener.of(TrackEvent::kCoasted);
    EXPECT_EQ(std::count_if(coasted.begin(), coasted.end(), [](const Word& w) { return w.believed; }), 0);
  }
}

// The letter loses it by the pass-course effect: it filters in polar coordinates.
TEST(TheDefault, AnAircraftOverTheSiteStaysOneTrack) {
  const TestRadar first(6.0), second(8.0, 0.5);
  for (const double abeam : {20.0, 200.0, 2000.0}) {
    const TestTarget aircraft{-15e3, abeam, 200.0, 0.0};
    RadarSectors radars = {first.sectors(0.0, 160.0), second.sectors(0.0, 160.0)};
    first.see(aircraft, radars[0]);
    second.see(aircraft, radars[1]);
    Listener listener(paramsFor("default", {6.0, 8.0}));
    feedInOrder(listener.adit, radars);
    listener.adit.finish();
    EXPECT_EQ(listener.believed().size(), 1U) << abeam;
    EXPECT_LE(listener.adit.counts().tracks_started, 2U) << abeam;
  }
}

// If this fails, a target that only one of the radars sees has no track, or one that flickers.
TEST_P(BothSets, AnAircraftThatOneRadarSeesIsTrackedWhileTheOtherSeesNothing) {
  RadarSectors radars = twoRadars(240.0, {});
  second_.see({60e3, 20e3, -150.0, 120.0}, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_EQ(listener.believed().size(), 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 1U);
}

// If this fails, one radar that is switched off takes the tracks with it.
TEST_P(BothSets, TheOtherRadarGoesOnWhenOneFallsSilentAndTakesItInAgain) {
  RadarSectors radars = {first_.sectors(0.0, 360.0), second_.sectors(0.0, 360.0)};
  auto& off = radars[0];
  off.erase(
      std::remove_if(off.begin(), off.end(), [](const auto& s) { return s.leave_time > 100 && s.enter_time < 220; }),
      off.end());
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  first_.see(aircraft, radars[0]);
  second_.see(aircraft, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_EQ(listener.believed().size(), 1U);
  EXPECT_EQ(listener.adit.counts().late_sectors, 0U);
  EXPECT_EQ(listener.sectors, static_cast<int>(radars[0].size() + radars[1].size()));
  int during = 0, after = 0;
  for (const Word& w : listener.of(TrackEvent::kUpdated)) {
    if (w.sector_time > 105.0 && w.sector_time < 215.0) during += w.radar == 1 ? 1 : 100;
    if (w.sector_time > 230.0 && w.radar == 0) ++after;
  }
  EXPECT_GE(during, 12);
  EXPECT_LE(during, 14);
  EXPECT_GE(after, 20);
}

// If this fails, two aircraft that cross are taken for one another, or one track is lost.
TEST_P(BothSets, TwoAircraftThatCrossKeepTheirTracks) {
  // They meet at (40 km, 40 km) at 150 s, with 90° between their courses.
  const std::vector<TestTarget> aircraft = {{10e3, 40e3, 200.0, 0.0}, {40e3, 10e3, 0.0, 200.0}};
  Listener listener(params());
  feedInOrder(listener.adit, twoRadars(300.0, aircraft));
  listener.adit.finish();
  std::map<std::uint32_t, std::set<int>> followed;
  for (const Word& w : listener.of(TrackEvent::kUpdated)) {
    const double t = w.kinematics.time;
    if (!w.believed || std::abs(t - 150.0) < 30.0) continue;
    const bool first = std::abs(w.kinematics.y - 40e3) < 2e3;
    followed[w.uid].insert(first ? 0 : 1);
  }
  EXPECT_EQ(followed.size(), 2U);
  for (const auto& [uid, targets] : followed) EXPECT_EQ(targets.size(), 1U) << "track " << uid << " followed both";
}

// If this fails, reports of the same recording differ between a live run and a replay.
TEST_P(BothSets, SaysTheSameBitForBitInWhateverOrderTheRadarsArrive) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(150.0, {});
  // The first radar misses some scans and comes again, as radars do.
  radars[0].erase(std::remove_if(radars[0].begin(), radars[0].end(),
                                 [](const auto& s) { return s.leave_time > 60.0 && s.enter_time < 75.0; }),
                  radars[0].end());
  for (int i = 0; i < 40; ++i) {
    const double r = tws::uniform(generator, 20e3, 90e3), a = tws::uniform(generator, 0.0, 6.28);
    const double speed = i < 25 ? tws::uniform(generator, 50.0, 300.0) : 0.0, c = tws::uniform(generator, 0.0, 6.28);
    const TestTarget target{r * std::sin(a), r * std::cos(a), speed * std::sin(c), speed * std::cos(c)};
    first_.see(target, radars[0]);
    second_.see(target, radars[1]);
  }
  for (auto& sectors : radars) {
    disturb(sectors, 80.0, 0.004, 0.85, 0.3, generator);
    // A clock of 8 ms ticks: the turns look uneven.
    for (auto& sector : sectors) {
      sector.enter_time = tws::quantise(sector.enter_time, 0.008);
      sector.leave_time = tws::quantise(sector.leave_time, 0.008);
    }
  }
  std::string expected;
  for (int run = 0; run < 8; ++run) {
    Listener listener(params());
    feed(listener.adit, radars, run == 0 ? 0.0 : 0.7, generator);
    listener.adit.finish();
    EXPECT_EQ(listener.adit.counts().late_sectors, 0U);
    const std::string bytes = listener.bytes();
    ASSERT_GT(listener.words.size(), 1000U);
    if (run == 0) expected = bytes;
    const auto differs = std::mismatch(expected.begin(), expected.end(), bytes.begin(), bytes.end());
    ASSERT_TRUE(bytes == expected) << "run " << run << " differs first in line "
                                   << std::count(expected.begin(), differs.first, '\n') + 1 << " of "
                                   << std::count(expected.begin(), expected.end(), '\n');
  }
}

// If this fails, a track's one missed illumination counts twice: it is dropped too early, and drawn twice.
TEST_P(BothSets, SaysOfATrackAtMostOneThingForEachScanOfARadar) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(200.0, {});
  for (int i = 0; i < 40; ++i) {
    const double r = tws::uniform(generator, 10e3, 60e3), a = tws::uniform(generator, 0.0, 6.28);
    // Clockwise or anticlockwise about the site, at 200 m/s.
    const double speed = i % 2 == 0 ? 200.0 : -200.0;
    const TestTarget target{r * std::sin(a), r * std::cos(a), speed * std::cos(a), -speed * std::sin(a)};
    first_.see(target, radars[0]);
    second_.see(target, radars[1]);
  }
  for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 0.7, 0.0, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::map<std::pair<std::uint32_t, std::size_t>, std::int64_t> last;
  int close = 0;
  for (const Word& w : listener.words) {
    if (w.event != TrackEvent::kUpdated && w.event != TrackEvent::kCoasted) continue;
    const auto [previous, is_new] = last.try_emplace({w.uid, w.radar}, w.running);
    if (!is_new && w.running - previous->second < 32) ++close;
    previous->second = w.running;
  }
  EXPECT_EQ(close, 0) << "of " << listener.words.size();
}

// If this fails, a full tracker throws away tracks that it has, or the user is not told that new ones are refused.
TEST_P(BothSets, AtFullCapacityNewTracksAreRefusedAndCountedAndTheOldOnesGoOn) {
  AditParams p = params();
  p.capacity = 4;  // Three tracks.
  p.clutter.capacity = 10;
  std::vector<TestTarget> aircraft;
  for (int i = 0; i < 3; ++i) aircraft.push_back({30e3 + 10e3 * i, 20e3, 150.0, 150.0});
  for (int i = 0; i < 5; ++i) aircraft.push_back({-30e3 - 10e3 * i, -20e3, -150.0, 150.0, 100.0});
  Listener listener(p);
  feedInOrder(listener.adit, twoRadars(250.0, aircraft));
  listener.adit.finish();
  EXPECT_EQ(listener.adit.tracks().size(), 3U);
  EXPECT_GT(listener.adit.counts().refused_tracks, 100U);
  EXPECT_GT(listener.adit.counts().refused_clutter, 0U);
  EXPECT_EQ(listener.believed().size(), 3U);
  for (const auto slot : listener.adit.living()) {
    EXPECT_GT(listener.adit.at(slot, 250.0).kinematics.x, 0.0);
    EXPECT_GT(listener.adit.tracks().at(slot).last_update, 240.0);
  }
}

TEST_P(BothSets, NumbersOfDroppedTracksServeAgain) {
  AditParams p = params();
  p.capacity = 3;
  std::vector<TestTarget> aircraft;
  for (int i = 0; i < 4; ++i) aircraft.push_back({30e3, 20e3, 150.0, 150.0, 200.0 * i, 200.0 * i + 60.0});
  Listener listener(p);
  feedInOrder(listener.adit, twoRadars(800.0, aircraft));
  listener.adit.finish();
  EXPECT_EQ(listener.believed().size(), 4U);
  for (const Word& w : listener.words) EXPECT_LT(w.number, 3U);
}

// If this fails, a consumer sees a track after its last word, or a word of a track that never started.
TEST_P(BothSets, EachTrackHasOneFirstAndOneLastWord) {
  auto generator = tws::seededGenerator();
  RadarSectors radars = twoRadars(200.0, {{60e3, 20e3, -150.0, 120.0, 0.0, 100.0}, {-60e3, 20e3, 150.0, 120.0}});
  for (auto& sectors : radars) disturb(sectors, 80.0, 0.004, 0.8, 0.3, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::map<std::uint32_t, TrackEvent> last;
  for (const Word& w : listener.words) {
    const bool is_first = last.count(w.uid) == 0;
    EXPECT_EQ(w.event == TrackEvent::kStarted, is_first) << w.uid;
    if (!is_first) {
      EXPECT_NE(last[w.uid], TrackEvent::kDropped) << w.uid;
    }
    last[w.uid] = w.event;
  }
  EXPECT_GT(last.size(), 100U);
  EXPECT_EQ(listener.adit.counts().tracks_started, last.size());
  EXPECT_EQ(listener.adit.counts().tracks_started - listener.adit.counts().tracks_dropped,
            listener.adit.tracks().size());
}

// If this fails, one bad plot spoils good ones or stops the tracker.
TEST_P(BothSets, PlotsThatAreNoNumbersAreLeftOutAndCounted) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const RadarSectors good = twoRadars(150.0, {{60e3, 20e3, -150.0, 120.0}});
  RadarSectors spoilt = good;
  std::uint64_t bad = 0;
  for (auto& sectors : spoilt) {
    for (std::size_t i = 0; i < sectors.size(); i += 5) {
      tws::Plot plot;
      plot.time = i % 4 == 0 ? kNaN : sectors[i].enter_time;
      plot.range = i % 4 == 1 ? kInfinity : (i % 4 == 2 ? -5.0 : 1000.0);
      plot.azimuth = i % 4 == 3 ? kNaN : 1.0;
      sectors[i].plots.insert(sectors[i].plots.begin(), plot);
      ++bad;
    }
  }
  Listener expected(params()), listener(params());
  feedInOrder(expected.adit, good);
  feedInOrder(listener.adit, spoilt);
  EXPECT_EQ(listener.adit.counts().rejected_plots, bad);
  EXPECT_TRUE(listener.bytes() == expected.bytes());
}

// If this fails, one plot in wrong units takes every detection of a sector, or makes false tracks firm ever after.
TEST_P(BothSets, APlotBeyondAllReasonDoesNoHarmToTheOthers) {
  const RadarSectors good = twoRadars(150.0, {{60e3, 20e3, -150.0, 120.0}});
  for (const double range : {1e9, 1e160, 1e300}) {
    RadarSectors spoilt = good;
    tws::Plot plot;
    plot.time = spoilt[0][80].enter_time;
    plot.range = range;
    plot.azimuth = spoilt[0][80].sector * tws::kSectorWidth;
    spoilt[0][80].plots.push_back(plot);
    Listener expected(params()), listener(params());
    feedInOrder(expected.adit, good);
    ASSERT_NO_THROW(feedInOrder(listener.adit, spoilt)) << range;
    EXPECT_EQ(listener.adit.counts().rejected_plots, 1U) << range;
    EXPECT_TRUE(listener.bytes() == expected.bytes()) << range;
  }
}

TEST_P(BothSets, ASectorThatComesAfterAYoungerOneOfItsRadarIsRefusedAndNamed) {
  Adit adit(params(), {});
  const auto sectors = first_.sectors(0.0, 2.0);
  adit.add(0, sectors[5]);
  for (const std::size_t i : {5U, 4U}) {
    try {
      adit.add(0, sectors[i]);
      FAIL() << "taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("radar r0: sector " + std::to_string(i)), std::string::npos)
          << error.what();
    }
  }
  EXPECT_NO_THROW(adit.add(0, sectors[6]));
}

TEST_P(BothSets, DataThatComeTooLateAreUsedAndCounted) {
  const TestTarget aircraft{60e3, 20e3, -150.0, 120.0};
  const RadarSectors radars = twoRadars(100.0, {aircraft});
  Listener listener(params());
  for (const auto& sector : radars[0]) listener.adit.add(0, sector);
  for (const auto& sector : radars[1]) listener.adit.add(1, sector);  // 100 s late
  listener.adit.finish();
  EXPECT_GT(listener.adit.counts().late_sectors, 500U);
  EXPECT_EQ(listener.sectors, static_cast<int>(radars[0].size() + radars[1].size()));
}

// If this fails, clutter fills the picture.
TEST_P(BothSets, ThingsThatStandStillBecomeClutterAndNoFirmTracks) {
  auto generator = tws::seededGenerator();
  std::vector<TestTarget> rocks;
  for (int i = 0; i < 20; ++i) rocks.push_back({-20e3 + 2.3e3 * i, 15e3 + 1.7e3 * i, 0.0, 0.0});
  RadarSectors radars = twoRadars(300.0, rocks);
  for (auto& sectors : radars) disturb(sectors, 60.0, 0.003, 0.8, 0.0, generator);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::set<std::uint32_t> late;
  for (const Word& w : listener.words) {
    if (w.believed && w.sector_time > 150.0) late.insert(w.uid);
  }
  EXPECT_LE(late.size(), 1U);  // Of 20.
}

// The letter has nothing against clutter that is detected only now and then; see README.md.
TEST_P(BothSets, ATrackThatStopsBecomesAClutterPoint) {
  RadarSectors radars = twoRadars(500.0, {{40e3, 30e3, 100.0, 0.0, 0.0, 150.0}});
  const TestTarget stopped{40e3 + 100.0 * 150.0, 30e3, 0.0, 0.0, 150.0};
  first_.see(stopped, radars[0]);
  second_.see(stopped, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  EXPECT_GE(listener.adit.counts().to_clutter, 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 0U);
  std::uint32_t points = 0;
  for (const ClutterMap& map : listener.adit.clutter()) points += map.size();
  EXPECT_GE(points, 1U);
}

// If this fails, a helicopter that takes off from where it was clutter is never seen.
TEST_P(BothSets, AClutterPointThatBeginsToMoveBecomesATrack) {
  RadarSectors radars = twoRadars(600.0, {{20e3, 30e3, 0.0, 0.0, 0.0, 120.0}});
  // 60 kn outwards: 185 m a scan, so that the clutter map goes on following it.
  const double speed = 60.0 * 1852.0 / 3600.0;
  const TestTarget moving{20e3 - 120.0 * speed * 0.5547, 30e3 - 120.0 * speed * 0.83205, speed * 0.5547,
                          speed * 0.83205, 120.0};
  first_.see(moving, radars[0]);
  second_.see(moving, radars[1]);
  Listener listener(params());
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  bool followed = false;
  for (const auto slot : listener.adit.living()) {
    const Kinematics k = listener.adit.at(slot, 590.0).kinematics;
    followed = followed || (listener.adit.believed(listener.adit.tracks().at(slot)) &&
                            std::abs(k.range - moving.range(590.0)) < 700.0);
  }
  EXPECT_TRUE(followed);
}

TEST_P(BothSets, WithoutAListenerItWorksTheSame) {
  const RadarSectors radars = twoRadars(100.0, {{60e3, 20e3, -150.0, 120.0}});
  Adit deaf(params(), {});
  Listener listener(params());
  feedInOrder(deaf, radars);
  feedInOrder(listener.adit, radars);
  EXPECT_EQ(deaf.counts().sectors, listener.adit.counts().sectors);
  EXPECT_EQ(deaf.tracks().size(), listener.adit.tracks().size());
}

// TFIX: firm by the first update later than 20 s after the first detection. Radar of 6 s: at 24 s.
TEST(TheLetter, ATrackIsFirmByItsFirstUpdateAfter20Seconds) {
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 60.0)};
  radar.see({20e3, 20e3, 200.0, 200.0}, radars[0]);
  Listener listener(paramsFor("nrl7952", {6.0}));
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  const auto started = listener.of(TrackEvent::kStarted), updated = listener.of(TrackEvent::kUpdated);
  ASSERT_FALSE(started.empty());
  const auto first_firm = std::find_if(updated.begin(), updated.end(), [](const Word& w) { return w.believed; });
  ASSERT_NE(first_firm, updated.end());
  EXPECT_NEAR(first_firm->kinematics.time - started.front().kinematics.time, 24.0, 0.1);
}

// Initiation runs one sector behind and starts both a track and a clutter point from every unused detection.
TEST(TheLetter, AnUnusedDetectionStartsATrackAndAClutterPoint) {
  const TestRadar radar(6.4);
  RadarSectors radars = {radar.sectors(0.0, 6.0)};
  tws::Plot plot;
  plot.time = 1.05;
  plot.range = 50e3;
  plot.azimuth = 10.5 * tws::kSectorWidth;
  radars[0][10].plots.push_back(plot);
  Listener listener(paramsFor("nrl7952", {6.4}));
  feedInOrder(listener.adit, radars);
  ASSERT_EQ(listener.words.size(), 1U);
  EXPECT_EQ(listener.words[0].running, 11);
  EXPECT_EQ(listener.words[0].event, TrackEvent::kStarted);
  EXPECT_FALSE(listener.words[0].believed);
  ASSERT_EQ(listener.adit.clutter().size(), 1U);
  EXPECT_EQ(listener.adit.clutter()[0].size(), 1U);
  EXPECT_EQ(listener.adit.tracks().size(), 1U);
}

// What this method costs in latency by design: five sectors (the clutter map needs sector +4).
TEST(TheLetter, ProcessesASectorWhenTheFourAheadOfItHaveClosed) {
  const TestRadar radar(6.4);
  const auto sectors = radar.sectors(0.0, 6.4);
  Listener listener(paramsFor("nrl7952", {6.4}));
  for (std::size_t i = 0; i < 10; ++i) {
    listener.adit.add(0, sectors[i]);
    EXPECT_EQ(listener.sectors, std::max(0, static_cast<int>(i) - 3));
  }
}

TEST(Adit, RefusesParametersThatMakeNoSense) {
  EXPECT_THROW(Adit(AditParams::named("default"), {}), std::invalid_argument);  // No radar.
  AditParams params = paramsFor("default", {6.0});
  params.reference_radar = "other";
  EXPECT_THROW(Adit(params, {}), std::invalid_argument);
}

}  // namespace
}  // namespace adit_tracker
