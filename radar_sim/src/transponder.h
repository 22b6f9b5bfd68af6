#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "trajectory.h"

namespace radar_sim {

/// Interrogation modes; 3/A is the one that civil and military radars share.
enum class Mode { k1, k2, k3A, kC };
constexpr std::size_t kModes = 4;
constexpr std::size_t index(Mode mode) { return static_cast<std::size_t>(mode); }

/// A reply's twelve information pulses as four octal digits A B C D: the code 7421 is 07421. Mode 1 has the digits A
/// (0 .. 7) and B (0 .. 3) only: its code 31 is 03100.
using Code = std::uint16_t;
constexpr Code kAllPulses = 07777;
constexpr Code kMode1Pulses = 07300;

/// What an aircraft replies.
struct Transponder {
  static constexpr int kNone = -1;   ///< No reply in that mode.
  static constexpr int kDrawn = -2;  ///< To be drawn from the seed.

  std::array<int, 3> codes{kNone, kNone, kNone};  ///< Of modes 1, 2 and 3/A.
  bool altitude = false;                          ///< Replies in mode C.
  std::vector<TimeSpan> silences;                 ///< When it does not reply at all [s of data time].

  /// The code of a reply; nothing: no reply. `height`: pressure altitude [m].
  std::optional<Code> reply(Mode mode, double height) const;
  bool isSilentAt(double time) const;
};

/// Which share of a random group replies, and in which modes.
struct TransponderShares {
  double fraction = 0.0;           ///< Has a transponder with modes 3/A and C.
  double military_fraction = 0.0;  ///< Of those, replies in modes 1 and 2 as well.
};

/// The transponder with a code for every kDrawn, from a stream of its own for each target's name. Mode 3/A codes lie in
/// 0001 .. 6777 (the sevens are for emergencies and the like); two aircraft may get the same one.
Transponder drawCodes(Transponder transponder, std::uint64_t seed, const std::string& target);
Transponder drawTransponder(const TransponderShares& shares, std::uint64_t seed, const std::string& target);

}  // namespace radar_sim
