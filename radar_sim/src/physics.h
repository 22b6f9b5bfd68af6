#pragma once

namespace radar_sim {

constexpr double kSpeedOfLight = 299792458.0;           // [m/s]
constexpr double kNoiseDensity = 1.380649e-23 * 290.0;  // Boltzmann's constant times the standard temperature [W/Hz]

}  // namespace radar_sim
