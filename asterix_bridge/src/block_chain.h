#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "framing.h"

namespace asterix_bridge {

/// Data blocks one behind the other, each with so many bytes of the recorder's before and behind it.
class BlockChain : public BlockFinder {
 public:
  /// Raw, recorder or timed. `offset` is where the bytes stand in the recording.
  BlockChain(Bytes bytes, Framing framing, std::size_t offset = 0);

  std::optional<FramingStep> next() override;

  /// How well the bytes are blocks in this framing, by the first of them (at most `most`).
  struct Fit {
    std::size_t good = 0;  // of a category that is decoded, and without a fault
    std::size_t all = 0;   // whose lengths lead from one to the next
    bool ends = false;     // the last one ends with the bytes
  };
  Fit fit(std::size_t most) const { return fitFrom(position_, most); }

 private:
  // The length of the block there, with what is before and behind it; 0: it does not fit.
  std::size_t lengthAt(std::size_t position) const;
  Fit fitFrom(std::size_t position, std::size_t most) const;
  bool isGood(std::size_t position) const;
  bool isTrusted(std::size_t position) const;
  FramedBlock take();
  FramingFault passOver();

  Bytes bytes_;
  Framing framing_;
  std::size_t before_;
  std::size_t behind_;
  std::size_t offset_;
  std::size_t position_;
  std::set<std::uint8_t> seen_;  // categories
};

}  // namespace asterix_bridge
