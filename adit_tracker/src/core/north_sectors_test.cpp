#include "core/north_sectors.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include "core/ship_test_helpers.h"

namespace adit_tracker {
namespace {

/// Rings of rocks about the whole area.
std::vector<TestBoat> rocks(std::mt19937_64& generator) {
  std::vector<TestBoat> all;
  for (int i = 0; i < 100; ++i)
    all.push_back({tws::uniform(generator, -3000.0, 3000.0), tws::uniform(generator, -3000.0, 3000.0)});
  return all;
}

Passage passageOf(const TestShip& ship, const tws::RadarSector& sector) {
  return {sector.enter_time, sector.leave_time, ship.at(sector.enter_time), ship.at(sector.leave_time)};
}

// If this fails, what a ship that turns sees lies in another sector than its tracks, and gets no plots.
TEST(NorthSectors, EveryPlotComesOnceInTheSectorOfItsBearing) {
  std::mt19937_64 generator = tws::seededGenerator();
  TestShipRadar radar;
  radar.azimuth_sigma = 0.0;
  for (const double swing : {0.5, -2.0, 3.0}) {
    TestShip ship;
    ship.swing = swing;
    const auto sectors = radar.see(ship, rocks(generator), 60.0, generator);
    NorthSectors north;
    std::vector<tws::RadarSector> cut;
    std::size_t sent = 0, came = 0;
    for (const tws::RadarSector& sector : sectors) {
      sent += sector.plots.size();
      for (tws::RadarSector& each : north.add(sector, passageOf(ship, sector))) cut.push_back(each);
    }
    if (const auto last = north.finish()) cut.push_back(*last);
    for (std::size_t i = 0; i < cut.size(); ++i) {
      EXPECT_EQ(cut[i].sector, cut[i].running % tws::kSectors);
      EXPECT_LE(cut[i].enter_time, cut[i].leave_time);
      EXPECT_EQ(cut[i].running, cut[0].running + static_cast<std::int64_t>(i));
      EXPECT_EQ(cut[i].enter_time, i > 0 ? cut[i - 1].leave_time : 0.0);
      came += cut[i].plots.size();
      for (const tws::Plot& plot : cut[i].plots) {
        const double middle = tws::sectorStart(cut[i].sector) + 0.5 * tws::kSectorWidth;
        const double off = tws::angularDifference(plot.azimuth + ship.at(plot.time).heading, middle);
        EXPECT_LT(std::abs(off), 0.51 * tws::kSectorWidth) << plot.time;
      }
    }
    EXPECT_EQ(came, sent);
    EXPECT_GE(cut.front().running, 0);
  }
}

// If this fails, lost messages of a radar end its picture, or its plots come twice.
TEST(NorthSectors, AfterAGapNumbersGoOnByTheBeam) {
  NorthSectors north;
  std::vector<tws::RadarSector> cut;
  const Pose east{0.0, 0.0, tws::kPi / 2.0 + 0.01};
  for (std::int64_t running = 0; running < 40; ++running) {
    if (running >= 10 && running < 20) continue;
    tws::RadarSector sector;
    sector.running = running;
    sector.enter_time = 0.1 * static_cast<double>(running);
    sector.leave_time = sector.enter_time + 0.1;
    tws::Plot plot;
    plot.time = sector.enter_time + 0.05;
    sector.plots = {plot};
    for (tws::RadarSector& each : north.add(sector, {sector.enter_time, sector.leave_time, east, east}))
      cut.push_back(each);
  }
  cut.push_back(*north.finish());
  double latest = -1.0;
  std::size_t plots = 0;
  for (const tws::RadarSector& sector : cut) {
    EXPECT_GT(sector.running, latest);
    latest = static_cast<double>(sector.running);
    plots += sector.plots.size();
    EXPECT_FALSE(sector.enter_time < 0.99 && sector.leave_time > 1.01) << "none reaches over the gap";
  }
  EXPECT_EQ(plots, 30U);
}

}  // namespace
}  // namespace adit_tracker
