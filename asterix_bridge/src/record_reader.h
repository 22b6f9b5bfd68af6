#pragma once

#include <string>

#include "uap.h"

namespace asterix_bridge {

/// Reads one record, FSPEC and items, into `record`. Throws DecodeError that names the item, with the offset where it
/// begins.
template <class Record>
class RecordReader {
 public:
  RecordReader(ByteReader& reader, Uap<Record> uap, Record& record) : reader_(reader), uap_(uap), record_(record) {}

  void read() {
    const std::size_t start = reader_.offset();
    const Bytes fspec = flags();
    bool is_empty = true;
    for (std::size_t i = 0; i < fspec.size; ++i)
      for (unsigned bit = 0; bit < 7; ++bit)
        if (fspec.data[i] & (0x80u >> bit)) {
          readItem(7 * i + bit);
          is_empty = false;
        }
    if (is_empty) throw DecodeError(start, "a record without items");
  }

 private:
  // So long no item of a radar is: bytes that say so are something else.
  static constexpr std::size_t kMostOctets = 128;

  // Octets up to the first one whose last bit is not set.
  std::size_t extent() const {
    ByteReader ahead = reader_;
    std::size_t count = 1;
    while (ahead.u8() & 1u)
      if (++count > kMostOctets) throw DecodeError(reader_.offset(), "does not end within 128 octets");
    return count;
  }
  Bytes flags() { return reader_.take(extent()); }

  void readItem(std::size_t place) {
    if (place >= uap_.count || uap_.items[place].format == Format::kSpare)
      throw DecodeError(reader_.offset(), "no item has the field reference number " + std::to_string(place + 1));
    readItem(uap_.items[place]);
  }

  void readItem(const Item<Record>& item) {
    const std::size_t start = reader_.offset();
    try {
      if (item.format == Format::kCompound) return readParts(item);
      if (item.format == Format::kRandom) return readRandom();
      const Bytes octets = reader_.take(lengthOf(item));
      if (!item.decode) return;
      ByteReader inside(octets, start);
      item.decode(inside, record_);
    } catch (const DecodeError& error) {
      throw DecodeError(start, std::string(item.name) + ": " + error.what());
    }
  }

  std::size_t lengthOf(const Item<Record>& item) const {
    ByteReader ahead = reader_;
    switch (item.format) {
      case Format::kExtended:
        return extent();
      case Format::kRepetitive:
        return 1u + static_cast<std::size_t>(ahead.u8()) * item.length;
      case Format::kExplicit: {
        const std::size_t length = ahead.u8();
        if (length == 0) throw DecodeError(reader_.offset(), "says that it is 0 bytes long");
        return length;
      }
      default:
        return item.length;
    }
  }

  void readParts(const Item<Record>& item) {
    const Bytes present = flags();
    for (std::size_t place = 0; place < 7 * present.size; ++place) {
      if (!(present.data[place / 7] & (0x80u >> place % 7))) continue;
      if (place >= item.part_count || item.parts[place].format == Format::kSpare)
        throw DecodeError(reader_.offset(), "no subfield " + std::to_string(place + 1));
      readItem(item.parts[place]);
    }
  }

  void readRandom() {
    const unsigned count = reader_.u8();
    if (count > uap_.count) throw DecodeError(reader_.offset(), std::to_string(count) + " fields in random order");
    for (unsigned i = 0; i < count; ++i) {
      const std::size_t number = reader_.u8();
      if (number == 0 || (number <= uap_.count && uap_.items[number - 1].format == Format::kRandom))
        throw DecodeError(reader_.offset(), "field reference number " + std::to_string(number) + " inside");
      readItem(number - 1);
    }
  }

  ByteReader& reader_;
  Uap<Record> uap_;
  Record& record_;
};

}  // namespace asterix_bridge
