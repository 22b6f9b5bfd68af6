#include "core/duplicate_tracks.h"

#include <Eigen/Dense>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr float kLikelyTarget = 0.3F;  // who is less than that disturbs nobody
// Beyond these they are looked at no further; kAlike is in standard deviations of both, squared, of four numbers.
constexpr double kApart = 600.0, kFaster = 30.0, kLater = 1.0;  // [m], [m/s], [s]
constexpr double kAlike = 0.3;

Eigen::Matrix4d covarianceOf(const tws::PlanarMotion& s) {
  Eigen::Matrix4d m;
  m << s.position.xx, s.position.xy, s.x_vx, s.x_vy, s.position.xy, s.position.yy, s.y_vx, s.y_vy, s.x_vx, s.y_vx,
      s.velocity.xx, s.velocity.xy, s.x_vy, s.y_vy, s.velocity.xy, s.velocity.yy;
  return m;
}

bool mayBeOne(const Kinematics& a, const Kinematics& b) {
  const double dt = b.time - a.time;
  return std::abs(dt) < kLater && std::hypot(a.vx - b.vx, a.vy - b.vy) < kFaster &&
         std::hypot(a.x + dt * a.vx - b.x, a.y + dt * a.vy - b.y) < kApart;
}

bool areOne(const TrackBook& tracks, TrackFile::Slot a, TrackFile::Slot b) {
  const double time = tracks.at(b).smoothed.time;
  if (!mayBeOne(tracks.at(a).smoothed, tracks.at(b).smoothed)) return false;
  const tws::PlanarMotion s = tracks.extrapolate(a, time).planar, t = tracks.extrapolate(b, time).planar;
  const Eigen::Vector4d apart{s.x - t.x, s.y - t.y, s.vx - t.vx, s.vy - t.vy};
  return apart.dot((covarianceOf(s) + covarianceOf(t)).ldlt().solve(apart)) < kAlike;
}

/// Firm before tentative, then the older.
bool staysBefore(const Track& a, const Track& b) { return a.firm != b.firm ? a.firm : a.uid < b.uid; }

}  // namespace

void DuplicateTracks::endAmong(TrackBook& tracks, bool firm_too) {
  for (std::size_t i = 0; i < suspects_.size(); ++i) {
    for (std::size_t j = i + 1; j < suspects_.size() && !tracks.isDropped(suspects_[i]); ++j) {
      const auto a = suspects_[i], b = suspects_[j];
      if (tracks.isDropped(b) || (!firm_too && tracks.at(a).firm && tracks.at(b).firm)) continue;
      if (!areOne(tracks, a, b)) continue;
      tracks.drop(staysBefore(tracks.at(a), tracks.at(b)) ? b : a, tracks.at(b).smoothed.time);
    }
  }
}

void DuplicateTracks::end(const std::vector<Correlation>& correlations, TrackBook& tracks, bool firm_too) {
  for (std::size_t first = 0, last = 0; first < correlations.size(); first = last) {
    suspects_.clear();
    do {
      const Correlation& c = correlations[last];
      if (c.weighed && !tracks.isDropped(c.slot) && tracks.at(c.slot).existence > kLikelyTarget)
        suspects_.push_back(c.slot);
    } while (++last < correlations.size() && correlations[last].weighed &&
             correlations[last].cluster == correlations[first].cluster);
    if (suspects_.size() > 1) endAmong(tracks, firm_too);
  }
}

}  // namespace adit_tracker
