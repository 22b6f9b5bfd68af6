#pragma once

#include "byte_reader.h"
#include "reports.h"

namespace asterix_bridge {

/// Data items that CAT001 and CAT048 share. Each takes exactly the item's octets.
namespace target_items {

/// I001/010, I048/010.
void source(ByteReader& octets, TargetReport& report);
/// I001/040 (unit 1/128 NM) and I048/040 (1/256 NM): rho, theta.
void polar128(ByteReader& octets, TargetReport& report);
void polar256(ByteReader& octets, TargetReport& report);
/// I001/042 (unit 1/64 NM) and I048/042 (1/128 NM): x, y.
void cartesian64(ByteReader& octets, TargetReport& report);
void cartesian128(ByteReader& octets, TargetReport& report);
/// Item 200: ground speed and heading.
void velocity(ByteReader& octets, TargetReport& report);
/// Items 050 and 070: Mode 2 and Mode 3/A, 12 bits and V, G, L.
void mode2(ByteReader& octets, TargetReport& report);
void mode3a(ByteReader& octets, TargetReport& report);
/// Item 090.
void flightLevel(ByteReader& octets, TargetReport& report);

}  // namespace target_items

/// [m] from nautical miles, [rad] from 1/65536 of a turn.
double fromNauticalMiles(double nautical_miles);
double fromTurn16(std::uint16_t turns);

}  // namespace asterix_bridge
