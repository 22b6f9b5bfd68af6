#pragma once

#include <optional>
#include <string>
#include <vector>

#include "byte_reader.h"
#include "reports.h"

namespace asterix_bridge {

/// What went wrong, and where in the file or datagram.
struct BlockFault {
  std::size_t offset = 0;
  std::string reason;
};

/// What one data block holds. Only one of the lists has entries: a block has one category.
struct Block {
  int category = 0;
  std::vector<TargetReport> reports;
  std::vector<ServiceMessage> messages;
  std::optional<BlockFault> fault;  // the records before it are good; those behind it are lost
  bool is_unknown = false;          // the fault is a category that is not decoded here
};

/// Decodes one data block (category, length, records), which stands at `offset` in the whole. Never reads outside
/// `bytes`. `block` is filled anew; pass the same one again to save allocations.
void decodeBlock(Bytes bytes, std::size_t offset, Block& block);
/// The same for the records that begin in the first `most` bytes.
void decodeBeginning(Bytes bytes, std::size_t most, Block& block);

}  // namespace asterix_bridge
