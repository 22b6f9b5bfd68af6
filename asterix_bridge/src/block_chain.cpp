#include "block_chain.h"

#include <algorithm>

#include "block.h"

namespace asterix_bridge {
namespace {

constexpr std::size_t kRecorderHeader = 2200;
constexpr std::size_t kRecorderTrailer = 10;
constexpr std::size_t kTimedHeader = 6;
constexpr std::size_t kBlockHeader = 3;

bool isDecoded(std::uint8_t category) { return category == 1 || category == 2 || category == 34 || category == 48; }

}  // namespace

BlockChain::BlockChain(Bytes bytes, Framing framing, std::size_t offset)
    : bytes_(bytes),
      framing_(framing),
      before_(framing == Framing::kTimed ? kTimedHeader : 0),
      behind_(framing == Framing::kRecorder ? kRecorderTrailer : 0),
      offset_(offset),
      position_(framing == Framing::kRecorder ? std::min(kRecorderHeader, bytes.size) : 0) {}

std::size_t BlockChain::lengthAt(std::size_t position) const {
  const std::size_t left = bytes_.size - position;
  if (left < before_ + kBlockHeader + behind_) return 0;
  const std::uint8_t* header = bytes_.data + position + before_;
  const std::size_t block = header[1] * 256u + header[2];
  const std::size_t length = before_ + block + behind_;
  if (header[0] == 0 || block <= kBlockHeader || length > left) return 0;
  const std::uint8_t* prefix = bytes_.data + position;
  if (framing_ == Framing::kTimed && prefix[0] * 256u + prefix[1] != before_ + block) return 0;
  return length;
}

BlockChain::Fit BlockChain::fitFrom(std::size_t position, std::size_t most) const {
  Fit fit;
  while (fit.all < most && position < bytes_.size) {
    const std::size_t length = lengthAt(position);
    if (length == 0) return fit;
    if (isGood(position)) ++fit.good;
    position += length;
    ++fit.all;
  }
  fit.ends = position == bytes_.size && fit.all > 0;
  return fit;
}

// Any two bytes are a length. Only the records behind it show that it is one.
bool BlockChain::isGood(std::size_t position) const {
  const std::size_t length = lengthAt(position);
  if (length == 0 || !isDecoded(bytes_.data[position + before_])) return false;
  Block block;
  decodeBlock({bytes_.data + position + before_, length - before_ - behind_}, 0, block);
  return !block.fault;
}

// A block with a bad record, or of another category, is believed when what follows is good, or of a category that has
// come before, or when the lengths lead to the very end.
bool BlockChain::isTrusted(std::size_t position) const {
  constexpr std::size_t kFew = 8;
  const std::size_t length = lengthAt(position);
  if (length == 0) return false;
  const std::size_t behind = position + length;
  if (behind == bytes_.size || isGood(position) || isGood(behind)) return true;
  if (lengthAt(behind) > 0 && seen_.count(bytes_.data[behind + before_]) > 0) return true;
  return fitFrom(position, kFew).ends;
}

std::optional<FramingStep> BlockChain::next() {
  if (position_ >= bytes_.size) return std::nullopt;
  FramingStep step;
  if (isTrusted(position_))
    step.block = take();
  else
    step.fault = passOver();
  return step;
}

FramedBlock BlockChain::take() {
  FramedBlock block;
  const std::size_t length = lengthAt(position_);
  block.bytes = {bytes_.data + position_ + before_, length - before_ - behind_};
  block.offset = offset_ + position_ + before_;
  if (framing_ == Framing::kRecorder) {
    ByteReader trailer(Bytes{bytes_.data + position_ + length - 4, 3});
    block.time_of_day = trailer.u24() / 128.0;
  } else if (framing_ == Framing::kTimed) {
    ByteReader header(Bytes{bytes_.data + position_ + 2, 4});
    const double high = header.u16();
    block.time_of_day = (high * 65536.0 + header.u16()) / 1000.0;
  }
  seen_.insert(block.bytes.data[0]);
  position_ += length;
  return block;
}

// To the next good block.
FramingFault BlockChain::passOver() {
  const std::size_t start = position_;
  const bool fits = lengthAt(start) > 0;
  while (++position_ < bytes_.size && !isGood(position_)) continue;
  const std::string passed = std::to_string(position_ - start) + " bytes passed over";
  return {offset_ + start, (fits ? "what follows this block is none: " : "no data block fits here: ") + passed};
}

}  // namespace asterix_bridge
