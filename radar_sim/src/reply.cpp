#include "reply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace radar_sim {
namespace {

struct Pulse {
  Code bit;       ///< In the code; 0 for framing pulses.
  int intervals;  ///< After the first framing pulse.
};

constexpr std::array<Pulse, 14> kReplyPulses{{{0, 0},
                                              {00010, 1},
                                              {01000, 2},
                                              {00020, 3},
                                              {02000, 4},
                                              {00040, 5},
                                              {04000, 6},
                                              {00100, 8},
                                              {00001, 9},
                                              {00200, 10},
                                              {00002, 11},
                                              {00400, 12},
                                              {00004, 13},
                                              {0, 14}}};

/// The code with most votes, and how many.
std::pair<Code, long> winner(const std::map<Code, long>& votes) {
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  return *std::max_element(votes.begin(), votes.end(), fewer);
}

}  // namespace

Code overlaid(Code own, Code other, double delay) {
  Code read = own;
  for (const Pulse& theirs : kReplyPulses) {
    if (theirs.bit != 0 && (other & theirs.bit) == 0) continue;
    const double place = theirs.intervals * kPulseInterval + delay;
    for (const Pulse& ours : kReplyPulses)
      if (std::abs(ours.intervals * kPulseInterval - place) < kPulseWidth / 2.0)
        read = static_cast<Code>(read | ours.bit);
  }
  return read;
}

CodeReading readCode(const std::vector<DecodedReply>& replies, long needed) {
  std::map<Code, long> clean, all;
  long clean_count = 0;
  for (const DecodedReply& reply : replies) {
    ++all[reply.code];
    if (reply.garbled) continue;
    ++clean[reply.code];
    ++clean_count;
  }
  if (clean_count > 0) {
    const auto [code, votes] = winner(clean);
    if (votes >= needed) return {code, votes < clean_count};
  }
  if (all.empty() || static_cast<long>(replies.size()) < needed) return {};
  return {winner(all).first, true};
}

}  // namespace radar_sim
