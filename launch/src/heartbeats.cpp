#include "heartbeats.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "in_words.h"

namespace tws_launch {

void Heartbeats::heard(const std::string& name, double now) {
  Speaker& speaker = speakers_[name];
  if (speaker.words++ == 0) speaker.first = now;
  speaker.last = now;
}

std::string Heartbeats::silent(double now) const {
  constexpr double kGaps = 5.0;
  std::vector<std::string> silent;
  for (const auto& [name, speaker] : speakers_) {
    const double silence = now - speaker.last;
    if (silence < std::max(kShortest, kGaps * speaker.usualGap())) continue;
    silent.push_back(name + " for " + std::to_string(std::lround(silence)) + " s");
  }
  return joined(silent, ", ");
}

}  // namespace tws_launch
