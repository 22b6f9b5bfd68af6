#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "reply.h"

namespace radar_sim {

/// One aircraft while the beam passes over it: what it replies to which interrogation.
struct Illumination {
  double time = 0.0;                              ///< The beam's centre is on it [s of data time].
  double range = 0.0;                             ///< Without error [m].
  double azimuth = 0.0;                           ///< Without error [rad].
  double range_error = 0.0;                       ///< Of the measurement, as the next [m].
  double azimuth_error = 0.0;                     ///< [rad]
  std::array<std::optional<Code>, kModes> codes;  ///< Nothing: it does not reply in that mode.
  std::int64_t first_interrogation = 0;
  std::vector<bool> received;  ///< A reply to that interrogation would be received, from the first one on.
  bool is_used = false;        ///< It belongs to a plot, or was too little for one.

  std::int64_t endOfInterrogations() const { return first_interrogation + static_cast<std::int64_t>(received.size()); }
  /// The reply to an interrogation in that mode; nothing: there is none.
  std::optional<Code> reply(std::int64_t interrogation, Mode mode) const;
};

/// Aircraft whose replies look like those of one, and all that may garble them; the earliest comes first.
struct ReplyGroup {
  std::vector<const Illumination*> members;  ///< Not empty.
  std::vector<const Illumination*> others;   ///< Within the garble region of the first member.
};

/// All members' reply to one interrogation as the extractor decodes it; nothing: none replied.
std::optional<DecodedReply> decodeReply(const ReplyGroup& group, std::int64_t interrogation, Mode mode);

/// Takes the group of the first unused illumination, and marks its members as used. Members are within
/// kReplyResolution in range and `azimuth_cell` [rad] of the first one, others within kGarbleRange of it.
/// Nothing when no unused one comes before `until`.
std::optional<ReplyGroup> takeGroup(std::deque<Illumination>& illuminations, double until, double azimuth_cell);

}  // namespace radar_sim
