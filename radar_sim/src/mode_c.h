#pragma once

#include <cstdint>
#include <optional>

namespace radar_sim {

/// The reply code of a pressure altitude [m], to the nearest 100 ft, in pulses (see transponder.h). Nothing outside
/// -1000 .. 126 700 ft, which have no code. ICAO Annex 10, volume IV, appendix to chapter 3: D2 to B4 count steps of
/// 500 ft in Gray code, C1 to C4 steps of 100 ft within them in a code of five that turns round at every other step.
std::optional<std::uint16_t> modeCCode(double height);

/// The pressure altitude that such a code means [m]; nothing for a code that means none.
std::optional<double> modeCHeight(std::uint16_t code);

}  // namespace radar_sim
