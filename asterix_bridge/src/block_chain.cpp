#include "block_chain.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>

namespace asterix_bridge {
namespace {

constexpr std::size_t kBlockHeader = 3;
constexpr std::size_t kAffordedPerByte = 16;

bool isDecoded(std::uint8_t category) { return category == 1 || category == 2 || category == 34 || category == 48; }

std::size_t big16(const std::uint8_t* bytes) { return bytes[0] * 256u + bytes[1]; }

// "01.01.2024 10:00:00" at the beginning of an RFF file, since 1970 [s].
std::optional<double> startOfRff(Bytes bytes) {
  constexpr std::size_t kLength = 19;
  if (bytes.size < kLength) return std::nullopt;
  const std::string text(reinterpret_cast<const char*>(bytes.data), kLength);
  std::tm date{};
  if (std::sscanf(text.c_str(), "%2d.%2d.%4d %2d:%2d:%2d", &date.tm_mday, &date.tm_mon, &date.tm_year, &date.tm_hour,
                  &date.tm_min, &date.tm_sec) != 6)
    return std::nullopt;
  date.tm_mon -= 1;
  date.tm_year -= 1900;
  const std::time_t time = timegm(&date);
  if (time < 0) return std::nullopt;
  return static_cast<double>(time);
}

}  // namespace

BlockChain::Shape BlockChain::shapeOf(Framing framing) {
  switch (framing) {
    case Framing::kRecorder:
      return {2200, 0, 10};
    case Framing::kTimed:
      return {0, 6, 0};
    case Framing::kRff:
      return {128, 6, 0};
    case Framing::kFinal:
      return {0, 8, 4};
    default:
      return {0, 0, 0};
  }
}

BlockChain::BlockChain(Bytes bytes, Framing framing, std::size_t offset)
    : bytes_(bytes),
      framing_(framing),
      shape_(shapeOf(framing)),
      offset_(offset),
      position_(std::min(shape_.header, bytes.size)),
      start_(framing == Framing::kRff ? startOfRff(bytes) : std::nullopt) {}

std::size_t BlockChain::lengthAt(std::size_t position) const {
  const std::size_t left = bytes_.size - position;
  if (left < shape_.before + kBlockHeader + shape_.behind) return 0;
  const std::uint8_t* header = bytes_.data + position + shape_.before;
  const std::size_t block = big16(header + 1);
  const std::size_t length = shape_.before + block + shape_.behind;
  if (header[0] == 0 || block <= kBlockHeader || length > left || !isFramed(position, block)) return 0;
  return length;
}

// What stands around the block says the same length.
bool BlockChain::isFramed(std::size_t position, std::size_t block) const {
  const std::uint8_t* before = bytes_.data + position;
  const std::uint8_t* behind = before + shape_.before + block;
  switch (framing_) {
    case Framing::kTimed:
      return big16(before) == shape_.before + block;
    case Framing::kRff:
      return before[4] + before[5] * 256u == block;
    case Framing::kFinal:
      return big16(before) == shape_.before + block + shape_.behind &&
             std::all_of(behind, behind + shape_.behind, [](std::uint8_t byte) { return byte == 0xA5; });
    default:
      return true;
  }
}

bool BlockChain::leadsToTheEndFrom(std::size_t position, std::size_t most) const {
  std::size_t blocks = 0;
  for (; blocks < most && position < bytes_.size; ++blocks) {
    const std::size_t length = lengthAt(position);
    if (length == 0) return false;
    position += length;
  }
  return blocks > 0 && position == bytes_.size;
}

// Any two bytes are a length. Only the records behind it show that it is one.
bool BlockChain::isGood(std::size_t position) {
  const std::size_t length = lengthAt(position);
  if (length == 0 || !isDecoded(categoryAt(position))) return false;
  decodeBeginning({bytes_.data + position + shape_.before, length - shape_.before - shape_.behind}, kMostLookedAt,
                  looked_at_);
  return !looked_at_.fault;
}

// Where anything may stand, the first record must say its radar, too.
bool BlockChain::isStart(std::size_t position) {
  if (!isGood(position)) return false;
  const bool says_radar = looked_at_.reports.empty() ? looked_at_.messages.front().source.has_value()
                                                     : looked_at_.reports.front().source.has_value();
  return says_radar && isGoodToItsEnd(position);
}

bool BlockChain::isGoodToItsEnd(std::size_t position) {
  const std::size_t length = lengthAt(position);
  if (length <= kMostLookedAt) return true;
  if (length > affordable_) return false;
  affordable_ -= length;
  decodeBlock({bytes_.data + position + shape_.before, length - shape_.before - shape_.behind}, 0, looked_at_);
  return !looked_at_.fault;
}

// A block with a bad record, or of another category, is believed when what follows is good, or of a category that has
// come before, or when the lengths lead to the very end.
bool BlockChain::isTrusted(std::size_t position) {
  constexpr std::size_t kFew = 8;
  const std::size_t length = lengthAt(position);
  if (length == 0) return false;
  const std::size_t behind = position + length;
  if (behind == bytes_.size || (seen_.empty() ? isStart(position) : isGood(position)) || isGood(behind)) return true;
  if (lengthAt(behind) > 0 && seen_.count(categoryAt(behind)) > 0) return true;
  return isOneOfARow(position) || leadsToTheEndFrom(position, kFew);
}

// Four blocks of one category one behind the other are none by chance.
bool BlockChain::isOneOfARow(std::size_t position) const {
  constexpr int kRow = 4;
  const std::uint8_t category = categoryAt(position);
  for (int i = 0; i < kRow; ++i) {
    const std::size_t length = position < bytes_.size ? lengthAt(position) : 0;
    if (length == 0 || isDecoded(category) || categoryAt(position) != category) return false;
    position += length;
  }
  return true;
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

// When the block was received.
void BlockChain::stamp(FramedBlock& block) const {
  const std::uint8_t* before = block.bytes.data - shape_.before;
  ByteReader behind(Bytes{block.bytes.data + block.bytes.size, shape_.behind});
  if (framing_ == Framing::kRecorder) {
    behind.take(6);
    block.time_of_day = behind.u24() / 128.0;
  } else if (framing_ == Framing::kTimed) {
    block.time_of_day = ByteReader(Bytes{before + 2, 4}).u32() / 1000.0;
  } else if (framing_ == Framing::kFinal) {
    block.time_of_day = ByteReader(Bytes{before + 5, 3}).u24() / 100.0;
  } else if (framing_ == Framing::kRff && start_) {
    block.time = *start_ + ByteReader(Bytes{before, 4}).u32() / 1000.0;
  }
}

FramedBlock BlockChain::take() {
  FramedBlock block;
  const std::size_t length = lengthAt(position_);
  block.bytes = {bytes_.data + position_ + shape_.before, length - shape_.before - shape_.behind};
  block.offset = offset_ + position_ + shape_.before;
  stamp(block);
  seen_.insert(block.bytes.data[0]);
  position_ += length;
  return block;
}

// To the next good block.
FramingFault BlockChain::passOver() {
  const std::size_t start = position_;
  const bool fits = lengthAt(start) > 0;
  while (++position_ < bytes_.size && !isStart(position_)) affordable_ += kAffordedPerByte;
  const std::string passed = std::to_string(position_ - start) + " bytes passed over";
  return {offset_ + start, (fits ? "what follows this block is none: " : "no data block fits here: ") + passed};
}

}  // namespace asterix_bridge
