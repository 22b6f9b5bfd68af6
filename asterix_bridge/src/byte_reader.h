#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace asterix_bridge {

/// Bytes of somebody else's buffer, which must outlive this.
struct Bytes {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;
};

/// Why bytes cannot be read as ASTERIX, and where.
class DecodeError : public std::runtime_error {
 public:
  /// `offset` in bytes from the start of what was being read.
  DecodeError(std::size_t offset, const std::string& reason) : std::runtime_error(reason), offset_(offset) {}
  std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// Reads numbers, most significant byte first, and never beyond its buffer: what is not there throws DecodeError.
class ByteReader {
 public:
  /// `offset` is where the bytes stand in the whole, for errors.
  explicit ByteReader(Bytes bytes, std::size_t offset = 0) : bytes_(bytes), offset_(offset) {}

  std::size_t remaining() const { return bytes_.size - position_; }
  /// In the whole.
  std::size_t offset() const { return offset_ + position_; }

  std::uint8_t u8() { return *take(1).data; }
  std::uint16_t u16() { return static_cast<std::uint16_t>(bigEndian(take(2))); }
  std::uint32_t u24() { return static_cast<std::uint32_t>(bigEndian(take(3))); }
  std::uint32_t u32() { return static_cast<std::uint32_t>(bigEndian(take(4))); }
  std::uint64_t u48() { return bigEndian(take(6)); }
  std::int8_t i8() { return static_cast<std::int8_t>(u8()); }
  std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
  std::int32_t i24() { return static_cast<std::int32_t>(u24() << 8) >> 8; }

  Bytes take(std::size_t count) {
    if (count > remaining())
      throw DecodeError(offset(),
                        "needs " + std::to_string(count) + " bytes, " + std::to_string(remaining()) + " are left");
    const Bytes taken{bytes_.data + position_, count};
    position_ += count;
    return taken;
  }

 private:
  static std::uint64_t bigEndian(Bytes bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size; ++i) value = value << 8 | bytes.data[i];
    return value;
  }

  Bytes bytes_;
  std::size_t offset_;
  std::size_t position_ = 0;
};

}  // namespace asterix_bridge
