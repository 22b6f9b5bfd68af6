#pragma once

#include "block_test_helpers.h"
#include "framing.h"

namespace asterix_bridge {

/// What a recording holds: the blocks' offsets and bytes, and the faults.
struct Found {
  std::vector<FramedBlock> blocks;
  std::vector<Octets> contents;
  std::vector<FramingFault> faults;
};

inline Found findAll(const Octets& recording, Framing framing) {
  Found found;
  const auto finder = findBlocks(bytesOf(recording), framing);
  while (const auto step = finder->next()) {
    if (step->fault) found.faults.push_back(*step->fault);
    if (!step->block) continue;
    found.blocks.push_back(*step->block);
    const Bytes bytes = step->block->bytes;
    found.contents.emplace_back(bytes.data, bytes.data + bytes.size);
  }
  return found;
}

/// The block behind the recorder's way: its trailer ends with the time of day [1/128 s] and one more byte.
inline Octets recorded(const Octets& block, std::uint32_t time) {
  return block + Octets(6, 0) +
         Octets{static_cast<std::uint8_t>(time >> 16), static_cast<std::uint8_t>(time >> 8),
                static_cast<std::uint8_t>(time), 0};
}

/// Length, these six bytes included, time of day [ms], block.
inline Octets timed(const Octets& block, std::uint32_t ms) {
  const std::size_t length = block.size() + 6;
  return Octets{static_cast<std::uint8_t>(length >> 8), static_cast<std::uint8_t>(length),
                static_cast<std::uint8_t>(ms >> 24),    static_cast<std::uint8_t>(ms >> 16),
                static_cast<std::uint8_t>(ms >> 8),     static_cast<std::uint8_t>(ms)} +
         block;
}

}  // namespace asterix_bridge
