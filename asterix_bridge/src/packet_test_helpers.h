#pragma once

#include "framing_test_helpers.h"

namespace asterix_bridge {

const Octets kPlot = blockOf(1, plot001());  // 15 bytes

inline Octets big16(std::size_t value) {
  return {static_cast<std::uint8_t>(value >> 8), static_cast<std::uint8_t>(value)};
}
inline Octets little32(std::uint32_t value) {
  return {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 24)};
}
inline Octets big32(std::uint32_t value) { return big16(value >> 16) + big16(value & 0xFFFF); }

inline Octets udp(const Octets& payload) {
  return big16(8600) + big16(8600) + big16(payload.size() + 8) + big16(0) + payload;
}
inline Octets ipv4(const Octets& udp, std::uint8_t protocol = 17, std::size_t flags = 0x4000) {
  return Octets{0x45, 0} + big16(udp.size() + 20) + big16(0) + big16(flags) + Octets{64, protocol, 0, 0} +
         Octets{10, 0, 0, 1, 239, 1, 1, 1} + udp;
}
inline Octets ethernet(const Octets& ip, std::size_t type = 0x0800) { return Octets(12, 0) + big16(type) + ip; }

}  // namespace asterix_bridge
