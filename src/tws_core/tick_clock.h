#pragma once

#include <cstdint>
#include <optional>

#include <tws_core/quantisation.h>

namespace tws {

/// The report's clock: a 15-bit counter of 8 ms ticks that wraps every 262.144 s (NRL Report 7952, "Input Data Bank").
constexpr int kClockModulus = 32768;

/// a ⊖ b, the ticks from b to a the shorter way, in (-16384, 16384] ("Modulo Arithmetic"). Counts are 0..32767.
constexpr int moduloDifference(int a, int b) {
  const int forward = (a - b) & (kClockModulus - 1);
  return forward > kClockModulus / 2 ? forward - kClockModulus : forward;
}

/// a ⊕ b in 0..32767, for b of either sign.
constexpr int moduloSum(int a, int b) { return (a + b) & (kClockModulus - 1); }

/// What the counter shows `seconds` after it stood at zero: the whole ticks gone by, wrapped. Times of up to a year
/// keep countFromSeconds(n · 8 ms) == n mod 32768 in spite of rounding. Throws std::invalid_argument when not finite or
/// beyond ±1e9 s.
int countFromSeconds(double seconds);

/// Turns counts into time that does not wrap: seconds since the counter stood at zero before the first count.
/// Steps of either sign are taken the shorter way, so two counts in turn may lie up to 131 s apart.
class TickClock {
 public:
  /// Throws std::invalid_argument, and keeps its state, when the count is not in 0..32767.
  double seconds(int count);
  /// Forgets the past: the next count is the first one.
  void reset() { ticks_.reset(); }

 private:
  std::optional<std::int64_t> ticks_;
};

}  // namespace tws
