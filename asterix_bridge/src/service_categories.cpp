// CAT002, edition 1.2, and CAT034, edition 1.29: monoradar service messages.
#include <tws_core/angles.h>
#include <tws_core/units.h>

#include "profiles.h"

namespace asterix_bridge {
namespace {

void source(ByteReader& octets, ServiceMessage& message) {
  const std::uint8_t sac = octets.u8();
  message.source = SourceId{sac, octets.u8()};
}

void messageType(ByteReader& octets, ServiceMessage& message) { message.type = octets.u8(); }

// The eight most significant bits of the antenna's azimuth.
void sector(ByteReader& octets, ServiceMessage& message) {
  message.sector_azimuth = octets.u8() * (tws::kTwoPi / 256.0);
}

void timeOfDay(ByteReader& octets, ServiceMessage& message) { message.time_of_day = octets.u24() / 128.0; }
void antennaPeriod(ByteReader& octets, ServiceMessage& message) { message.antenna_period = octets.u16() / 128.0; }

// I034/050, subfield COM: NOGO is the first bit.
void commonStatus(ByteReader& octets, ServiceMessage& message) { message.is_operational = !(octets.u8() & 0x80u); }

// I034/120: height 1 m, latitude and longitude 180°/2^23.
void position(ByteReader& octets, ServiceMessage& message) {
  constexpr double kUnit = tws::kPi / 8388608.0;
  tws::Geodetic place;
  place.altitude = octets.i16();
  place.latitude = octets.i24() * kUnit;
  place.longitude = octets.i24() * kUnit;
  if (place.latitude < -tws::kPi / 2.0 || place.latitude > tws::kPi / 2.0)
    throw DecodeError(octets.offset(), "latitude " + std::to_string(tws::degrees(place.latitude)) + " degrees");
  message.position = place;
}

using I = Item<ServiceMessage>;
constexpr I kSpare{};

constexpr I kItems002[] = {
    {"I002/010", Format::kFixed, 2, source},
    {"I002/000", Format::kFixed, 1, messageType},
    {"I002/020", Format::kFixed, 1, sector},
    {"I002/030", Format::kFixed, 3, timeOfDay},
    {"I002/041", Format::kFixed, 2, antennaPeriod},
    {"I002/050", Format::kExtended},
    {"I002/060", Format::kExtended},
    {"I002/070", Format::kRepetitive, 2},
    {"I002/100", Format::kFixed, 8},
    {"I002/090", Format::kFixed, 2},
    {"I002/080", Format::kExtended},
    kSpare,
    {"I002/SP", Format::kExplicit},
    {"I002/RFS", Format::kRandom},
};

constexpr I kStatus[] = {{"COM", Format::kFixed, 1, commonStatus},
                         kSpare,
                         kSpare,
                         {"PSR", Format::kFixed, 1},
                         {"SSR", Format::kFixed, 1},
                         {"MDS", Format::kFixed, 2}};
constexpr I kProcessing[] = {
    {"COM", Format::kFixed, 1}, kSpare, kSpare, {"PSR", Format::kFixed, 1}, {"SSR", Format::kFixed, 1},
    {"MDS", Format::kFixed, 1}};

constexpr I kItems034[] = {
    {"I034/010", Format::kFixed, 2, source},
    {"I034/000", Format::kFixed, 1, messageType},
    {"I034/030", Format::kFixed, 3, timeOfDay},
    {"I034/020", Format::kFixed, 1, sector},
    {"I034/041", Format::kFixed, 2, antennaPeriod},
    {"I034/050", Format::kCompound, 0, nullptr, kStatus, std::size(kStatus)},
    {"I034/060", Format::kCompound, 0, nullptr, kProcessing, std::size(kProcessing)},
    {"I034/070", Format::kRepetitive, 2},
    {"I034/100", Format::kFixed, 8},
    {"I034/110", Format::kFixed, 1},
    {"I034/120", Format::kFixed, 8, position},
    {"I034/090", Format::kFixed, 2},
    {"I034/RE", Format::kExplicit},
    {"I034/SP", Format::kExplicit},
};

}  // namespace

Uap<ServiceMessage> cat002() { return {kItems002, std::size(kItems002)}; }
Uap<ServiceMessage> cat034() { return {kItems034, std::size(kItems034)}; }

}  // namespace asterix_bridge
