#include "heartbeats.h"

#include <algorithm>
#include <cmath>

namespace tws_launch {

void Heartbeats::heard(const std::string& name, double now) {
  Speaker& speaker = speakers_[name];
  if (speaker.words++ == 0) speaker.first = now;
  speaker.last = now;
}

std::string Heartbeats::silent(double now) const {
  constexpr double kGaps = 5.0;
  std::string text;
  for (const auto& [name, speaker] : speakers_) {
    const double silence = now - speaker.last;
    if (silence < std::max(kShortest, kGaps * speaker.usualGap())) continue;
    text += (text.empty() ? "" : ", ") + name + " for " + std::to_string(std::lround(silence)) + " s";
  }
  return text;
}

}  // namespace tws_launch
