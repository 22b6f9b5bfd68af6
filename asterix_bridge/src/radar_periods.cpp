#include "radar_periods.h"

#include <algorithm>
#include <cmath>

#include "beam.h"

namespace asterix_bridge {
namespace {

constexpr std::size_t kMostRadars = 256;

struct Watched {
  Beam beam;
  double now = 0.0;
};

class Periods {
 public:
  void add(const TargetReport& report, double time) {
    if (Watched* radar = watched(*report.source, time); radar && report.range > 0.0)
      radar->beam.add(time, report.azimuth);
  }
  void add(const ServiceMessage& message, double time) {
    Watched* const radar = watched(*message.source, time);
    if (!radar) return;
    radar->beam.setNominalPeriod(message.antenna_period);
    if (message.type == kNorthMarker) radar->beam.addNorth(time);
    if (message.type == kSectorCrossing && !std::isnan(message.sector_azimuth))
      radar->beam.addMark(time, message.sector_azimuth);
  }
  std::map<SourceId, double> finish() {
    std::map<SourceId, double> periods;
    for (auto& [source, radar] : radars_)
      if (radar.beam.isKnown() || radar.beam.learnNow(radar.now, radar.now)) periods[source] = radar.beam.period();
    return periods;
  }

 private:
  // Nothing: its beam is known already.
  Watched* watched(SourceId source, double time) {
    if (std::isnan(time) || (radars_.size() >= kMostRadars && radars_.count(source) == 0)) return nullptr;
    Watched& radar = radars_[source];
    radar.now = std::max(radar.now, time);
    return radar.beam.learn(radar.now, radar.now) ? nullptr : &radar;
  }

  std::map<SourceId, Watched> radars_;
};

}  // namespace

std::map<SourceId, double> periodsOf(const Recording& recording, const DataClock& clock) {
  Periods periods;
  RecordStream::Events events;
  events.report = [&](const TargetReport& report, double time) { periods.add(report, time); };
  events.message = [&](const ServiceMessage& message, double time) { periods.add(message, time); };
  events.fault = [](FaultKind, const BlockFault&) {};
  RecordStream stream(clock, std::move(events));
  const auto blocks = recording.blocks();
  while (const auto step = blocks->next()) stream.add(*step);
  return periods.finish();
}

}  // namespace asterix_bridge
