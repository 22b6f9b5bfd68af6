#include "io/track_csv.h"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace adit_tracker {
namespace {

constexpr const char* kCovarianceColumns =
    ",cov_x_x,cov_x_y,cov_x_vx,cov_x_vy,cov_y_y,cov_y_vx,cov_y_vy,cov_vx_vx,cov_vx_vy,cov_vy_vy";

}  // namespace

const char* statusOf(const Adit& adit, const Track& track) {
  if (!adit.tracks().confirmed(track)) return "tentative";
  return track.coasting ? "coasting" : "firm";
}

TrackCsv::TrackCsv(std::ostream& output, bool with_heights, bool with_covariances)
    : output_(output), with_heights_(with_heights), with_covariances_(with_covariances) {
  output_ << "t_s,track_id,x_m,y_m,vx_mps,vy_mps,status" << (with_heights ? ",height_m,height_sigma_m" : "")
          << (with_covariances ? kCovarianceColumns : "") << '\n';
}

void TrackCsv::row(const Adit& adit, TrackFile::Slot slot, double time) {
  const Track& track = adit.tracks().at(slot);
  const Extrapolation now = adit.tracks().extrapolate(slot, time);
  const Kinematics& k = now.kinematics;
  char text[200];
  std::snprintf(text, sizeof text, "%.4f,%u,%.1f,%.1f,%.2f,%.2f,%s", time, track.uid, k.x + adit.origin().x,
                k.y + adit.origin().y, k.vx, k.vy, statusOf(adit, track));
  output_ << text;
  if (with_heights_) heightColumns(adit.tracks().height(slot, time));
  if (with_covariances_) covarianceColumns(now);
  output_ << '\n';
}

void TrackCsv::covarianceColumns(const Extrapolation& track) {
  const tws::PlanarMotion& p = track.planar;
  for (const double value : {p.position.xx, p.position.xy, p.x_vx, p.x_vy, p.position.yy, p.y_vx, p.y_vy, p.velocity.xx,
                             p.velocity.xy, p.velocity.yy}) {
    char text[40] = ",";
    if (track.has_covariance) std::snprintf(text, sizeof text, ",%.6g", value);
    output_ << text;
  }
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
