// Bags with one damage each: rosbag believes every length, count and offset, and so would end in a crash.
#include "bag_records.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_runtime/bag_file.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

namespace tws_runtime {
namespace {

constexpr int kTexts = 60;  // and as many numbers

/// Texts and numbers in some chunks.
std::string recording(const std::string& path, rosbag::CompressionType compression) {
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    bag.setCompression(compression);
    bag.setChunkThreshold(2000);
    std_msgs::String text;
    std_msgs::Int32 number;
    for (number.data = 0; number.data < kTexts; ++number.data) {
      text.data = "what number " + std::to_string(number.data) + " says";
      bag.write("/texts", ros::Time(5 + number.data), text);
      bag.write("/numbers", ros::Time(5 + number.data), number);
    }
  }
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string inBytes(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (; bytes.size() < count; value >>= 8U) bytes += static_cast<char>(value & 0xffU);
  return bytes;
}

/// A bag to be damaged.
struct Bytes {
  std::string text;

  /// Where the value of a field begins, in the n-th header that has it.
  std::size_t field(const std::string& name, int n = 0) const {
    std::size_t at = text.find(name + "=");
    for (; n > 0; --n) at = text.find(name + "=", at + 1);
    return at + name.size() + 1;
  }
  void set(std::size_t at, std::uint64_t value, std::size_t size = 4) { text.replace(at, size, inBytes(value, size)); }
  void set(const std::string& name, std::uint64_t value, std::size_t size = 4, int n = 0) {
    set(field(name, n), value, size);
  }
  std::uint64_t get(std::size_t at) const { return littleEndian(text.substr(at, 4)); }
  /// Where the data of the n-th record of a kind begin, after their length.
  std::size_t data(char kind, int n = 0) const {
    std::size_t at = std::string::npos;
    for (; n >= 0; --n) at = text.find(std::string("op=") + kind, at + 1);
    while (!isHeader(at)) --at;
    return at + 4 + get(at) + 4;
  }

 private:
  /// Fields begin after 4 bytes, and fill it.
  bool isHeader(std::size_t at) const {
    const std::size_t end = at + 4 + get(at);
    if (end > text.size() || get(at) < 8 || get(at) > 1000) return false;
    std::size_t field = at + 4;
    while (field + 4 < end) field += 4 + get(field);
    return field == end;
  }
};

class BagCheck : public ::testing::Test {
 protected:
  std::string path() const { return folder_.file("some.bag"); }

  void write(const std::string& bytes) const { std::ofstream(path(), std::ios::binary) << bytes; }

  Bytes recorded(rosbag::CompressionType compression = rosbag::compression::Uncompressed) const {
    return {recording(folder_.file("whole.bag"), compression)};
  }

  /// How many messages a bag holds, each of them read.
  int countMessages() const {
    rosbag::Bag bag;
    openBag(bag, path());
    int count = 0;
    for (const rosbag::MessageInstance& message : rosbag::View(bag))
      count += messageAs<std_msgs::String>(message) || messageAs<std_msgs::Int32>(message) ? 1 : 0;
    return count;
  }

  std::string complaint(const Bytes& bytes) const {
    write(bytes.text);
    try {
      countMessages();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  void expectRefused(const Bytes& bytes, const std::string& why) const {
    const std::string said = complaint(bytes);
    EXPECT_EQ(said.rfind(path() + ": ", 0), 0U) << said;
    EXPECT_NE(said.find(why), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }

 private:
  tws::TemporaryFolder folder_;
};

// If this fails, recordings that are whole are refused.
TEST_F(BagCheck, AWholeBagIsReadWhateverPacksIt) {
  for (const auto compression :
       {rosbag::compression::Uncompressed, rosbag::compression::BZ2, rosbag::compression::LZ4}) {
    write(recorded(compression).text);
    EXPECT_EQ(countMessages(), 2 * kTexts) << compression;
  }
}

// If one of these fails, a damaged bag ends the program, asks for gigabytes, or loses messages in silence.
TEST_F(BagCheck, WhatIsNoBagOfThisFormatIsRefused) {
  Bytes bag = recorded();
  bag.text.replace(0, 12, "#ROSBAG V1.2");
  expectRefused(bag, "rosbag filter");
  expectRefused({"#ROS" + std::string(900, 'a') + " V2.0\n"}, "is no bag");
  expectRefused({""}, "is no bag");
}

TEST_F(BagCheck, ABagWithoutAnIndexIsRefusedWithTheCommandThatMakesOne) {
  Bytes bag = recorded();
  bag.set("index_pos", 0, 8);
  expectRefused(bag, "rosbag reindex");
}

TEST_F(BagCheck, ABagThatNamesItsDecryptionIsRefused) {
  Bytes bag = recorded();
  const std::string field = inBytes(16, 4) + "encryptor=rosbag";
  const std::size_t padding = 13 + 4 + bag.get(13);
  bag.set(padding, bag.get(padding) - field.size());
  bag.text.erase(padding + 4, field.size()).insert(padding, field);
  bag.set(13, bag.get(13) + field.size());
  expectRefused(bag, "is encrypted");
}

TEST_F(BagCheck, CountsOfTheHeaderThatLieAreRefused) {
  const Bytes whole = recorded();
  for (const std::string field : {"conn_count", "chunk_count"})
    for (const int more : {-1, 1, 1 << 30}) {
      Bytes bag = whole;
      bag.set(field, bag.get(bag.field(field)) + static_cast<std::uint64_t>(more));
      EXPECT_NE(complaint(bag), "") << field << ' ' << more;
    }
}

TEST_F(BagCheck, AnIndexThatIsElsewhereIsRefused) {
  const Bytes whole = recorded();
  for (const std::uint64_t place :
       {std::uint64_t{1}, std::uint64_t{5000}, std::uint64_t{1} << 60U, ~std::uint64_t{0}}) {
    Bytes bag = whole;
    bag.set("index_pos", place, 8);
    EXPECT_NE(complaint(bag), "") << place;
  }
}

TEST_F(BagCheck, AChunkThatIsElsewhereOrNamedTwiceIsRefused) {
  const Bytes whole = recorded();
  const std::uint64_t first = whole.get(whole.field("chunk_pos"));
  for (const std::uint64_t place : {std::uint64_t{0}, first, first + 1, std::uint64_t{1} << 60U}) {
    Bytes bag = whole;
    bag.set("chunk_pos", place, 8, 1);
    EXPECT_NE(complaint(bag), "") << place;
  }
}

TEST_F(BagCheck, AFieldLongerThanItsHeaderIsRefused) {
  Bytes bag = recorded();
  bag.set(bag.field("chunk_pos") - 14, 900000);
  expectRefused(bag, "a field of the header is longer than the header");
}

TEST_F(BagCheck, ARecordInAChunkLongerThanTheChunkIsRefused) {
  Bytes bag = recorded();
  bag.set(bag.data(BagRecord::kMessage) - 4, 1000000);
  expectRefused(bag, "longer than the chunk");
}

TEST_F(BagCheck, AnIndexThatNamesNoMessageIsRefused) {
  const Bytes whole = recorded();
  const std::size_t offset = whole.data(BagRecord::kIndex) + 8;
  for (const std::uint64_t place : {std::uint64_t{0}, whole.get(offset) + 1, whole.get(offset + 12),
                                    std::uint64_t{3000}, std::uint64_t{0xfffffff0}}) {
    Bytes bag = whole;
    bag.set(offset, place);
    expectRefused(bag, "the index names a message that is not there");
  }
}

TEST_F(BagCheck, AnIndexOfAnotherLengthOrConnectionIsRefused) {
  const Bytes whole = recorded();
  const std::size_t data = whole.data(BagRecord::kIndex);
  for (const std::size_t before : {std::size_t{28}, std::size_t{42}}) {  // "count" and "conn" in the header before it
    Bytes bag = whole;
    bag.set(data - before, 0x7fffffff);
    expectRefused(bag, "the index counts other messages");
  }
}

TEST_F(BagCheck, ATimeInTheIndexThatIsNoneIsRefused) {
  Bytes bag = recorded();
  bag.set(bag.data(BagRecord::kIndex), 0xffffffff);
  bag.set(bag.data(BagRecord::kIndex) + 4, 0xffffffff);
  expectRefused(bag, "a time in the index is none");
}

TEST_F(BagCheck, ATopicThatBreaksTheLineIsRefused) {
  Bytes bag = recorded();
  bag.text.replace(bag.text.rfind("topic=/texts") + 7, 1, "\n");
  expectRefused(bag, "the field 'topic' is no name");
}

TEST_F(BagCheck, AChunkThatDoesNotUnpackToWhatItSaysIsRefused) {
  for (const auto compression :
       {rosbag::compression::Uncompressed, rosbag::compression::BZ2, rosbag::compression::LZ4}) {
    const Bytes whole = recorded(compression);
    for (const std::uint64_t size : {std::uint64_t{8}, whole.get(whole.field("size")) + 1, std::uint64_t{0xfffffff0}}) {
      Bytes bag = whole;
      bag.set("size", size);
      expectRefused(bag, "the chunk");
    }
  }
}

TEST_F(BagCheck, AnUnknownPackingIsRefused) {
  Bytes bag = recorded(rosbag::compression::BZ2);
  bag.text.replace(bag.field("compression"), 3, "zip");
  expectRefused(bag, "'zip', which is not known");
}

// If this fails, rosbag's reader of lz4 writes beyond its buffer: it believes the length of a block.
TEST_F(BagCheck, ABlockOfLz4LongerThanItsFrameAllowsIsRefused) {
  Bytes bag = recorded(rosbag::compression::LZ4);
  bag.set(bag.data(BagRecord::kChunk) + 7, 0x7fffffff);
  expectRefused(bag, "the chunk does not unpack");
}

// If this fails, some byte of a bag ends the program.
TEST_F(BagCheck, ABagWithRandomBytesIsReadOrRefusedInOneLine) {
  std::mt19937_64 generator = tws::seededGenerator();
  const Bytes whole = recorded();
  for (int i = 0; i < 500; ++i) {
    Bytes bag = whole;
    for (int n = tws::uniformInt(generator, 1, 5); n > 0; --n)
      bag.text[static_cast<std::size_t>(tws::uniformInt(generator, 0, static_cast<int>(bag.text.size()) - 1))] =
          static_cast<char>(tws::uniformInt(generator, 0, 255));
    const std::string said = complaint(bag);
    ASSERT_TRUE(said.empty() || said.rfind(path() + ": ", 0) == 0 || said.rfind("topic ", 0) == 0) << said;
    ASSERT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace tws_runtime
