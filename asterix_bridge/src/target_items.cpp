#include "target_items.h"

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

void polar(ByteReader& octets, TargetReport& report, double unit) {
  report.range = octets.u16() * fromNauticalMiles(unit);
  report.azimuth = fromTurn16(octets.u16());
}

void cartesian(ByteReader& octets, TargetReport& report, double unit) {
  report.x = octets.i16() * fromNauticalMiles(unit);
  report.y = octets.i16() * fromNauticalMiles(unit);
}

ModeCode modeCode(ByteReader& octets) {
  const std::uint16_t bits = octets.u16();
  ModeCode code;
  code.present = true;
  code.validated = !(bits & 0x8000u);
  code.garbled = bits & 0x4000u;
  code.smoothed = bits & 0x2000u;
  code.value = bits & 0x0FFFu;
  return code;
}

}  // namespace

double fromNauticalMiles(double nautical_miles) { return tws::metresFromNauticalMiles(nautical_miles); }
double fromTurn16(std::uint16_t turns) { return turns * (tws::kTwoPi / 65536.0); }

namespace target_items {

void source(ByteReader& octets, TargetReport& report) {
  const std::uint8_t sac = octets.u8();
  report.source = SourceId{sac, octets.u8()};
}

void polar128(ByteReader& octets, TargetReport& report) { polar(octets, report, 1.0 / 128.0); }
void polar256(ByteReader& octets, TargetReport& report) { polar(octets, report, 1.0 / 256.0); }
void cartesian64(ByteReader& octets, TargetReport& report) { cartesian(octets, report, 1.0 / 64.0); }
void cartesian128(ByteReader& octets, TargetReport& report) { cartesian(octets, report, 1.0 / 128.0); }

void velocity(ByteReader& octets, TargetReport& report) {
  report.ground_speed = octets.u16() * fromNauticalMiles(1.0 / 16384.0);  // unit 2^-14 NM/s
  report.heading = fromTurn16(octets.u16());
}

void mode2(ByteReader& octets, TargetReport& report) { report.mode_2 = modeCode(octets); }
void mode3a(ByteReader& octets, TargetReport& report) { report.mode_3a = modeCode(octets); }

void flightLevel(ByteReader& octets, TargetReport& report) {
  const std::uint16_t bits = octets.u16();
  report.flight_level.present = true;
  report.flight_level.validated = !(bits & 0x8000u);
  report.flight_level.garbled = bits & 0x4000u;
  const int quarters = static_cast<int>((bits & 0x3FFFu) ^ 0x2000u) - 0x2000;  // 14 bits, two's complement
  report.flight_level.level_100ft = quarters / 4.0;
}

}  // namespace target_items
}  // namespace asterix_bridge
