#include "sweep.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace tws_rviz {
namespace {

constexpr double kSilentTurns = 0.5;
constexpr double kGlowStep = tws::kTwoPi / 180.0;
constexpr double kGlowOpacity = 0.30;

}  // namespace

void Sweep::mark(const BeamMark& mark) {
  if (last_ && mark.time <= last_->time) return;
  const std::uint32_t sectors = last_ ? mark.running_sector - last_->running_sector : 0;
  if (mark.rotation_period > 0.0)
    period_ = mark.rotation_period;
  else if (sectors > 0 && sectors < static_cast<std::uint32_t>(tws::kSectors))
    period_ = tws::kSectors * (mark.time - last_->time) / sectors;
  last_ = mark;
}

std::optional<double> Sweep::azimuthAt(double time) const {
  if (!last_ || !(period_ > 0.0)) return std::nullopt;
  const double turns = (time - last_->time) / period_;
  if (turns > kSilentTurns) return std::nullopt;
  return tws::wrapTwoPi(tws::sectorStart(last_->sector) + turns * tws::kTwoPi);
}

double distanceToRim(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, double radius) {
  const double inside = radius * radius - origin.squaredNorm();
  if (!(inside > 0.0)) return 0.0;
  const double towards = origin.dot(direction);
  return std::sqrt(towards * towards + inside) - towards;
}

void addSweep(Drawing& drawing, const Eigen::Vector2d& origin, double azimuth, const SweepLook& look) {
  const auto rim = [&](double angle) -> Eigen::Vector2d {
    const Eigen::Vector2d direction = unitVector(angle);
    return origin + distanceToRim(origin, direction, look.picture_range) * direction;
  };
  const auto glow = [&](double behind) {
    const double left = 1.0 - behind / look.afterglow;
    return faded(look.color, kGlowOpacity * left * left);
  };
  const int steps = static_cast<int>(std::ceil(look.afterglow / kGlowStep));
  for (int i = 0; i < steps; ++i) {
    const double behind = i * kGlowStep;
    const double next = std::min(behind + kGlowStep, look.afterglow);
    addTriangle(drawing, {origin, glow(behind)}, {rim(azimuth - behind), glow(behind)},
                {rim(azimuth - next), glow(next)});
  }
  addLine(drawing, origin, rim(azimuth), look.line_width, look.color);
}

}  // namespace tws_rviz
