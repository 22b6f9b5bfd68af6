#include "code_history.h"

#include <cmath>

namespace track_correlator {

void CodeHistory::take(const CodeReply& reply, int replies_to_change) {
  if (reply.code == kNoCode || reply.garbled) return;
  if (reply.code == value_) {
    rival_replies_ = 0;
    return;
  }
  rival_replies_ = reply.code == rival_ ? rival_replies_ + 1 : 1;
  rival_ = reply.code;
  if (value_ != kNoCode && rival_replies_ < replies_to_change) return;
  value_ = reply.code;
  rival_ = kNoCode;
  rival_replies_ = 0;
}

bool HeightHistory::reachable(const Sample& from, const Sample& to, double climb_limit) {
  constexpr double kStep = 30.48;  // Mode C comes in steps of 100 ft [m].
  return std::abs(to.height - from.height) <= climb_limit * std::abs(to.time - from.time) + kStep;
}

void HeightHistory::take(double height, bool garbled, double time, double climb_limit) {
  if (std::isnan(height) || garbled) return;
  const Sample sample{height, time};
  const bool accepted = std::isnan(held_.height) || reachable(held_, sample, climb_limit) ||
                        (!std::isnan(rival_.height) && reachable(rival_, sample, climb_limit));
  (accepted ? held_ : rival_) = sample;
  if (accepted) rival_ = Sample{};
}

}  // namespace track_correlator
