// libFuzzer target: whatever the bytes, nothing is read outside them and every step goes on. See README.md.
#include <cstdlib>

#include "recording.h"

namespace {

using asterix_bridge::Bytes;
using asterix_bridge::Framing;

void walk(Bytes bytes, Framing framing, asterix_bridge::RecordStream& stream) {
  const auto blocks = asterix_bridge::findBlocks(bytes, framing);
  std::size_t steps = 0;
  while (const auto step = blocks->next()) {
    if (++steps > bytes.size + 2) std::abort();  // no progress
    stream.add(*step);
  }
}

}  // namespace

// The first byte says how the rest is read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Bytes bytes{data + 1, size - 1};
  asterix_bridge::RecordStream::Events events;
  events.report = [](const auto&, double) {};
  events.message = [](const auto&, double) {};
  events.fault = [](auto, const auto& fault) {
    if (fault.reason.empty()) std::abort();
  };
  asterix_bridge::RecordStream stream(asterix_bridge::DataClock(1.7e9), events);
  try {
    switch (data[0] % 8) {
      case 0:
        stream.add({asterix_bridge::FramedBlock{bytes, 0, std::nullopt, std::nullopt}, std::nullopt});
        break;
      case 1:
        for (const auto& step : asterix_bridge::blocksOfDatagram(bytes)) stream.add(step);
        break;
      case 2:
        walk(bytes, asterix_bridge::detectFraming(bytes), stream);
        break;
      default:
        walk(bytes, static_cast<Framing>(data[0] % 8 - 3), stream);
    }
  } catch (const std::runtime_error&) {
    // No known framing, or a file header that is cut.
  }
  return 0;
}
