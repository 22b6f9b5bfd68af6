#include "illumination.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {
namespace {

double delayOf(const Illumination& late, const Illumination& early) {
  return 2.0 * (late.range - early.range) / kSpeedOfLight;
}

}  // namespace

std::optional<Code> Illumination::reply(std::int64_t interrogation, Mode mode) const {
  if (interrogation < first_interrogation || interrogation >= endOfInterrogations()) return std::nullopt;
  return received[static_cast<std::size_t>(interrogation - first_interrogation)] ? codes[index(mode)] : std::nullopt;
}

std::optional<DecodedReply> decodeReply(const ReplyGroup& group, std::int64_t interrogation, Mode mode) {
  const Illumination* own = nullptr;
  DecodedReply decoded{0, false};
  const auto overlay = [&](const Illumination* other) {
    const std::optional<Code> code = other->reply(interrogation, mode);
    if (!code) return;
    decoded = own == nullptr ? DecodedReply{*code, false}
                             : DecodedReply{overlaid(decoded.code, *code, delayOf(*other, *own)), true};
    if (own == nullptr) own = other;
  };
  for (const Illumination* member : group.members) overlay(member);
  if (own == nullptr) return std::nullopt;
  for (const Illumination* other : group.others) overlay(other);
  return decoded;
}

std::optional<ReplyGroup> takeGroup(std::deque<Illumination>& illuminations, double until, double azimuth_cell) {
  const auto isUnused = [](const Illumination& it) { return !it.is_used; };
  const auto first = std::find_if(illuminations.begin(), illuminations.end(), isUnused);
  if (first == illuminations.end() || first->time >= until) return std::nullopt;
  ReplyGroup group;
  for (Illumination& it : illuminations) {
    const double apart = std::abs(it.range - first->range);
    const bool in_cell = std::abs(tws::angularDifference(it.azimuth, first->azimuth)) < azimuth_cell;
    if (!it.is_used && in_cell && apart < kReplyResolution) {
      it.is_used = true;
      group.members.push_back(&it);
    } else if (apart < kGarbleRange) {
      group.others.push_back(&it);
    }
  }
  return group;
}

}  // namespace radar_sim
