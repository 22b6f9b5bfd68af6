#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace tws_runtime {

/// What is wrong with a bag, and where. Not for users: who opens the bag names the file.
struct BagDamage : std::runtime_error {
  BagDamage(std::uint64_t where, const std::string& what) : std::runtime_error(what), at(where) {}
  std::uint64_t at;  ///< The byte of the file.
};

/// One record of the bag format 2.0: a header of fields, then data. Numbers have their least significant byte first.
struct BagRecord {
  enum Kind : std::uint8_t { kMessage = 2, kFileHeader = 3, kIndex = 4, kChunk = 5, kChunkInfo = 6, kConnection = 7 };

  std::uint64_t at = 0;         ///< Its first byte.
  std::string header;           ///< Its fields are whole.
  std::uint64_t data = 0;       ///< Where its data begin.
  std::uint32_t data_size = 0;  ///< They are all there.

  /// The kind, "op" in the bag; throws BagDamage when it is another one.
  void expect(Kind kind) const;
  std::uint8_t kind() const;
  std::optional<std::string_view> find(std::string_view name) const;
  /// A number of that many bytes; throws BagDamage when the field is missing or has another size.
  std::uint64_t number(std::string_view name, std::size_t bytes) const;
  /// Printable, without spaces, not empty: a name; throws BagDamage.
  std::string_view word(std::string_view name) const;
  [[noreturn]] void fail(const std::string& what) const { throw BagDamage(at, what); }
};

/// The number in the first bytes of a text.
std::uint64_t littleEndian(std::string_view bytes);

/// Throws BagDamage unless the fields of a header fill it; `at` is where it is.
void checkFields(std::string_view header, std::uint64_t at);

/// Reads records out of a file, or out of what a chunk holds, and never beyond its end.
class BagRecords {
 public:
  /// `what` names it in complaints: a record is longer than WHAT.
  BagRecords(std::istream& bytes, std::uint64_t size, std::string what)
      : bytes_(bytes), size_(size), what_(std::move(what)) {}

  void seek(std::uint64_t position) { position_ = position; }
  std::uint64_t position() const { return position_; }
  bool atEnd() const { return position_ == size_; }
  /// The record that begins here; then the position is that of its data. Throws BagDamage.
  BagRecord next();
  /// The data of the record that was just read.
  std::string data(const BagRecord& record);
  void skipData(const BagRecord& record) { position_ = record.data + record.data_size; }

 private:
  std::uint32_t length(const BagRecord& record, const char* part);
  std::string take(std::uint64_t count);

  std::istream& bytes_;
  std::uint64_t size_;
  std::string what_;
  std::uint64_t position_ = 0;
};

}  // namespace tws_runtime
