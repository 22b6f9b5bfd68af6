#include "bag_check.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <vector>

#include "bag_chunk.h"

namespace tws_runtime {
namespace {

constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";

/// A chunk as the end of the bag describes it.
struct ChunkInfo {
  std::uint64_t at;                               ///< The description's own place.
  std::uint64_t position;                         ///< The chunk's.
  std::map<std::uint32_t, std::uint32_t> counts;  ///< Messages by connection.
};

class BagCheck {
 public:
  BagCheck(std::istream& file, std::uint64_t size) : records_(file, size, "the file"), left_(mostUnpacked(size)) {}

  /// What keeps rosbag from reading a bag that is whole; empty: nothing.
  std::string check() {
    records_.seek(kFirstLine.size());
    const BagRecord header = records_.next();
    header.expect(BagRecord::kFileHeader);
    if (const auto encryptor = header.find("encryptor"); encryptor && !encryptor->empty())
      return "is encrypted, which is not read here: `rosbag decrypt` makes a bag of it that is";
    const std::uint64_t index = header.number("index_pos", 8);
    if (index == 0) return "has no index, for its recording did not end well: `rosbag reindex` makes one";
    checkIndex(header, index);
    for (std::size_t i = 0; i < chunks_.size(); ++i)
      checkChunk(chunks_[i], i + 1 < chunks_.size() ? chunks_[i + 1].position : index);
    return "";
  }

 private:
  /// The end of the bag: its connections, then where its chunks are.
  void checkIndex(const BagRecord& header, std::uint64_t index) {
    const std::uint64_t connections = header.number("conn_count", 4), chunks = header.number("chunk_count", 4);
    records_.seek(index);
    for (std::uint64_t i = 0; i < connections; ++i) readConnection();
    for (std::uint64_t i = 0; i < chunks; ++i) readChunkInfo();
    if (!records_.atEnd()) header.fail("more follows than the connections and chunks that the header counts");
    std::sort(chunks_.begin(), chunks_.end(), [](const auto& a, const auto& b) { return a.position < b.position; });
  }

  void readConnection() {
    const BagRecord record = records_.next();
    record.expect(BagRecord::kConnection);
    (void)record.word("topic");
    connections_.insert(static_cast<std::uint32_t>(record.number("conn", 4)));
    if (record.data_size > kMostDescribed) record.fail("the connection's description is longer than any");
    BagRecord described = record;
    described.header = records_.data(record);
    checkFields(described.header, record.data);
    (void)described.word("type");
    (void)described.word("md5sum");
  }

  void readChunkInfo() {
    const BagRecord record = records_.next();
    record.expect(BagRecord::kChunkInfo);
    if (record.number("ver", 4) != 1) record.fail("this version of a chunk's description is not known");
    (void)record.number("start_time", 8);
    (void)record.number("end_time", 8);
    ChunkInfo info{record.at, record.number("chunk_pos", 8), {}};
    const std::string counts = elements(record, 2 * kNumber, connections_.size());
    for (std::string_view rest = counts; !rest.empty(); rest.remove_prefix(2 * kNumber))
      if (!info.counts.emplace(numberIn(rest, 0), numberIn(rest, 1)).second)
        record.fail("a chunk's description counts the messages of a connection twice");
    chunks_.push_back(std::move(info));
  }

  /// The chunk and the parts of the index that follow it, before `end`.
  void checkChunk(const ChunkInfo& info, std::uint64_t end) {
    records_.seek(info.position);
    const BagRecord chunk = records_.next();
    chunk.expect(BagRecord::kChunk);
    std::vector<ChunkMessage> messages = messagesOf(chunk);
    for (const auto& counted : info.counts) {
      (void)counted;
      checkEntries(info, messages);
    }
    if (records_.position() > end) throw BagDamage(info.at, "a chunk reaches into the next one or the end of the bag");
    if (!std::all_of(messages.begin(), messages.end(), [](const ChunkMessage& m) { return m.indexed; }))
      chunk.fail("a message in the chunk is not in the index");
  }

  std::vector<ChunkMessage> messagesOf(const BagRecord& chunk) {
    const std::uint64_t size = chunk.number("size", 4);
    if (size > left_) chunk.fail("the chunks say that they unpack to more than 2000 times the size of the file");
    left_ -= size;
    const std::string content = unpackChunk(chunk, records_.data(chunk));
    try {
      return messagesIn(content);
    } catch (const BagDamage& damage) {
      chunk.fail("byte " + std::to_string(damage.at) + " of what the chunk holds: " + damage.what());
    }
  }

  void checkEntries(const ChunkInfo& info, std::vector<ChunkMessage>& messages) {
    const BagRecord record = records_.next();
    record.expect(BagRecord::kIndex);
    if (record.number("ver", 4) != 1) record.fail("this version of an index is not known");
    const auto connection = static_cast<std::uint32_t>(record.number("conn", 4));
    const auto counted = info.counts.find(connection);
    if (connections_.count(connection) == 0 || counted == info.counts.end() ||
        record.number("count", 4) != counted->second)
      record.fail("the index counts other messages than the chunk's description");
    const std::string entries = elements(record, 3 * kNumber, messages.size());
    for (std::string_view rest = entries; !rest.empty(); rest.remove_prefix(3 * kNumber)) {
      if (numberIn(rest, 1) >= 1000000000) record.fail("a time in the index is none");
      if (!take(messages, numberIn(rest, 2), connection)) record.fail("the index names a message that is not there");
    }
  }

  /// Takes a message into the index; false: there is none, or it is there already.
  static bool take(std::vector<ChunkMessage>& messages, std::uint32_t offset, std::uint32_t connection) {
    const auto found = std::lower_bound(messages.begin(), messages.end(), offset,
                                        [](const ChunkMessage& m, std::uint32_t place) { return m.offset < place; });
    if (found == messages.end() || found->offset != offset || found->connection != connection || found->indexed)
      return false;
    return found->indexed = true;
  }

  /// The data of a record, as many elements of that size as it counts.
  std::string elements(const BagRecord& record, std::uint64_t size, std::uint64_t most) {
    const std::uint64_t count = record.number("count", 4);
    if (count > most || count * size != record.data_size) record.fail("the record counts more or less than there is");
    return records_.data(record);
  }

  static std::uint32_t numberIn(std::string_view bytes, std::size_t i) {
    return static_cast<std::uint32_t>(littleEndian(bytes.substr(i * kNumber, kNumber)));
  }

  static constexpr std::size_t kNumber = 4;                    // [bytes]
  static constexpr std::uint32_t kMostDescribed = 16U << 20U;  // [bytes]

  BagRecords records_;
  std::uint64_t left_;  // What chunks may still unpack to.
  std::set<std::uint32_t> connections_;
  std::vector<ChunkInfo> chunks_;  // In the order in which they stand in the file.
};

std::string firstLine(std::istream& file) {
  std::string line(kFirstLine.size(), '\0');
  file.read(line.data(), static_cast<std::streamsize>(line.size()));
  return line.substr(0, static_cast<std::size_t>(file.gcount()));
}

}  // namespace

void checkBag(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw std::runtime_error(path + ": is missing");
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, error)) file.open(path, std::ios::binary);
  if (!file.is_open()) throw std::runtime_error(path + ": cannot be read as a file");
  const std::string line = firstLine(file);
  if (line.rfind("#ROSBAG V1", 0) == 0)
    throw std::runtime_error(path + ": is a bag of an old format: `rosbag filter OLD NEW True` copies it into today's");
  if (line != kFirstLine) throw std::runtime_error(path + ": is no bag: it does not begin with #ROSBAG V2.0");
  file.clear();
  std::string obstacle;
  try {
    obstacle = BagCheck(file, std::filesystem::file_size(path)).check();
  } catch (const BagDamage& damage) {
    obstacle = "is damaged at byte " + std::to_string(damage.at) + ": " + damage.what() +
               "; `rosbag reindex` makes a bag of what can be read";
  }
  if (!obstacle.empty()) throw std::runtime_error(path + ": " + obstacle);
}

}  // namespace tws_runtime
