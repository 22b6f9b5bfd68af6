#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <tws_core/units.h>

#include "block.h"

namespace asterix_bridge {

constexpr double kDegree = tws::kRadiansPerDegree;

using Octets = std::vector<std::uint8_t>;

inline Bytes bytesOf(const Octets& octets) { return {octets.data(), octets.size()}; }

/// A data block around records: category and length in front.
inline Octets blockOf(std::uint8_t category, const Octets& records) {
  Octets block(records.size() + 3, category);
  block[1] = static_cast<std::uint8_t>(block.size() >> 8);
  block[2] = static_cast<std::uint8_t>(block.size());
  std::copy(records.begin(), records.end(), block.begin() + 3);
  return block;
}

inline Octets operator+(const Octets& a, const Octets& b) {
  Octets sum(a.size() + b.size());
  std::copy(b.begin(), b.end(), std::copy(a.begin(), a.end(), sum.begin()));
  return sum;
}

inline Block decoded(const Octets& octets, std::size_t offset = 0) {
  // A buffer of exactly this size, so that the address sanitizer sees any step outside.
  const Octets copy(octets.begin(), octets.end());
  Block block;
  decodeBlock(bytesOf(copy), offset, block);
  return block;
}

/// A CAT001 plot without a fault: radar 8/9, SSR, 64 NM, 90°, code 1234, 100 s.
inline Octets plot001() {
  return {0xF2,         // FSPEC: 010 020 040 070 - - 141
          0x08, 0x09,   // 010: SAC 8, SIC 9
          0x20,         // 020: plot, sole secondary
          0x20, 0x00,   // 040: rho 8192/128 = 64 NM
          0x40, 0x00,   //      theta 16384/65536 of a turn = 90 degrees
          0x02, 0x9C,   // 070: octal 1234
          0x32, 0x00};  // 141: 12800/128 = 100 s
}

}  // namespace asterix_bridge
