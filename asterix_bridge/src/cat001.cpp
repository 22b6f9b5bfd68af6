// CAT001, monoradar target reports: edition 1.4.
#include "profiles.h"
#include "target_items.h"

namespace asterix_bridge {
namespace {

namespace t = target_items;

// I001/020
void descriptor(ByteReader& octets, TargetReport& report) {
  const std::uint8_t first = octets.u8();
  report.is_track = first & 0x80u;
  report.simulated = first & 0x40u;
  report.type = (first >> 4) & 3u;
  report.primary = report.type & 1u;
  report.secondary = report.type & 2u;
  report.special_identification = first & 0x04u;
  report.fixed_transponder = first & 0x02u;
  if (first & 1u) report.test_target = octets.u8() & 0x80u;
}

void plotCharacteristics(ByteReader& octets, TargetReport& report) { report.raw_characteristics = octets.u8() >> 1; }

// Unit 2^-8 NM/s: 14.0625 kn.
void dopplerSpeed(ByteReader& octets, TargetReport& report) {
  report.range_rate = octets.i8() * fromNauticalMiles(1.0 / 256.0);
}

void receivedPower(ByteReader& octets, TargetReport& report) { report.received_power_dbm = octets.i8(); }

void truncatedTime(ByteReader& octets, TargetReport& report) {
  report.time_of_day = octets.u16() / 128.0;
  report.is_time_truncated = true;
}

void trackNumber(ByteReader& octets, TargetReport& report) { report.track_number = octets.u16(); }

using I = Item<TargetReport>;
constexpr I k010{"I001/010", Format::kFixed, 2, t::source};
constexpr I k020{"I001/020", Format::kExtended, 0, descriptor};
constexpr I k030{"I001/030", Format::kExtended};
constexpr I k040{"I001/040", Format::kFixed, 4, t::polar128};
constexpr I k042{"I001/042", Format::kFixed, 4, t::cartesian64};
constexpr I k050{"I001/050", Format::kFixed, 2, t::mode2};
constexpr I k060{"I001/060", Format::kFixed, 2};
constexpr I k070{"I001/070", Format::kFixed, 2, t::mode3a};
constexpr I k080{"I001/080", Format::kFixed, 2};
constexpr I k090{"I001/090", Format::kFixed, 2, t::flightLevel};
constexpr I k100{"I001/100", Format::kFixed, 4};
constexpr I k120{"I001/120", Format::kFixed, 1, dopplerSpeed};
constexpr I k130{"I001/130", Format::kExtended, 0, plotCharacteristics};
constexpr I k131{"I001/131", Format::kFixed, 1, receivedPower};
constexpr I k141{"I001/141", Format::kFixed, 2, truncatedTime};
constexpr I k150{"I001/150", Format::kFixed, 1};
constexpr I k161{"I001/161", Format::kFixed, 2, trackNumber};
constexpr I k170{"I001/170", Format::kExtended};
constexpr I k200{"I001/200", Format::kFixed, 4, t::velocity};
constexpr I k210{"I001/210", Format::kExtended};
constexpr I kSp{"I001/SP", Format::kExplicit};
constexpr I kRfs{"I001/RFS", Format::kRandom};
constexpr I kSpare{};

constexpr I kPlots[] = {k010, k020, k040, k070, k090,   k130,   k141,   k050,   k120, k131, k080,
                        k100, k060, k030, k150, kSpare, kSpare, kSpare, kSpare, kSp,  kRfs};
constexpr I kTracks[] = {k010, k020, k161, k040, k042, k200, k070, k090, k141, k130, k131,
                         k120, k170, k210, k050, k080, k100, k060, k030, kSp,  kRfs, k150};

}  // namespace

Uap<TargetReport> cat001Plots() { return {kPlots, std::size(kPlots)}; }
Uap<TargetReport> cat001Tracks() { return {kTracks, std::size(kTracks)}; }

}  // namespace asterix_bridge
