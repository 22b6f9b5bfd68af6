#include "core/stitching.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace adit_tracker {
namespace {

constexpr double kClearly = 2.0;  // by which factor the best must be better than the second
constexpr double kSigmas = 3.0;   // of errors, by which the one may be off from the other

double speedOf(const tws::PlanarMotion& m) { return std::hypot(m.vx, m.vy); }
double sigmaOf(const tws::Symmetric2& a, const tws::Symmetric2& b) { return std::sqrt(a.xx + a.yy + b.xx + b.yy); }

}  // namespace

/// How far off its straight course the lost track must have gone to be the one that was found [m]; nothing: it cannot.
std::optional<double> Stitching::detour(const TrackMotion& motion, const Track& lost, const Track& found,
                                        double period) const {
  const StitchingParams& limits = params_.in(found.volume).stitching;
  const double gap = found.first_time - lost.last_update;
  if (gap <= 0.0 || gap > limits.longest_gap * period) return std::nullopt;
  const tws::PlanarMotion from = motion.at(lost, lost.last_update).planar,
                          to = motion.at(found, found.first_time).planar;
  const double before = speedOf(from), after = speedOf(to);
  if (std::abs(before - after) > limits.speed_change + kSigmas * sigmaOf(from.velocity, to.velocity))
    return std::nullopt;
  const double x = to.x - from.x, y = to.y - from.y;
  const double reach = gap * std::max(before, after) + kSigmas * sigmaOf(from.position, to.position);
  if (std::hypot(x, y) > reach) return std::nullopt;
  return std::hypot(x - gap * from.vx, y - gap * from.vy);
}

std::optional<TrackFile::Slot> Stitching::lostBefore(const TrackBook& tracks, TrackFile::Slot slot,
                                                     double period) const {
  if (params_.in(tracks.at(slot).volume).stitching.longest_gap == 0.0) return std::nullopt;
  double least = std::numeric_limits<double>::infinity(), second = least;
  std::optional<TrackFile::Slot> found;
  for (const TrackFile::Slot other : tracks.lost()) {
    if (other == slot || tracks.isDropped(other)) continue;
    const auto off = detour(tracks.motion(), tracks.at(other), tracks.at(slot), period);
    if (!off) continue;
    if (*off < least) {
      second = least;
      least = *off;
      found = other;
    } else if (*off < second) {
      second = *off;
    }
  }
  return kClearly * least < second ? found : std::nullopt;
}

}  // namespace adit_tracker
