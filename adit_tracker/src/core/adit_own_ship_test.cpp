// The tracker on a ship that moves and turns, against brute-force truth.
#include <gtest/gtest.h>

#include <map>

#include "core/adit_test_helpers.h"
#include "core/north_sectors.h"
#include "core/own_ship.h"
#include "core/ship_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kEnd = 200.0;  // [s]
constexpr std::size_t kBoats = 6, kRocks = 60;

/// Boats, and after them rocks, about the ship's way.
std::vector<TestBoat> harbour(std::mt19937_64& generator) {
  std::vector<TestBoat> all;
  for (std::size_t i = 0; i < kBoats; ++i) {
    const double direction = tws::uniform(generator, 0.0, tws::kTwoPi), range = tws::uniform(generator, 400.0, 2500.0);
    const double course = tws::uniform(generator, 0.0, tws::kTwoPi), speed = tws::uniform(generator, 3.0, 12.0);
    all.push_back({700.0 + range * std::sin(direction), 700.0 + range * std::cos(direction), speed * std::sin(course),
                   speed * std::cos(course)});
  }
  for (std::size_t i = 0; i < kRocks; ++i)
    all.push_back({tws::uniform(generator, -2500.0, 4000.0), tws::uniform(generator, -2500.0, 4000.0)});
  return all;
}

/// What own ship's receiver says, once a second.
OwnShip logOf(const TestShip& ship, bool with_heading) {
  OwnShip log;
  for (double time = 0.0; time <= kEnd; time += 1.0) {
    Pose pose = ship.at(time);
    if (!with_heading) pose.heading = 0.0;
    EXPECT_EQ(log.add(time, pose), "");
  }
  return log;
}

/// A confirmed track's update, in the fixed frame.
struct Seen {
  double time, x, y, vx, vy;
};

/// The tracker on the ship, and all that it says of confirmed tracks.
class OnShip {
 public:
  OnShip(const OwnShip& log, const std::vector<double>& periods, const std::string& set = "marine")
      : log_(log), adit(paramsOn(periods, set), [this](const SectorReport& report) { hear(report); }) {}

  void add(std::size_t radar, const tws::RadarSector& sector) {
    const auto ship = log_.over(sector.enter_time, sector.leave_time);
    ASSERT_TRUE(ship.has_value()) << sector.enter_time;
    adit.add(radar, sector, *ship);
    while (adit.step()) continue;
  }

  std::map<std::uint32_t, std::vector<Seen>> tracks;
  std::vector<tws::Plot> used;  // with range, azimuth and time of each update

 private:
  static AditParams paramsOn(const std::vector<double>& periods, const std::string& set) {
    AditParams params = paramsFor(set, periods);
    for (RadarParams& radar : params.radars) {
      radar.range_sigma = 5.0;
      radar.azimuth_sigma = tws::radians(0.5);
    }
    return params;
  }

  void hear(const SectorReport& report) {
    for (const TrackUpdate& update : report.updates) {
      tws::Plot plot;
      plot.time = update.time;
      plot.range = update.plot_range;
      plot.azimuth = update.plot_azimuth;
      if (!std::isnan(plot.range)) used.push_back(plot);
      const Track& track = adit.tracks().at(update.slot);
      if (update.event == TrackEvent::kDropped || !adit.tracks().confirmed(track)) continue;
      const Kinematics k = adit.tracks().extrapolate(update.slot, update.time).kinematics;
      tracks[track.uid].push_back({update.time, k.x + adit.origin().x, k.y + adit.origin().y, k.vx, k.vy});
    }
  }

  const OwnShip& log_;

 public:
  Adit adit;  // last: it speaks while it lives
};

/// Index of the nearest; as many as there are: none within 60 m.
std::size_t nearestTo(const std::vector<TestBoat>& boats, const Seen& seen) {
  std::size_t nearest = boats.size();
  double least = 60.0;
  for (std::size_t i = 0; i < boats.size(); ++i) {
    const double distance = std::hypot(boats[i].xAt(seen.time) - seen.x, boats[i].yAt(seen.time) - seen.y);
    if (distance < least) nearest = i, least = distance;
  }
  return nearest;
}

/// Each boat's tracks, by the boat's index; those of rocks and of nothing come after.
std::map<std::size_t, std::vector<const std::vector<Seen>*>> byBoat(const OnShip& run,
                                                                    const std::vector<TestBoat>& boats) {
  std::map<std::size_t, std::vector<const std::vector<Seen>*>> found;
  for (const auto& [uid, track] : run.tracks) found[nearestTo(boats, track.back())].push_back(&track);
  return found;
}

/// [m/s], over the second half.
double rmsVelocityError(const std::vector<Seen>& track, const TestBoat& boat) {
  double sum = 0.0;
  int count = 0;
  for (const Seen& seen : track) {
    if (seen.time < 0.5 * kEnd) continue;
    sum += std::pow(seen.vx - boat.vx, 2) + std::pow(seen.vy - boat.vy, 2);
    ++count;
  }
  return std::sqrt(sum / count);
}

void checkBoats(const OnShip& run, const std::vector<TestBoat>& boats) {
  const auto found = byBoat(run, boats);
  std::size_t others = 0;
  for (const auto& [index, tracks] : found) {
    if (index >= kBoats) others += tracks.size();
    if (index >= kBoats) continue;
    EXPECT_EQ(tracks.size(), 1U) << "boat " << index;
    EXPECT_LT(tracks[0]->front().time, 60.0) << "boat " << index;
    EXPECT_GT(tracks[0]->back().time, kEnd - 6.0) << "boat " << index;
    EXPECT_LT(rmsVelocityError(*tracks[0], boats[index]), 2.0) << "boat " << index;
  }
  EXPECT_LE(others, kRocks / 10) << "tracks of what stands still";
  for (std::size_t i = 0; i < kBoats; ++i) EXPECT_EQ(found.count(i), 1U) << "boat " << i;
}

// If this fails, all that stands still becomes a track where the ship moves, or boats' courses are told against the
// ship and not over ground.
TEST(AditOwnShip, BoatsHaveTracksOverGroundAndRocksHaveNone) {
  std::mt19937_64 generator = tws::seededGenerator();
  const TestShip ship;
  for (const bool from_bow : {true, false}) {
    TestShipRadar radar;
    radar.from_bow = from_bow;
    const std::vector<TestBoat> boats = harbour(generator);
    const OwnShip log = logOf(ship, from_bow);
    OnShip run(log, {radar.period});
    NorthSectors north;
    for (const tws::RadarSector& sector : radar.see(ship, boats, kEnd, generator)) {
      const Passage passage{sector.enter_time, sector.leave_time, ship.at(sector.enter_time),
                            ship.at(sector.leave_time)};
      for (const tws::RadarSector& cut : north.add(sector, passage)) run.add(0, cut);
    }
    run.adit.finish();
    checkBoats(run, boats);
  }
}

// If this fails, a second radar on the ship makes a second track of each boat.
TEST(AditOwnShip, TwoRadarsOfOneShipMakeOnePicture) {
  std::mt19937_64 generator = tws::seededGenerator();
  const TestShip ship;
  const std::vector<TestBoat> boats = harbour(generator);
  const std::vector<double> periods = {2.5, 1.7};
  const OwnShip log = logOf(ship, true);
  OnShip run(log, periods);
  std::vector<std::pair<double, std::pair<std::size_t, tws::RadarSector>>> order;
  for (std::size_t r = 0; r < periods.size(); ++r) {
    TestShipRadar radar;
    radar.period = periods[r];
    NorthSectors north;
    for (const tws::RadarSector& sector : radar.see(ship, boats, kEnd, generator)) {
      const auto passage = log.over(sector.enter_time, sector.leave_time);
      for (const tws::RadarSector& cut : north.add(sector, *passage)) order.push_back({cut.leave_time, {r, cut}});
    }
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [time, sector] : order) run.add(sector.first, sector.second);
  run.adit.finish();
  checkBoats(run, boats);
}

// If this fails, nobody finds the plot in the radar's data that updated a track, or that it asks about.
TEST(AditOwnShip, PlotsAreToldAsTheyWereMeasured) {
  std::mt19937_64 generator = tws::seededGenerator();
  const TestShip ship;
  const TestShipRadar radar;
  const std::vector<TestBoat> boats = harbour(generator);
  const OwnShip log = logOf(ship, true);
  OnShip run(log, {radar.period});
  std::vector<tws::Plot> told;
  run.adit.tellPlots([&](const SectorFates& sector) {
    for (const PlotFate& fate : sector.plots) told.push_back(fate.plot);
  });
  std::map<double, tws::Plot> sent;
  NorthSectors north;
  for (const tws::RadarSector& sector : radar.see(ship, boats, kEnd, generator)) {
    for (const tws::Plot& plot : sector.plots) sent[plot.time] = plot;
    for (const tws::RadarSector& cut : north.add(sector, *log.over(sector.enter_time, sector.leave_time)))
      run.add(0, cut);
  }
  run.adit.finish();
  EXPECT_GT(told.size(), sent.size() - 20U);
  ASSERT_GT(run.used.size(), 1000U);
  std::size_t matched = 0;
  for (const auto* plots : {&told, &run.used}) {
    for (const tws::Plot& plot : *plots) {
      const auto found = sent.find(plot.time);
      if (found == sent.end()) continue;  // of several plots that may be a track's own
      ++matched;
      EXPECT_NEAR(plot.range, found->second.range, 0.1) << plot.time;
      EXPECT_NEAR(tws::angularDifference(plot.azimuth, found->second.azimuth), 0.0, 1e-3) << plot.time;
    }
  }
  EXPECT_GT(matched, 0.9 * static_cast<double>(told.size() + run.used.size()));
}

// If this fails, a ship's radar is tracked by a filter that cannot follow it, and nobody is told.
TEST(AditOwnShip, TheReportsSetIsRefused) {
  Adit adit(paramsFor("nrl7952", {2.5}), {});
  EXPECT_THROW(adit.add(0, tws::RadarSector{}, Passage{}), std::invalid_argument);
}

}  // namespace
}  // namespace adit_tracker
