#include "iff/iff_watch.h"

#include <gtest/gtest.h>

#include <map>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

// If these fail, an operator takes who answers for who does not, or the other way round.

/// Radars of 6 and 8 s and a secondary one of 5 s, and what the tracks' bit says after each sector.
class Iff : public testing::Test {
 protected:
  using Sectors = std::vector<tws::RadarSector>;

  AditParams params(const std::string& set = "default") const {
    AditParams p = paramsFor(set, {6.0, 8.0});
    p.iff.emplace_back().name = "ssr";
    return p;
  }

  RadarSectors radars(double to) const {
    RadarSectors all = {first_.sectors(0.0, to), second_.sectors(0.0, to)};
    for (const TestTarget& target : {answers_, silent_}) {
      first_.see(target, all[0]);
      second_.see(target, all[1]);
    }
    return all;
  }

  Sectors replies(double to, const std::vector<TestTarget>& targets) const {
    Sectors sectors = ssr_.sectors(0.0, to);
    for (const TestTarget& target : targets) ssr_.see(target, sectors);
    return sectors;
  }

  /// Plays all; a reply comes `delay` after its sector closed. Returns the bits, with time, of each target's track.
  std::map<std::string, std::vector<std::pair<double, bool>>> play(const AditParams& params, const Sectors& replies,
                                                                   double to, double delay) {
    std::map<std::string, std::vector<std::pair<double, bool>>> bits;
    Adit* adit = nullptr;
    Adit tracker(params, [&](const SectorReport& report) {
      for (const TrackUpdate& update : report.updates) {
        const Track& track = adit->tracks().at(update.slot);
        const Kinematics k = adit->tracks().extrapolate(update.slot, update.time).kinematics;
        const auto off = [&](const TestTarget& t) {
          return std::hypot(k.x - t.x - t.vx * update.time, k.y - t.y - t.vy * update.time);
        };
        bits[off(answers_) < off(silent_) ? "answers" : "silent"].emplace_back(update.time, track.answers_iff != 0);
      }
    });
    adit = &tracker;
    late_ = 0;
    std::vector<std::tuple<double, std::size_t, tws::RadarSector>> order;
    const RadarSectors all = radars(to);
    for (std::size_t r = 0; r < 2; ++r)
      for (const auto& sector : all[r]) order.emplace_back(sector.leave_time, r, sector);
    for (const auto& sector : replies) order.emplace_back(sector.leave_time + delay, 2, sector);
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    });
    for (const auto& [time, radar, sector] : order) {
      if (radar < 2)
        addAndProcess(tracker, radar, sector);
      else if (!tracker.addIff(0, sector, {}))
        ++late_;
    }
    return bits;
  }

  static bool alwaysFrom(const std::vector<std::pair<double, bool>>& bits, double from, double to, bool value) {
    bool any = false;
    for (const auto& [time, bit] : bits) {
      if (time < from || time > to) continue;
      any = true;
      if (bit != value) return false;
    }
    return any;
  }

  // Two aircraft that fly side by side, 3 km apart.
  const TestTarget answers_{30e3, 40e3, -200.0, 50.0}, silent_{32e3, 42e3, -200.0, 50.0};
  TestRadar first_{6.0}, second_{8.0, 0.5}, ssr_{5.0, 0.2};
  int late_ = 0;
};

TEST_F(Iff, TheBitIsSetForWhoAnswersAndForNobodyElse) {
  auto bits = play(params(), replies(100.0, {answers_}), 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 20.0, 100.0, true));
  EXPECT_TRUE(alwaysFrom(bits["silent"], 0.0, 100.0, false));
}

// Its tracks of this aircraft come and go: the common clutter map follows it.
TEST_F(Iff, TheReportsFilterHasTheBitToo) {
  auto bits = play(params("nrl7952"), replies(100.0, {answers_}), 100.0, 0.0);
  EXPECT_FALSE(alwaysFrom(bits["answers"], 0.0, 100.0, false));
  EXPECT_TRUE(alwaysFrom(bits["silent"], 0.0, 100.0, false));
}

TEST_F(Iff, OnePlotIsForOneTrack) {
  auto bits = play(params(), replies(100.0, {answers_, silent_}), 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 20.0, 100.0, true));
  EXPECT_TRUE(alwaysFrom(bits["silent"], 20.0, 100.0, true));
}

// The beam passes every five seconds; it is looked at half a second later.
TEST_F(Iff, TheBitIsClearedWhenTheBeamHasPassedWithoutAnAnswer) {
  TestTarget stops = answers_;
  stops.to = 50.0;
  auto bits = play(params(), replies(100.0, {stops}), 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 20.0, 50.0, true));
  EXPECT_TRUE(alwaysFrom(bits["answers"], 56.0, 100.0, false));
}

TEST_F(Iff, TheBitIsClearedWhenTheSecondaryRadarDies) {
  auto bits = play(params(), replies(50.0, {answers_}), 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 20.0, 50.0, true));
  EXPECT_TRUE(alwaysFrom(bits["answers"], 59.0, 100.0, false));  // a turn and a half
}

TEST_F(Iff, WhenTheRepliesComeDoesNotMatterWithinASecond) {
  const auto in_time = play(params(), replies(100.0, {answers_}), 100.0, 0.0);
  for (const double delay : {-3.0, 0.3, 0.8}) {
    EXPECT_EQ(play(params(), replies(100.0, {answers_}), 100.0, delay), in_time) << delay;
    EXPECT_EQ(late_, 0) << delay;
  }
}

TEST_F(Iff, RepliesThatComeTooLateAreLeftOutAndSaid) {
  auto bits = play(params(), replies(100.0, {answers_}), 100.0, 2.0);
  EXPECT_GT(late_, 1000);  // of 1280 sectors
  EXPECT_TRUE(alwaysFrom(bits["answers"], 0.0, 90.0, false));
}

// A filter's covariance is made to go forward: far back it says nothing, not even that a plot is near.
TEST_F(Iff, APlotThatIsMuchOlderThanTheTracksAnswersForNobody) {
  Sectors old = replies(100.0, {answers_});
  for (auto& sector : old) {
    for (auto& plot : sector.plots) {
      plot.time -= 6.0;
      plot.range = answers_.range(plot.time);
      plot.azimuth = answers_.azimuth(plot.time);
    }
  }
  auto bits = play(params(), old, 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 0.0, 100.0, false));
  EXPECT_TRUE(alwaysFrom(bits["silent"], 0.0, 100.0, false));
}

TEST_F(Iff, ABiasThatIsKnownIsTakenOff) {
  auto off = replies(100.0, {answers_});
  for (auto& sector : off)
    for (auto& plot : sector.plots) plot.range += 2500.0;
  auto unknown = play(params(), off, 100.0, 0.0);
  EXPECT_FALSE(alwaysFrom(unknown["answers"], 20.0, 100.0, true));
  AditParams known = params();
  known.iff[0].range_bias = 2500.0;
  auto bits = play(known, off, 100.0, 0.0);
  EXPECT_TRUE(alwaysFrom(bits["answers"], 20.0, 100.0, true));
}

}  // namespace
}  // namespace adit_tracker
