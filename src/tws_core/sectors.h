#pragma once

#include <stdexcept>

#include <tws_core/angles.h>

namespace tws {

/// The azimuth plane is cut into 64 equal sectors of 5.625° (NRL Report 7952, "Track-Number Assignment to
/// Azimuth-Sector Files"). Sector i covers [i, i+1)·5.625°, clockwise from true north; the report counts from 1, we
/// from 0.
constexpr int kSectors = 64;
constexpr int kHalfTurn = kSectors / 2;  // [sectors]
/// [rad]
constexpr double kSectorWidth = kTwoPi / kSectors;

/// Any integer to 0..63.
constexpr int wrapSector(int sector) { return sector & (kSectors - 1); }

/// Sectors from b to a the shorter way, in (-32, 32]. Takes any integers.
constexpr int sectorDifference(int a, int b) {
  const int forward = wrapSector(a - b);
  return forward > kHalfTurn ? forward - kSectors : forward;
}

/// Azimuth at which the beam enters the sector [rad], for 0..63; 64 gives 2π.
constexpr double sectorStart(int sector) { return sector * kSectorWidth; }

/// The sector 0..63 of an azimuth [rad], any number of turns; sectorOf(sectorStart(i)) == i.
/// Throws std::invalid_argument when the azimuth is not finite.
inline int sectorOf(double azimuth) {
  const double wrapped = wrapTwoPi(azimuth);
  if (!(wrapped >= 0.0)) throw std::invalid_argument("sectorOf: the azimuth is not finite");
  const int sector = static_cast<int>(wrapped * (kSectors / kTwoPi));
  // The product rounds up just below some borders, and never down at one: the tests try all 64, and it is monotonic
  // between.
  return wrapped < sectorStart(sector) ? sector - 1 : sector;
}

}  // namespace tws
