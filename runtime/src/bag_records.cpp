#include "bag_records.h"

#include <algorithm>

namespace tws_runtime {
namespace {

constexpr std::size_t kLengthBytes = 4;
constexpr std::size_t kMostFieldBytes = 1000000;  // ros::Header takes no longer ones.
constexpr std::size_t kMostHeaderBytes = 2 * kMostFieldBytes;

/// The first field of some, without its length; `fields` is then what follows it.
std::string_view takeField(std::string_view& fields) {
  const std::string_view field = fields.substr(kLengthBytes, littleEndian(fields.substr(0, kLengthBytes)));
  fields.remove_prefix(kLengthBytes + field.size());
  return field;
}

}  // namespace

std::uint64_t littleEndian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte)
    number = number << 8U | static_cast<unsigned char>(*byte);
  return number;
}

void checkFields(std::string_view header, std::uint64_t at) {
  while (!header.empty()) {
    const std::uint64_t size =
        header.size() < kLengthBytes ? header.size() : littleEndian(header.substr(0, kLengthBytes));
    if (size > kMostFieldBytes || size + kLengthBytes > header.size())
      throw BagDamage(at, "a field of the header is longer than the header");
    if (takeField(header).find('=') == std::string_view::npos) throw BagDamage(at, "a field of the header has no name");
  }
}

std::optional<std::string_view> BagRecord::find(std::string_view name) const {
  std::optional<std::string_view> value;  // Of several, rosbag takes the last.
  for (std::string_view fields = header; !fields.empty();) {
    const std::string_view field = takeField(fields);
    const std::size_t equals = field.find('=');
    if (field.substr(0, equals) == name) value = field.substr(equals + 1);
  }
  return value;
}

std::uint64_t BagRecord::number(std::string_view name, std::size_t bytes) const {
  const auto value = find(name);
  if (!value || value->size() != bytes)
    fail("the field '" + std::string(name) + "' " + (value ? "has a wrong size" : "is missing"));
  return littleEndian(*value);
}

std::string_view BagRecord::word(std::string_view name) const {
  const auto value = find(name);
  if (!value || value->empty()) fail("the field '" + std::string(name) + "' is missing");
  if (!std::all_of(value->begin(), value->end(), [](char c) { return c > ' ' && c <= '~'; }))
    fail("the field '" + std::string(name) + "' is no name");
  return *value;
}

std::uint8_t BagRecord::kind() const { return static_cast<std::uint8_t>(number("op", 1)); }

void BagRecord::expect(Kind expected) const {
  if (kind() != expected)
    fail("a record of kind " + std::to_string(kind()) + " stands where one of kind " + std::to_string(expected) +
         " belongs");
}

BagRecord BagRecords::next() {
  BagRecord record;
  record.at = position_;
  const std::uint32_t size = length(record, "header");
  if (size > kMostHeaderBytes) record.fail("the header of the record is longer than any");
  record.header = take(size);
  checkFields(record.header, record.at);
  record.data_size = length(record, "data");
  record.data = position_;
  return record;
}

std::string BagRecords::data(const BagRecord& record) {
  position_ = record.data;
  return take(record.data_size);
}

std::uint32_t BagRecords::length(const BagRecord& record, const char* part) {
  const std::uint64_t left = size_ - std::min(size_, position_);
  const std::uint64_t bytes = left < kLengthBytes ? left : littleEndian(take(kLengthBytes));
  if (bytes + kLengthBytes > left) record.fail(std::string("the ") + part + " of the record is longer than " + what_);
  return static_cast<std::uint32_t>(bytes);
}

std::string BagRecords::take(std::uint64_t count) {
  std::string bytes(count, '\0');
  bytes_.seekg(static_cast<std::streamoff>(position_));
  if (!bytes_.read(bytes.data(), static_cast<std::streamsize>(count))) throw BagDamage(position_, "cannot be read");
  position_ += count;
  return bytes;
}

}  // namespace tws_runtime
