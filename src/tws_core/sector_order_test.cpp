#include <tws_core/sector_order.h>

#include <gtest/gtest.h>

#include <algorithm>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

struct Sector {
  std::size_t radar;
  std::int64_t running;
  double enter, leave;
};

bool operator==(const Sector& a, const Sector& b) { return a.radar == b.radar && a.running == b.running; }
std::ostream& operator<<(std::ostream& out, const Sector& s) { return out << s.radar << ':' << s.running; }

/// Sectors `from` to `to` - 1 of a radar that turns evenly.
std::vector<Sector> sectorsOf(std::size_t radar, double sector_duration, std::int64_t from, std::int64_t to,
                              double start = 0.0) {
  std::vector<Sector> sectors;
  for (std::int64_t i = from; i < to; ++i) {
    sectors.push_back({radar, i, start + sector_duration * static_cast<double>(i),
                       start + sector_duration * static_cast<double>(i + 1)});
  }
  return sectors;
}

void give(SectorOrder& queue, const Sector& s, std::vector<Sector>& order, int* late = nullptr) {
  const bool in_time = queue.add({s.radar, s.running}, s.enter, s.leave);
  if (late != nullptr && !in_time) ++*late;
  while (const auto sector = queue.next()) order.push_back({sector->radar, sector->running, 0.0, 0.0});
}

void finish(SectorOrder& queue, std::vector<Sector>& order) {
  queue.finish();
  while (const auto sector = queue.next()) order.push_back({sector->radar, sector->running, 0.0, 0.0});
}

/// The order in which the sectors arrive: any that keeps each radar's own, and in which none comes after one that
/// closed by more than `skew` later.
std::vector<Sector> randomArrival(std::vector<std::vector<Sector>> radars, double skew, std::mt19937_64& generator) {
  std::vector<Sector> arrival;
  std::vector<std::size_t> next(radars.size(), 0);
  for (;;) {
    double oldest = 1e300;
    for (std::size_t r = 0; r < radars.size(); ++r) {
      if (next[r] < radars[r].size()) oldest = std::min(oldest, radars[r][next[r]].leave);
    }
    std::vector<std::size_t> may;
    for (std::size_t r = 0; r < radars.size(); ++r) {
      if (next[r] < radars[r].size() && radars[r][next[r]].leave <= oldest + skew) may.push_back(r);
    }
    if (may.empty()) return arrival;
    const std::size_t r = may[static_cast<std::size_t>(uniformInt(generator, 0, static_cast<int>(may.size()) - 1))];
    arrival.push_back(radars[r][next[r]++]);
  }
}

/// What figure 3 asks for: oldest first; of two of the same instant the first radar's.
std::vector<Sector> byAge(const std::vector<std::vector<Sector>>& radars) {
  std::vector<Sector> all;
  for (const auto& sectors : radars) all.insert(all.end(), sectors.begin(), sectors.end());
  std::stable_sort(all.begin(), all.end(), [](const Sector& a, const Sector& b) {
    return a.enter != b.enter ? a.enter < b.enter : a.radar < b.radar;
  });
  return all;
}

// If this fails, the same recording gives other tracks live than replayed: the picture depends on the network's mood.
TEST(SectorOrder, HandsOutTheOldestFirstInWhateverOrderSectorsArrive) {
  auto generator = seededGenerator();
  for (int run = 0; run < 200; ++run) {
    std::vector<std::vector<Sector>> radars;
    const int count = uniformInt(generator, 1, 4);
    for (int r = 0; r < count; ++r) {
      // Coarse numbers, so that sectors of two radars often close at the same instant.
      const double duration = 0.0625 * uniformInt(generator, 1, 3), start = 0.0625 * uniformInt(generator, 0, 4);
      const std::int64_t from = uniformInt(generator, 0, 70);
      radars.push_back(sectorsOf(static_cast<std::size_t>(r), duration, from, from + uniformInt(generator, 5, 200),
                                 start - static_cast<double>(from) * duration));
      // Some are silent for a while.
      if (uniformInt(generator, 0, 2) == 0 && radars.back().size() > 60) {
        const auto from_here = radars.back().begin() + uniformInt(generator, 2, 9);
        radars.back().erase(from_here, from_here + uniformInt(generator, 1, 50));
      }
    }
    SectorOrder queue(radars.size(), 1.0, 4);
    std::vector<Sector> order;
    int late = 0;
    for (const Sector& s : randomArrival(radars, 0.7, generator)) give(queue, s, order, &late);
    finish(queue, order);
    ASSERT_EQ(order, byAge(radars)) << "run " << run;
    ASSERT_EQ(late, 0) << "run " << run;
  }
}

// If this fails, what looks ahead of the sector in hand misses detections that have not come yet.
TEST(SectorOrder, WaitsForTheSectorsAhead) {
  SectorOrder queue(1, 1.0, 4);
  std::vector<Sector> order;
  for (const Sector& s : sectorsOf(0, 0.1, 0, 4)) give(queue, s, order);
  EXPECT_TRUE(order.empty());
  give(queue, {0, 4, 0.4, 0.5}, order);
  EXPECT_EQ(order, sectorsOf(0, 0.1, 0, 1));
}

// If this fails, one radar that is switched off stops the whole picture.
TEST(SectorOrder, GoesOnWithoutARadarThatHasFallenSilent) {
  SectorOrder queue(2, 1.0, 4);
  std::vector<Sector> order;
  for (const Sector& s : sectorsOf(0, 0.125, 0, 5)) give(queue, s, order);
  for (const Sector& s : sectorsOf(1, 0.125, 0, 100)) give(queue, s, order);
  // Radar 0 closed its last sector at 0.625 s. It may resume, and then come late by 1 s and a sector: at 12.5 s, what
  // was entered before 11.375 s has been handed out.
  EXPECT_EQ(order.size(), 5U + 91U);
  EXPECT_TRUE(queue.silent(0));
  EXPECT_FALSE(queue.silent(1));
}

// If this fails, a recording that begins before its time zero has new tracks at every turn until then.
TEST(SectorOrder, TakesTimesBeforeZeroAsAnyOther) {
  for (const double start : {-100.0, 100.0}) {
    SectorOrder queue(2, 1.0, 0);
    std::vector<Sector> order;
    for (const Sector& s : sectorsOf(0, 0.1, 0, 20, start)) give(queue, s, order);
    EXPECT_EQ(order.size(), 10U) << start;
    EXPECT_FALSE(queue.silent(0)) << start;
  }
}

TEST(SectorOrder, GoesOnWithoutARadarThatWasNeverHeard) {
  SectorOrder queue(2, 1.0, 4);
  std::vector<Sector> order;
  for (const Sector& s : sectorsOf(1, 0.125, 0, 8)) give(queue, s, order);
  EXPECT_TRUE(order.empty());  // 1 s: radar 0 may be so late …
  give(queue, {1, 8, 1.0, 1.125}, order);
  EXPECT_FALSE(order.empty());  // … but not later.
}

TEST(SectorOrder, TakesARadarInAgainThatResumes) {
  SectorOrder queue(2, 1.0, 4);
  std::vector<Sector> order;
  std::vector<std::vector<Sector>> radars = {sectorsOf(0, 0.1, 0, 20), sectorsOf(1, 0.125, 0, 320)};
  for (const Sector& s : sectorsOf(0, 0.1, 200, 400)) radars[0].push_back(s);
  std::vector<Sector> arrival = byAge(radars);
  std::stable_sort(arrival.begin(), arrival.end(), [](const Sector& a, const Sector& b) { return a.leave < b.leave; });
  int late = 0;
  for (const Sector& s : arrival) give(queue, s, order, &late);
  EXPECT_FALSE(queue.silent(0));
  finish(queue, order);
  EXPECT_EQ(order, byAge(radars));
  EXPECT_EQ(late, 0);
}

// If this fails, data that come too late are lost or, worse, nobody hears of it.
TEST(SectorOrder, HandsALateSectorOutNextAndSaysSo) {
  SectorOrder queue(2, 1.0, 4);
  std::vector<Sector> order;
  for (const Sector& s : sectorsOf(0, 0.1, 0, 50)) give(queue, s, order);
  const std::size_t before = order.size();
  int late = 0;
  for (const Sector& s : sectorsOf(1, 0.1, 0, 6)) give(queue, s, order, &late);
  EXPECT_EQ(late, 6);
  ASSERT_GE(order.size(), before + 2);
  EXPECT_EQ(order[before], (Sector{1, 0, 0.0, 0.0}));
  finish(queue, order);
  EXPECT_EQ(order.size(), 56U);
}

TEST(SectorOrder, HandsOutAllThatIsLeftAtTheEnd) {
  SectorOrder queue(3, 1.0, 4);
  std::vector<Sector> order;
  const std::vector<std::vector<Sector>> radars = {sectorsOf(0, 0.1, 0, 3), {}, sectorsOf(2, 0.13, 0, 2)};
  for (const Sector& s : byAge(radars)) give(queue, s, order);
  EXPECT_TRUE(order.empty());
  finish(queue, order);
  EXPECT_EQ(order, byAge(radars));
}

TEST(SectorOrder, GoesOverAGapInARadarsSectors) {
  SectorOrder queue(1, 1.0, 4);
  std::vector<Sector> sectors = sectorsOf(0, 0.1, 0, 10), order;
  for (const Sector& s : sectorsOf(0, 0.1, 13, 20)) sectors.push_back(s);
  for (const Sector& s : sectors) give(queue, s, order);
  finish(queue, order);
  EXPECT_EQ(order, sectors);
}

}  // namespace
}  // namespace tws
