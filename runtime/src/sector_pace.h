#pragma once

#include <cstdint>
#include <optional>

namespace tws_runtime {

/// The beam of a radar enters the sector with this running number at this time [s].
struct Crossing {
  std::int64_t running = 0;
  double time = 0.0;
};

/// The pace at which the sectors of one radar follow each other: running number and time must advance together, within
/// what the turning of an antenna allows. A damaged stamp or number and a radar that counts anew do not fit. (Whether a
/// new run has begun is not decided here, but by the intake.)
class SectorPace {
 public:
  /// Anything fits before the first crossing.
  bool fits(const Crossing& crossing) const;
  void add(const Crossing& crossing);
  /// A message's 32-bit number as one that never wraps: the one next to the newest number.
  std::int64_t unwrapped(std::uint32_t running) const;
  /// The crossing with the latest time; nothing before the first one.
  const std::optional<Crossing>& newest() const { return newest_; }
  void clear() { *this = SectorPace(); }

 private:
  std::optional<Crossing> newest_;
  double sector_time_ = 0.0;  ///< Smoothed time from crossing to crossing [s]; 0: unknown.
};

}  // namespace tws_runtime
