#include "mode_c.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

constexpr int kLeastHundreds = -10;
constexpr int kGreatestHundreds = 1267;
// C4, C2, C1 as the code's digit C, for 200 ft below a whole 500 ft up to 200 ft above.
constexpr std::array<unsigned, 5> kHundreds{4, 6, 2, 3, 1};

// The Gray code's bits, greatest first, and which pulse of the code carries each: D2 D4 A1 A2 A4 B1 B2 B4.
constexpr std::array<unsigned, 8> kPulses{1u << 1, 1u << 2, 1u << 9, 1u << 10, 1u << 11, 1u << 6, 1u << 7, 1u << 8};
constexpr unsigned kDigitC = 070;
constexpr unsigned kPulseD1 = 1;

}  // namespace

std::optional<std::uint16_t> modeCCode(double height) {
  const double hundreds = std::round(tws::feetFromMetres(height) / 100.0);
  if (!(hundreds >= kLeastHundreds && hundreds <= kGreatestHundreds)) return std::nullopt;
  const int above_base = static_cast<int>(hundreds) + 12;  // steps of 100 ft from the code's beginning
  const auto five_hundreds = static_cast<unsigned>(above_base / 5);
  const auto within = static_cast<std::size_t>(above_base % 5);
  const unsigned gray = five_hundreds ^ (five_hundreds >> 1);
  unsigned code = kHundreds[five_hundreds % 2 == 0 ? within : 4 - within] << 3;
  for (std::size_t bit = 0; bit < kPulses.size(); ++bit)
    if ((gray >> (7 - bit)) & 1u) code |= kPulses[bit];
  return static_cast<std::uint16_t>(code);
}

std::optional<double> modeCHeight(std::uint16_t code) {
  const auto digit = std::find(kHundreds.begin(), kHundreds.end(), (code & kDigitC) >> 3);
  if (digit == kHundreds.end() || (code & kPulseD1) != 0) return std::nullopt;
  unsigned five_hundreds = 0;
  for (const unsigned pulse : kPulses)  // each bit of the number is the parity of the Gray code's bits down to it
    five_hundreds = five_hundreds << 1 | ((five_hundreds & 1u) ^ ((code & pulse) != 0 ? 1u : 0u));
  const auto within = static_cast<int>(digit - kHundreds.begin());
  const int hundreds = static_cast<int>(five_hundreds) * 5 + (five_hundreds % 2 == 0 ? within : 4 - within) - 12;
  if (hundreds < kLeastHundreds || hundreds > kGreatestHundreds) return std::nullopt;
  return tws::metresFromFeet(100.0 * hundreds);
}

}  // namespace radar_sim
