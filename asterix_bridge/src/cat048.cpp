// CAT048, monoradar target reports: edition 1.32.
#include <tws_core/units.h>

#include "profiles.h"
#include "target_items.h"

namespace asterix_bridge {
namespace {

namespace t = target_items;

void timeOfDay(ByteReader& octets, TargetReport& report) { report.time_of_day = octets.u24() / 128.0; }

// I048/020. TYP: 0 none, 1 PSR, 2 SSR, 3 both, 4 and 5 Mode S, 6 and 7 Mode S and PSR.
void descriptor(ByteReader& octets, TargetReport& report) {
  const std::uint8_t first = octets.u8();
  report.type = first >> 5;
  report.mode_s = report.type >= 4;
  report.primary = report.type == 1 || report.type == 3 || report.type >= 6;
  report.secondary = report.type >= 2;
  report.simulated = first & 0x10u;
  report.special_identification = first & 0x04u;
  report.fixed_transponder = first & 0x02u;
  if (first & 1u) report.test_target = octets.u8() & 0x80u;
}

// A4 A2 A1 B2 B1: two octal digits.
void mode1(ByteReader& octets, TargetReport& report) {
  const std::uint8_t bits = octets.u8();
  report.mode_1.present = true;
  report.mode_1.validated = !(bits & 0x80u);
  report.mode_1.garbled = bits & 0x40u;
  report.mode_1.smoothed = bits & 0x20u;
  report.mode_1.value = static_cast<std::uint16_t>(((bits >> 2) & 7u) << 3 | (bits & 3u));
}

void height3d(ByteReader& octets, TargetReport& report) {
  const int steps = static_cast<int>((octets.u16() & 0x3FFFu) ^ 0x2000u) - 0x2000;
  report.height_3d = tws::metresFromFeet(25.0 * steps);
}

void calculatedDoppler(ByteReader& octets, TargetReport& report) {
  const std::uint16_t bits = octets.u16();
  if (bits & 0x8000u) return;  // doubtful
  report.range_rate = static_cast<int>((bits & 0x3FFu) ^ 0x200u) - 0x200;
}

void trackNumber(ByteReader& octets, TargetReport& report) {
  report.track_number = octets.u16() & 0x0FFFu;
  report.is_track = true;
}

void aircraftAddress(ByteReader& octets, TargetReport& report) { report.aircraft_address = octets.u24(); }

// Eight characters of six bits (ICAO Annex 10, volume IV, table 3-9): letters, digits and blank.
void callsign(ByteReader& octets, TargetReport& report) {
  const std::uint64_t bits = octets.u48();
  std::size_t length = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned code = (bits >> (42 - 6 * i)) & 0x3Fu;
    const bool letter = code >= 1 && code <= 26;
    const bool digit = code >= 48 && code <= 57;
    const char character = letter ? static_cast<char>('A' + code - 1) : digit ? static_cast<char>(code) : ' ';
    report.callsign[i] = character;
    if (character != ' ') length = i + 1;
  }
  report.callsign[length] = '\0';
}

constexpr double kRunLengthUnit = tws::radians(360.0 / 8192.0);

void ssrRunLength(ByteReader& octets, TargetReport& r) {
  r.characteristics.ssr_run_length = octets.u8() * kRunLengthUnit;
}
void ssrReplies(ByteReader& octets, TargetReport& r) { r.characteristics.ssr_replies = octets.u8(); }
void ssrAmplitude(ByteReader& octets, TargetReport& r) { r.characteristics.ssr_amplitude_dbm = octets.i8(); }
void primaryRunLength(ByteReader& octets, TargetReport& r) {
  r.characteristics.primary_run_length = octets.u8() * kRunLengthUnit;
}
void primaryAmplitude(ByteReader& octets, TargetReport& r) { r.characteristics.primary_amplitude_dbm = octets.i8(); }
void rangeDifference(ByteReader& octets, TargetReport& r) {
  r.characteristics.primary_less_ssr_range = octets.i8() * fromNauticalMiles(1.0 / 256.0);
}
void azimuthDifference(ByteReader& octets, TargetReport& r) {
  r.characteristics.primary_less_ssr_azimuth = octets.i8() * tws::radians(360.0 / 16384.0);
}

using I = Item<TargetReport>;
constexpr I kDoppler[] = {{"CAL", Format::kFixed, 2, calculatedDoppler}, {"RDS", Format::kRepetitive, 6}};
constexpr I kCharacteristics[] = {
    {"SRL", Format::kFixed, 1, ssrRunLength},     {"SRR", Format::kFixed, 1, ssrReplies},
    {"SAM", Format::kFixed, 1, ssrAmplitude},     {"PRL", Format::kFixed, 1, primaryRunLength},
    {"PAM", Format::kFixed, 1, primaryAmplitude}, {"RPD", Format::kFixed, 1, rangeDifference},
    {"APD", Format::kFixed, 1, azimuthDifference}};

constexpr I kItems[] = {
    {"I048/010", Format::kFixed, 2, t::source},
    {"I048/140", Format::kFixed, 3, timeOfDay},
    {"I048/020", Format::kExtended, 0, descriptor},
    {"I048/040", Format::kFixed, 4, t::polar256},
    {"I048/070", Format::kFixed, 2, t::mode3a},
    {"I048/090", Format::kFixed, 2, t::flightLevel},
    {"I048/130", Format::kCompound, 0, nullptr, kCharacteristics, std::size(kCharacteristics)},
    {"I048/220", Format::kFixed, 3, aircraftAddress},
    {"I048/240", Format::kFixed, 6, callsign},
    {"I048/250", Format::kRepetitive, 8},
    {"I048/161", Format::kFixed, 2, trackNumber},
    {"I048/042", Format::kFixed, 4, t::cartesian128},
    {"I048/200", Format::kFixed, 4, t::velocity},
    {"I048/170", Format::kExtended},
    {"I048/210", Format::kFixed, 4},
    {"I048/030", Format::kExtended},
    {"I048/080", Format::kFixed, 2},
    {"I048/100", Format::kFixed, 4},
    {"I048/110", Format::kFixed, 2, height3d},
    {"I048/120", Format::kCompound, 0, nullptr, kDoppler, std::size(kDoppler)},
    {"I048/230", Format::kFixed, 2},
    {"I048/260", Format::kFixed, 7},
    {"I048/055", Format::kFixed, 1, mode1},
    {"I048/050", Format::kFixed, 2, t::mode2},
    {"I048/065", Format::kFixed, 1},
    {"I048/060", Format::kFixed, 2},
    {"I048/SP", Format::kExplicit},
    {"I048/RE", Format::kExplicit},
};

}  // namespace

Uap<TargetReport> cat048() { return {kItems, std::size(kItems)}; }

}  // namespace asterix_bridge
