#include "io/track_csv.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace adit_tracker {

const char* statusOf(const Adit& adit, const Track& track) {
  if (!adit.tracks().confirmed(track)) return "tentative";
  return track.coasting ? "coasting" : "firm";
}

TrackCsv::TrackCsv(std::ostream& output, bool with_heights) : output_(output), with_heights_(with_heights) {
  output_ << "t_s,track_id,x_m,y_m,vx_mps,vy_mps,status" << (with_heights ? ",height_m,height_sigma_m\n" : "\n");
}

void TrackCsv::row(const Adit& adit, TrackFile::Slot slot, double time) {
  const Track& track = adit.tracks().at(slot);
  const Kinematics k = adit.tracks().extrapolate(slot, time).kinematics;
  char text[200];
  std::snprintf(text, sizeof text, "%.4f,%u,%.1f,%.1f,%.2f,%.2f,%s", time, track.uid, k.x, k.y, k.vx, k.vy,
                statusOf(adit, track));
  output_ << text;
  if (with_heights_) heightColumns(adit.tracks().height(slot, time));
  output_ << '\n';
}

void TrackCsv::heightColumns(const std::optional<Height>& height) {
  char text[60] = ",,";
  if (height) std::snprintf(text, sizeof text, ",%.1f,%.1f", height->height, height->height_sigma);
  output_ << text;
}

void TrackCsv::report(const Adit& adit, const SectorReport& report) {
  for (const TrackUpdate& update : report.updates) {
    if (update.event != TrackEvent::kDropped) row(adit, update.slot, update.time);
  }
}

void TrackCsv::picture(const Adit& adit, double time) {
  auto slots = adit.tracks().living();
  const auto uid = [&](TrackFile::Slot s) { return adit.tracks().at(s).uid; };
  std::sort(slots.begin(), slots.end(), [&](auto a, auto b) { return uid(a) < uid(b); });
  for (const auto slot : slots) {
    if (adit.tracks().confirmed(adit.tracks().at(slot))) row(adit, slot, time);
  }
}

}  // namespace adit_tracker
