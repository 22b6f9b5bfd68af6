#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include <tws_core/geodesy.h>

namespace asterix_bridge {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Which radar: System Area Code and System Identification Code.
struct SourceId {
  std::uint8_t sac = 0;
  std::uint8_t sic = 0;
};
inline bool operator<(SourceId a, SourceId b) { return a.sac != b.sac ? a.sac < b.sac : a.sic < b.sic; }

/// A reply to an SSR interrogation, with its validity bits.
struct ModeCode {
  bool present = false;
  bool validated = false;   // V
  bool garbled = false;     // G
  bool smoothed = false;    // L: from the radar's own tracker, not from this reply
  std::uint16_t value = 0;  // octal digits as a number
};

struct FlightLevel {
  bool present = false;
  bool validated = false;
  bool garbled = false;
  double level_100ft = kUnknown;
};

/// Item 130 of CAT048. What was not sent is NaN.
struct PlotCharacteristics {
  double ssr_run_length = kUnknown;            // [rad]
  double ssr_replies = kUnknown;               // how many
  double ssr_amplitude_dbm = kUnknown;         // [dBm]
  double primary_run_length = kUnknown;        // [rad]
  double primary_amplitude_dbm = kUnknown;     // [dBm]
  double primary_less_ssr_range = kUnknown;    // [m], ±0.5 NM; the extremes stand for more
  double primary_less_ssr_azimuth = kUnknown;  // [rad], ±2.8°; the extremes stand for more
};

/// Where a report's time is from. Reports without a time of day of their own inherit one: of the report before them in
/// their block, else of their radar's latest mark, else that of reception.
enum class TimeFrom : std::uint8_t { kReport, kMark, kReception };

/// One plot or track of a radar: a record of CAT001 or CAT048. Unknown numbers are NaN.
struct TargetReport {
  std::uint8_t category = 0;
  std::optional<SourceId> source;
  bool is_track = false;                // CAT001: by its type; CAT048: it has a track number
  bool primary = false;                 // detected by the primary radar in this scan
  bool secondary = false;               // by the secondary radar
  bool mode_s = false;                  // by Mode S
  std::uint8_t type = 0;                // SSRPSR of I001/020, TYP of I048/020, as sent
  bool simulated = false;               // SIM
  bool test_target = false;             // TST
  bool special_identification = false;  // SPI
  bool fixed_transponder = false;       // RAB: a site monitor

  double time_of_day = kUnknown;   // UTC [s]; modulo 512 s if truncated
  bool is_time_truncated = false;  // I001/141
  TimeFrom time_from = TimeFrom::kReport;
  double range = kUnknown;               // slant range [m]
  double azimuth = kUnknown;             // clockwise from north [rad], [0, 2π)
  double x = kUnknown;                   // east [m], calculated by the radar
  double y = kUnknown;                   // north [m]
  double ground_speed = kUnknown;        // [m/s]
  double heading = kUnknown;             // clockwise from north [rad], [0, 2π)
  double range_rate = kUnknown;          // by Doppler, positive outbound as recommended [m/s]
  double height_3d = kUnknown;           // measured by a 3-D radar, above the sea [m]
  double received_power_dbm = kUnknown;  // I001/131 [dBm]

  ModeCode mode_1;
  ModeCode mode_2;
  ModeCode mode_3a;
  FlightLevel flight_level;
  std::optional<std::uint32_t> aircraft_address;  // 24 bits
  std::array<char, 9> callsign{};                 // ends with 0; without trailing blanks; empty: unknown
  std::optional<std::uint16_t> track_number;      // of a plot in CAT001: its plot number
  PlotCharacteristics characteristics;
  std::uint8_t raw_characteristics = 0;  // first octet of I001/130, whose meaning is the radar's own
};

/// Message types of CAT002 and CAT034 that are the same in both; others keep their number.
constexpr std::uint8_t kNorthMarker = 1;
constexpr std::uint8_t kSectorCrossing = 2;

/// One record of CAT002 or CAT034: where the antenna is, and how the radar does.
struct ServiceMessage {
  std::uint8_t category = 0;
  std::optional<SourceId> source;
  std::uint8_t type = 0;                  // 0: not said
  double time_of_day = kUnknown;          // UTC [s]
  double sector_azimuth = kUnknown;       // of the antenna as it enters the sector [rad]
  double antenna_period = kUnknown;       // [s]
  std::optional<tws::Geodetic> position;  // of the radar, WGS 84; I034/120
  std::optional<bool> is_operational;     // I034/050: false when its data shall be discarded
};

}  // namespace asterix_bridge
