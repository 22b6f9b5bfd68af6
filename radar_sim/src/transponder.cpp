#include "transponder.h"

#include <algorithm>
#include <random>

#include "mode_c.h"
#include "random_stream.h"

namespace radar_sim {
namespace {

int drawCode(Mode mode, RandomStream& random) {
  if (mode == Mode::k3A) return std::uniform_int_distribution<>(00001, 06777)(random);
  const int code = std::uniform_int_distribution<>(0, kAllPulses)(random);
  return mode == Mode::k1 ? code & kMode1Pulses : code;
}

}  // namespace

std::optional<Code> Transponder::reply(Mode mode, double height) const {
  if (mode == Mode::kC) return altitude ? modeCCode(height) : std::nullopt;
  const int code = codes[index(mode)];
  return code >= 0 ? std::optional<Code>(static_cast<Code>(code)) : std::nullopt;
}

bool Transponder::isSilentAt(double time) const {
  const auto covers = [time](const TimeSpan& span) { return time >= span.start && time < span.end; };
  return std::any_of(silences.begin(), silences.end(), covers);
}

Transponder drawCodes(Transponder transponder, std::uint64_t seed, const std::string& target) {
  RandomStream random(seed, target + "/codes");
  for (const Mode mode : {Mode::k1, Mode::k2, Mode::k3A}) {
    const int drawn = drawCode(mode, random);
    int& code = transponder.codes[index(mode)];
    if (code == Transponder::kDrawn) code = drawn;
  }
  return transponder;
}

Transponder drawTransponder(const TransponderShares& shares, std::uint64_t seed, const std::string& target) {
  RandomStream random(seed, target + "/transponder");
  std::uniform_real_distribution<> share(0.0, 1.0);
  const bool replies = share(random) < shares.fraction;
  const bool is_military = share(random) < shares.military_fraction;
  Transponder transponder;
  if (!replies) return transponder;
  transponder.codes[index(Mode::k3A)] = Transponder::kDrawn;
  transponder.altitude = true;
  if (is_military) transponder.codes[index(Mode::k1)] = transponder.codes[index(Mode::k2)] = Transponder::kDrawn;
  return drawCodes(transponder, seed, target);
}

}  // namespace radar_sim
