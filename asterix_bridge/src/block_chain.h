#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>

#include "block.h"
#include "framing.h"

namespace asterix_bridge {

/// Data blocks one behind the other, each with so many bytes of the recorder's before and behind it.
///
/// The work is linear in the bytes: to see whether a block begins at some byte costs its header, where that fits at
/// most kMostLookedAt bytes of its records, and all of them only as long as that comes to few bytes a byte.
class BlockChain : public BlockFinder {
 public:
  static constexpr std::size_t kMostLookedAt = 64;

  /// Raw, recorder, timed, RFF or final. `offset` is where the bytes stand in the recording.
  BlockChain(Bytes bytes, Framing framing, std::size_t offset = 0);

  std::optional<FramingStep> next() override;

  /// Whether lengths lead from block to block to the very end, by at most `most` of them.
  bool leadsToTheEnd(std::size_t most) const { return leadsToTheEndFrom(position_, most); }
  /// Where the walk is.
  std::size_t position() const { return position_; }

 private:
  // What a recorder puts around the blocks.
  struct Shape {
    std::size_t header;  // of the file
    std::size_t before;  // each block
    std::size_t behind;
  };
  static Shape shapeOf(Framing framing);

  // The length of the block there, with what is before and behind it; 0: it does not fit.
  std::size_t lengthAt(std::size_t position) const;
  bool isFramed(std::size_t position, std::size_t block) const;
  bool leadsToTheEndFrom(std::size_t position, std::size_t most) const;
  std::uint8_t categoryAt(std::size_t position) const { return bytes_.data[position + shape_.before]; }
  bool isGood(std::size_t position);
  bool isStart(std::size_t position);
  bool isGoodToItsEnd(std::size_t position);
  bool isTrusted(std::size_t position);
  bool isOneOfARow(std::size_t position) const;
  void stamp(FramedBlock& block) const;
  FramedBlock take();
  FramingFault passOver();

  Bytes bytes_;
  Framing framing_;
  Shape shape_;
  std::size_t offset_;
  std::size_t position_;
  std::optional<double> start_;       // of an RFF file, since 1970 [s]
  std::set<std::uint8_t> seen_;       // categories
  std::size_t affordable_ = 1 << 20;  // bytes of long blocks that may be decoded to look for a start
  Block looked_at_;
};

}  // namespace asterix_bridge
