#include "bag_chunk.h"

#include <bzlib.h>
#include <lz4frame.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/stream.hpp>

namespace tws_runtime {
namespace {

bool unpackBz2(const std::string& packed, std::string& content) {
  auto size = static_cast<unsigned>(content.size());
  std::string source = packed;  // The library takes no const.
  const auto packed_size = static_cast<unsigned>(source.size());
  return BZ2_bzBuffToBuffDecompress(content.data(), &size, source.data(), packed_size, 0, 0) == BZ_OK &&
         size == content.size();
}

/// All of it, in one frame. rosbag's own reader of these believes the length of a block, which this one compares.
bool unpackLz4(const std::string& packed, std::string& content) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0) return false;
  std::size_t read = 0, written = 0, left = 1, in = 1, out = 1;
  while (left != 0 && LZ4F_isError(left) == 0 && in + out > 0) {
    in = packed.size() - read;
    out = content.size() - written;
    left = LZ4F_decompress(context, content.data() + written, &out, packed.data() + read, &in, nullptr);
    read += in;
    written += out;
  }
  LZ4F_freeDecompressionContext(context);
  return left == 0 && read == packed.size() && written == content.size();
}

}  // namespace

std::uint64_t mostUnpacked(std::uint64_t bytes) {
  // rosbag packs 0.8 MB and a message at a time; the quietest recordings shrink to a thousandth.
  constexpr std::uint64_t kMostForFew = 16U << 20U, kMostPerByte = 2000;
  return kMostForFew + kMostPerByte * bytes;
}

std::string unpackChunk(const BagRecord& chunk, std::string data) {
  const std::string_view compression = chunk.word("compression");
  const std::uint64_t size = chunk.number("size", 4);
  const std::string sizes = std::to_string(size) + " bytes, of " + std::to_string(data.size());
  if (compression == "none") {
    if (size != data.size()) chunk.fail("the chunk says that it holds " + sizes);
    return data;
  }
  if (compression != "bz2" && compression != "lz4")
    chunk.fail("the chunk is compressed by '" + std::string(compression) + "', which is not known");
  if (size > mostUnpacked(data.size())) chunk.fail("the chunk says that it unpacks to " + sizes);
  std::string content(size, '\0');
  if (!(compression == "bz2" ? unpackBz2 : unpackLz4)(data, content))
    chunk.fail("the chunk does not unpack to what it says: " + sizes);
  return content;
}

std::vector<ChunkMessage> messagesIn(const std::string& content) {
  boost::iostreams::stream<boost::iostreams::array_source> bytes(content.data(), content.size());
  BagRecords records(bytes, content.size(), "the chunk");
  std::vector<ChunkMessage> messages;
  while (!records.atEnd()) {
    const BagRecord record = records.next();
    if (record.kind() != BagRecord::kConnection) {
      record.expect(BagRecord::kMessage);
      messages.push_back({static_cast<std::uint32_t>(record.at), static_cast<std::uint32_t>(record.number("conn", 4))});
    }
    records.skipData(record);
  }
  return messages;
}

}  // namespace tws_runtime
