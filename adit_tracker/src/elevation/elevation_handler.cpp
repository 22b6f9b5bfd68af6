#include "elevation/elevation_handler.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

// The antenna enters this sector when the list is made …
constexpr std::int64_t kListSector = 61;
// … and the tracker has processed the one that needs all sectors up to there.
constexpr std::int64_t kProcessedSector = kListSector - 1 - kSectorsAhead;

bool isDropped(const SectorReport& report, TrackFile::Slot slot) {
  return std::any_of(report.updates.begin(), report.updates.end(), [slot](const TrackUpdate& update) {
    return update.slot == slot && update.event == TrackEvent::kDropped;
  });
}

}  // namespace

std::size_t ElevationHandler::radarOf(const AditParams& params) {
  return radarIndex(params, params.elevation.radar.empty() ? params.reference_radar : params.elevation.radar);
}

ElevationHandler::ElevationHandler(const Adit& adit)
    : radar_(radarOf(adit.params())), params_(adit.params().elevation), schedule_(params_) {}

std::optional<ElevationList> ElevationHandler::afterSector(Adit& adit, const SectorReport& report) {
  if (report.radar != radar_) return std::nullopt;
  for (const TrackUpdate& update : report.updates) {
    if (update.event == TrackEvent::kUpdated || update.event == TrackEvent::kCoasted)
      schedule_.tried(adit.tracks().at(update.slot).uid);
  }
  if (!isDue(report.running)) return std::nullopt;
  updateDesignations(adit, report);
  return list(adit, report.running);
}

/// Once a scan, also when the sector itself is missing from the data.
bool ElevationHandler::isDue(std::int64_t running) {
  const std::int64_t scan = (running + tws::kSectors - kProcessedSector) / tws::kSectors;
  const bool in_time = running % tws::kSectors >= kProcessedSector;
  const bool due = in_time && (scan_ ? scan > *scan_ : running % tws::kSectors == kProcessedSector);
  scan_ = scan;
  return due;
}

/// Those whom the operator has designated by now, by age of the track; nobody else stays.
void ElevationHandler::updateDesignations(Adit& adit, const SectorReport& report) {
  std::vector<ElevationSchedule::Uid> designated;
  for (const auto slot : adit.tracks().living()) {
    if (isDropped(report, slot)) continue;
    const Track& track = adit.tracks().at(slot);
    if (params_.automatic && track.firm) adit.manual().designate(slot, true);
    if (track.designated) designated.push_back(track.uid);
  }
  std::sort(designated.begin(), designated.end());
  for (const auto uid : schedule_.designated()) {
    if (!std::binary_search(designated.begin(), designated.end(), uid)) schedule_.remove(uid);
  }
  for (const auto uid : designated) schedule_.designate(uid);
}

ElevationList ElevationHandler::list(const Adit& adit, std::int64_t running) {
  ElevationList list;
  const std::int64_t entered = running - running % tws::kSectors + kListSector;
  list.time = adit.radars().antenna(radar_).timeAt(tws::Antenna::startOf(entered));
  const std::vector<ElevationSchedule::Uid> wanted = schedule_.next();
  if (wanted.empty()) return list;
  for (const auto slot : adit.tracks().living()) {
    const bool is_wanted = std::find(wanted.begin(), wanted.end(), adit.tracks().at(slot).uid) != wanted.end();
    if (is_wanted) list.searches.push_back(search(adit, slot, running));
  }
  std::sort(list.searches.begin(), list.searches.end(), [](const ElevationSearch& a, const ElevationSearch& b) {
    return a.azimuth != b.azimuth ? a.azimuth < b.azimuth : a.track < b.track;
  });
  return list;
}

/// Where the beam meets the track on the turn that begins at the next north crossing. A search that begins just before
/// the turn ends meets its target just after: that meeting counts.
ElevationSearch ElevationHandler::search(const Adit& adit, TrackFile::Slot slot, std::int64_t running) const {
  constexpr int kEnough = 4;  // steps; targets move little while the beam moves on by what they have moved
  const double north = tws::Antenna::startOf((running / tws::kSectors + 1) * tws::kSectors);
  const double earliest = north + params_.lead;
  ApparentPosition there = adit.tracks().apparentPosition(slot, radar_, adit.radars().antenna(radar_).timeAt(earliest));
  for (int step = 0; step < kEnough; ++step) {
    const double meeting = earliest + tws::wrapTwoPi(there.azimuth - earliest);
    there = adit.tracks().apparentPosition(slot, radar_, adit.radars().antenna(radar_).timeAt(meeting));
  }
  return {adit.tracks().at(slot).number, tws::wrapTwoPi(there.azimuth - params_.lead), std::max(there.range, 1.0)};
}

}  // namespace adit_tracker
