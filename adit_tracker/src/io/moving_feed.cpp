#include "io/moving_feed.h"

#include <utility>

namespace adit_tracker {

std::vector<MovingFeed::Sector> MovingFeed::take() {
  std::vector<Sector> ready;
  tws::RadarSector sector = feed_.take();
  if (from_ != AzimuthsFrom::kBow) {
    add(std::move(sector), ready);
  } else if (const auto ship = ship_.over(sector.enter_time, sector.leave_time)) {
    for (tws::RadarSector& cut : north_.add(sector, *ship)) add(std::move(cut), ready);
  } else {
    lose(sector);
  }
  if (feed_.nextTime()) return ready;
  if (auto last = north_.finish()) add(std::move(*last), ready);
  return ready;
}

void MovingFeed::add(tws::RadarSector sector, std::vector<Sector>& ready) {
  const auto ship = ship_.over(sector.enter_time, sector.leave_time);
  if (!ship) return lose(sector);
  if (from_ == AzimuthsFrom::kHeadings)
    for (tws::Plot& plot : sector.plots) plot.azimuth -= ship->at(plot.time).heading;
  ready.push_back({std::move(sector), *ship});
}

void MovingFeed::lose(const tws::RadarSector& sector) {
  ++lost_sectors_;
  lost_plots_ += sector.plots.size();
}

}  // namespace adit_tracker
