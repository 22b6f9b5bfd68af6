#pragma once

#include "bag_records.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tws_runtime {

/// A message in a chunk.
struct ChunkMessage {
  std::uint32_t offset;      ///< Where its record begins in what the chunk holds.
  std::uint32_t connection;  ///< Whose it is.
  bool indexed = false;
};

/// The most that so many bytes of a bag may say they unpack to; rosbag makes room for what a chunk says.
std::uint64_t mostUnpacked(std::uint64_t bytes);

/// What a chunk holds, of its data; throws BagDamage when that is not as much as the chunk says, or more than the
/// above.
std::string unpackChunk(const BagRecord& chunk, std::string data);

/// The messages in what a chunk holds, by offset. Throws BagDamage when its records are not whole.
std::vector<ChunkMessage> messagesIn(const std::string& content);

}  // namespace tws_runtime
