#pragma once

#include <optional>
#include <vector>

#include "physics.h"
#include "transponder.h"

namespace radar_sim {

/// The reply in space: ICAO Annex 10, volume IV, 3.1.1.6. Between two framing pulses 20.3 µs apart lie thirteen
/// positions, every 1.45 µs: C1 A1 C2 A2 C4 A4 X B1 D1 B2 D2 B4 D4; X is never used. A pulse is 0.45 µs wide.
constexpr double kFramingInterval = 20.3e-6;  // [s]
constexpr double kPulseInterval = 1.45e-6;    // [s]
constexpr double kPulseWidth = 0.45e-6;       // [s]

/// Two replies to one interrogation overlap when the slant ranges differ by less than half a reply's length in space:
/// 3.04 km, 1.64 NM. Their codes may then garble each other.
constexpr double kGarbleRange = kSpeedOfLight * kFramingInterval / 2.0;
/// Replies nearer than half a pulse's length in space, 67 m, look like one.
constexpr double kReplyResolution = kSpeedOfLight * kPulseWidth / 2.0;

/// What a decoder that is aligned with the framing pulses of `own` reads when `other` comes later by `delay` [s]
/// (negative: earlier): every pulse of its own, and each pulse of the other that covers more than half of a position.
/// Nothing of the other is left out by a delay of less than the length of a reply.
Code overlaid(Code own, Code other, double delay);

/// One decoded reply.
struct DecodedReply {
  Code code;
  bool garbled;  ///< It overlapped another one.
};

/// What a plot says of one mode.
struct CodeReading {
  std::optional<Code> code;  ///< Nothing: not enough replies.
  bool garbled = false;      ///< The code is not to be trusted.
};

/// The code that most ungarbled replies agree on, when there are at least `needed` of them; it counts as garbled when
/// others disagree. Else the most frequent one of all, as garbled, when all together are at least `needed`. Of equally
/// frequent ones the smaller.
CodeReading readCode(const std::vector<DecodedReply>& replies, long needed);

}  // namespace radar_sim
