#include "radar_feed.h"

#include <cmath>
#include <utility>

#include "report_csv.h"

namespace asterix_bridge {

RadarFeed::RadarFeed(DataClock clock, Options options, Events events)
    : options_(std::move(options)),
      events_(std::move(events)),
      stream_(clock, {[this](const TargetReport& report, double time) { add(report, time); },
                      [this](const ServiceMessage& message, double time) { add(message, time); },
                      [this](FaultKind kind, const BlockFault& fault) {
                        const std::string place = origin_ + ", byte " + std::to_string(fault.offset) + ": ";
                        events_.fault(toText(kind), place + fault.reason);
                      }}) {}

void RadarFeed::add(const FramingStep& step, const std::string& origin) {
  origin_ = origin;
  stream_.add(step);
  if (!options_.sectors.steady) advance(now());
}

void RadarFeed::advance(double now) {
  for (auto& [radar, cutter] : cutters_) cutter.advance(now);
}

void RadarFeed::setLatency(double latency) {
  options_.sectors.latency = latency;
  for (auto& [radar, cutter] : cutters_) cutter.setLatency(latency);
}

void RadarFeed::finish() {
  stream_.finish();
  for (auto& [radar, cutter] : cutters_) cutter.finish();
}

void RadarFeed::add(const TargetReport& report, double time) {
  const std::string radar = radarName(*report.source);
  if (report.test_target && !options_.test_targets) return events_.left_out("test targets");
  if (!report.primary && !report.secondary) return events_.left_out("reports without detection");
  if (std::isnan(time)) return events_.fault("reports without time", "from " + radar);
  if (!(report.range > 0.0)) return events_.fault("reports without measured position", "from " + radar);
  if (SectorCutter* const cutter = cutterOf(*report.source)) cutter->add(report, time);
}

void RadarFeed::add(const ServiceMessage& message, double time) {
  SectorCutter* const cutter = cutterOf(*message.source);
  if (!cutter) return;
  if (message.position) placeOf(*message.source, *message.position);
  if (message.antenna_period > 0.0) cutter->setNominalPeriod(message.antenna_period);
  if (message.type == kNorthMarker) cutter->mark(time, 0.0);
  if (message.type == kSectorCrossing && !std::isnan(message.sector_azimuth))
    cutter->mark(time, message.sector_azimuth);
}

void RadarFeed::placeOf(SourceId radar, const tws::Geodetic& position) {
  if (isListed(radar) || proven_.count(radar) > 0) return events_.position(radar, position);
  places_[radar] = position;
}

// Sectors are evidence of a radar: its marks or plots have shown how its beam turns.
SectorCutter* RadarFeed::cutterOf(SourceId radar) {
  const auto found = cutters_.find(radar);
  const bool is_allowed = isListed(radar) || (!options_.only_listed && (found != cutters_.end() || hasRoom()));
  if (!is_allowed) {
    events_.fault("records of further radars", radarName(radar) + "; see parameters radars and most_radars");
    return nullptr;
  }
  heard_[radar] = stream_.records();
  if (found != cutters_.end()) return &found->second;
  SectorCutter::Events events;
  events.sector = [this, radar](CutSector&& sector) {
    proven_.insert(radar);
    if (const auto place = places_.find(radar); place != places_.end()) {
      events_.position(radar, place->second);
      places_.erase(place);
    }
    events_.sector(radar, std::move(sector));
  };
  events.fault = [this, radar](const std::string& counter, const std::string& reason) {
    events_.fault(counter, radarName(radar) + ": " + reason);
  };
  return &cutters_.try_emplace(radar, options_.sectors, std::move(events)).first->second;
}

bool RadarFeed::hasRoom() {
  std::size_t others = 0;
  const SourceId* oldest = nullptr;
  for (const auto& [radar, cutter] : cutters_) {
    if (isListed(radar)) continue;
    ++others;
    if (proven_.count(radar) == 0 && (!oldest || heard_[radar] < heard_[*oldest])) oldest = &radar;
  }
  if (others < options_.most_radars) return true;
  if (!oldest) return false;
  const SourceId gone = *oldest;
  events_.fault("records of further radars", radarName(gone) + " makes room: it has not shown how its beam turns");
  heard_.erase(gone);
  places_.erase(gone);
  cutters_.erase(gone);
  return true;
}

}  // namespace asterix_bridge
