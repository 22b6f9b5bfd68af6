#include "radar_joins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tws_runtime {

RadarJoins::RadarJoins(std::size_t radars, SectorJoin::Options options, Events events)
    : events_(std::move(events)), in_old_run_(radars, false), newest_time_(newestTime()) {
  for (std::size_t radar = 0; radar < radars; ++radar) {
    SectorJoin::Events own;
    own.sector = [this, radar](tws::RadarSector sector) { events_.sector(radar, std::move(sector)); };
    own.new_run = [this, radar](double time) { beginNewRun(radar, time); };
    own.fault = [this, radar](const std::string& counter, const std::string& reason) {
      events_.fault(radar, counter, reason);
    };
    joins_.emplace_back(options, std::move(own));
  }
}

void RadarJoins::add(std::size_t radar, SectorDetections detections) {
  if (isOld(radar, detections.leave_time)) return;
  joins_[radar].add(std::move(detections));
  newest_time_ = newestTime();
}

void RadarJoins::add(std::size_t radar, SectorCrossing mark) {
  if (isOld(radar, mark.time)) return;
  joins_[radar].add(mark);
  newest_time_ = newestTime();
}

/// Nearer to the end of the old run than to where the new one is now.
bool RadarJoins::isOld(std::size_t radar, double time) {
  if (!in_old_run_[radar]) return false;
  const bool old = std::abs(time - old_time_) < std::abs(time - newest_time_);
  if (old)
    events_.fault(radar, "messages of the old run", "stamp " + std::to_string(time) + " s");
  else
    in_old_run_[radar] = false;
  return old;
}

void RadarJoins::beginNewRun(std::size_t radar, double time) {
  old_time_ = newest_time_;
  newest_time_ = time;
  events_.new_run(time);
  for (std::size_t other = 0; other < joins_.size(); ++other) {
    if (other == radar) continue;
    const bool was_heard = joins_[other].newestTime().has_value();
    joins_[other].beginNewRun();
    in_old_run_[other] = was_heard && !joins_[other].newestTime();
  }
}

double RadarJoins::newestTime() const {
  double newest = -std::numeric_limits<double>::infinity();
  for (const SectorJoin& join : joins_) newest = std::max(newest, join.newestTime().value_or(newest));
  return newest;
}

}  // namespace tws_runtime
