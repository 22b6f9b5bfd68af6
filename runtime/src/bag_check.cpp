#include "bag_check.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace tws_runtime {
namespace {

constexpr std::string_view kFirstLine = "#ROSBAG V2.0\n";

/// Unsigned 32 bits, the least significant byte first.
std::uint64_t length(std::istream& file) {
  std::array<unsigned char, 4> bytes{};
  file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
  return bytes[0] | bytes[1] << 8U | bytes[2] << 16U | static_cast<std::uint64_t>(bytes[3]) << 24U;
}

}  // namespace

void checkBagLengths(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string first(kFirstLine.size(), ' ');
  if (!file.read(first.data(), static_cast<std::streamsize>(first.size())) || first != kFirstLine) return;
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  std::uint64_t at = first.size();
  while (at < size) {
    for (const char* part : {"header", "data"}) {
      file.seekg(static_cast<std::streamoff>(at));
      const std::uint64_t bytes = length(file);
      if (!file || bytes > size - at - 4)
        throw std::runtime_error(path + ": is truncated or no bag: the " + part + " of the record at byte " +
                                 std::to_string(at) + " is longer than the file");
      at += 4 + bytes;
    }
  }
}

}  // namespace tws_runtime
