#include "sector_pace.h"

#include <cmath>

#include <tws_core/sectors.h>

namespace tws_runtime {
namespace {

/// Longer gaps are not bridged: the run goes on behind them.
constexpr std::int64_t kLongestGap = std::int64_t{8} * tws::kSectors;
/// While the antenna's speed is unknown: no further apart than one turn, and no radar takes longer for it.
constexpr double kLongestTurn = 60.0;  // [s]

}  // namespace

bool SectorPace::fits(const Crossing& crossing) const {
  if (!newest_) return true;
  const std::int64_t sectors = crossing.running - newest_->running;
  if (std::abs(sectors) > kLongestGap) return false;
  if (sector_time_ <= 0.0)
    return std::abs(sectors) <= tws::kSectors && std::abs(crossing.time - newest_->time) < kLongestTurn;
  const double expected = (crossing.time - newest_->time) / sector_time_;
  const double tolerance = 4.0 + 0.1 * std::abs(expected);  // Wind, and time in coarse ticks.
  return std::abs(static_cast<double>(sectors) - expected) <= tolerance;
}

void SectorPace::add(const Crossing& crossing) {
  if (!newest_) {
    newest_ = crossing;
    return;
  }
  if (crossing.time <= newest_->time) return;
  if (crossing.running > newest_->running) {
    const double step = (crossing.time - newest_->time) / static_cast<double>(crossing.running - newest_->running);
    sector_time_ = sector_time_ > 0.0 ? 0.75 * sector_time_ + 0.25 * step : step;
  }
  newest_ = crossing;
}

std::int64_t SectorPace::unwrapped(std::uint32_t running) const {
  if (!newest_) return running;
  const auto step = static_cast<std::int32_t>(running - static_cast<std::uint32_t>(newest_->running));
  return newest_->running + step;
}

}  // namespace tws_runtime
