#include "core/sector_intake.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

bool isCopy(const tws::Plot& a, const tws::Plot& b) {
  return a.time == b.time && a.range == b.range && a.azimuth == b.azimuth;
}

/// Takes out what says the same as a plot shortly before it; all are in order of time. Returns how many.
std::size_t dropCopies(std::vector<tws::Plot>& plots) {
  constexpr std::size_t kLookBack = 64;  // plots of one time
  std::size_t kept = 0;
  for (const tws::Plot& plot : plots) {
    const std::size_t least = kept - std::min(kept, kLookBack);
    std::size_t i = kept;
    while (i > least && plots[i - 1].time == plot.time && !isCopy(plots[i - 1], plot)) --i;
    if (i == least || plots[i - 1].time != plot.time) plots[kept++] = plot;
  }
  const std::size_t dropped = plots.size() - kept;
  plots.resize(kept);
  return dropped;
}

}  // namespace

void SectorIntake::add(std::size_t radar, tws::RadarSector sector, const std::optional<Passage>& ship) {
  sift(radar, sector);
  counts_.plots += sector.plots.size();
  radars_.at(radar).waiting.push_back({std::move(sector), ship});
}

/// Takes out what makes no sense, what comes too late, and what has come already.
void SectorIntake::sift(std::size_t radar, tws::RadarSector& sector) {
  const double earliest = sector.enter_time - radars_.antenna(radar).sectorDuration();
  const auto sift_out = [&](std::uint64_t AditCounts::*count, const auto& unusable) {
    const auto end = std::remove_if(sector.plots.begin(), sector.plots.end(), unusable);
    counts_.*count += static_cast<std::uint64_t>(sector.plots.end() - end);
    sector.plots.erase(end, sector.plots.end());
  };
  sift_out(&AditCounts::rejected_plots, [](const tws::Plot& p) {
    return !(std::isfinite(p.time) && std::isfinite(p.azimuth) && p.range > 0.0 && p.range <= kFarthest);
  });
  sift_out(&AditCounts::late_plots, [&](const tws::Plot& p) { return p.time < earliest; });
  sift_out(&AditCounts::duplicate_plots,
           [&](const tws::Plot& p) { return p.time < sector.enter_time && cameBefore(radar, sector.running, p); });
  counts_.duplicate_plots += dropCopies(sector.plots);
}

/// Did the sector before hold this plot already?
bool SectorIntake::cameBefore(std::size_t radar, std::int64_t running, const tws::Plot& plot) {
  const auto& waiting = radars_.at(radar).waiting;
  const auto same = [&](const tws::Plot& other) { return isCopy(other, plot); };
  const auto holds = [&](const tws::RadarSector& sector) {
    return std::any_of(sector.plots.begin(), sector.plots.end(), same);
  };
  if (!waiting.empty()) return holds(waiting.back().sector);
  if (radars_.at(radar).latest.running == running - 1 && holds(radars_.at(radar).latest)) return true;
  const auto& before = radars_.at(radar).detections.at(running - 1).detections;
  return std::any_of(before.begin(), before.end(), [&](const Detection& d) { return same(d.plot); });
}

void SectorIntake::admit(const tws::SectorRef& sector) {
  RadarState& radar = radars_.at(sector.radar);
  auto& waiting = radar.waiting;
  for (; !waiting.empty() && waiting.front().sector.running <= sector.running + ahead_; waiting.pop_front())
    letIn(sector.radar, waiting.front());
}

void SectorIntake::letIn(std::size_t index, WaitingSector& next) {
  RadarState& radar = radars_.at(index);
  tws::RadarSector& sector = next.sector;
  tws::RegistrationTerms taken{};
  if (!next.ship && alignment_.isOn()) {
    alignment_.look(index, sector);
    taken = alignment_.registration().applied(index);
  }
  if (taken != tws::RegistrationTerms{}) {
    radar.latest = sector;
    takeOut(taken, sector);
  }
  radar.antenna.cross(sector.running, sector.enter_time);
  radar.antenna.cross(sector.running + 1, sector.leave_time);
  for (const tws::Plot& plot : sector.plots) radar.quality.falsePlotMap().addRange(plot.range);
  if (next.ship) {
    radar.latest = sector;
    for (tws::Plot& plot : sector.plots) plot = seenFrom(radars_.origin(), *next.ship, plot);
  }
  DetectionSector& taken_in = radar.detections.add(sector);
  taken_in.ship = next.ship;
  taken_in.taken = taken;
}

}  // namespace adit_tracker
