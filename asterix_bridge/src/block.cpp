#include "block.h"

#include <cmath>

#include "profiles.h"
#include "record_reader.h"

namespace asterix_bridge {
namespace {

// Items 010 and 020 come first in both profiles of CAT001, and 020 says which profile it is: bit 8, TYP.
Uap<TargetReport> cat001For(ByteReader ahead) {
  const std::uint8_t fspec = ahead.u8();
  while (fspec & 1u && ahead.u8() & 1u) continue;
  if (!(fspec & 0x40u)) return cat001Plots();
  if (fspec & 0x80u) ahead.take(2);
  return ahead.u8() & 0x80u ? cat001Tracks() : cat001Plots();
}

// A record that does not say its radar is of the one before it in the block.
void inherit(TargetReport& report, const TargetReport& before) {
  if (!report.source) report.source = before.source;
  if (!std::isnan(report.time_of_day)) return;
  report.time_of_day = before.time_of_day;
  report.is_time_truncated = before.is_time_truncated;
}
void inherit(ServiceMessage& message, const ServiceMessage& before) {
  if (!message.source) message.source = before.source;
}

template <class Record, class Profile>
void readRecords(ByteReader& reader, std::size_t end, Block& block, std::vector<Record>& records,
                 const Profile& profile) {
  while (reader.remaining() > 0 && reader.offset() < end) {
    Record record;
    record.category = static_cast<std::uint8_t>(block.category);
    RecordReader<Record>(reader, profile(), record).read();
    if (!records.empty()) inherit(record, records.back());
    records.push_back(record);
  }
}

// The records that begin before `end`.
void readBody(ByteReader& reader, std::size_t end, Block& block) {
  switch (block.category) {
    case 1:
      return readRecords(reader, end, block, block.reports, [&] { return cat001For(reader); });
    case 2:
      return readRecords(reader, end, block, block.messages, cat002);
    case 34:
      return readRecords(reader, end, block, block.messages, cat034);
    case 48:
      return readRecords(reader, end, block, block.reports, cat048);
    default:
      block.is_unknown = true;
      throw DecodeError(reader.offset() - 3, "category " + std::to_string(block.category) + " is not decoded");
  }
}

void decode(Bytes bytes, std::size_t offset, std::size_t most, Block& block) {
  block.category = 0;
  block.reports.clear();
  block.messages.clear();
  block.fault.reset();
  block.is_unknown = false;
  try {
    ByteReader reader(bytes, offset);
    block.category = reader.u8();
    const std::size_t length = reader.u16();
    if (length != bytes.size)
      throw DecodeError(offset, "block of CAT" + std::to_string(block.category) + " says " + std::to_string(length) +
                                    " bytes, " + std::to_string(bytes.size) + " are there");
    if (reader.remaining() == 0) throw DecodeError(offset, "a block without records");
    readBody(reader, offset + most, block);
  } catch (const DecodeError& error) {
    block.fault = BlockFault{error.offset(), error.what()};
  }
}

}  // namespace

void decodeBlock(Bytes bytes, std::size_t offset, Block& block) { decode(bytes, offset, bytes.size, block); }
void decodeBeginning(Bytes bytes, std::size_t most, Block& block) { decode(bytes, 0, most, block); }

}  // namespace asterix_bridge
