// libFuzzer target: whatever the bytes, nothing is read outside them, every step goes on, and time and memory have a
// bound. See README.md.
#include <cstdlib>

#include "radar_feed.h"
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

// A whole feed: beams, sectors, radars of any number.
void feed(Bytes bytes, bool is_live) {
  asterix_bridge::RadarFeed::Options options;
  options.sectors.steady = is_live;
  asterix_bridge::RadarFeed::Events events;
  std::size_t sectors = 0;
  events.sector = [&](auto, auto&& sector) {
    if (++sectors > 1000000 || sector.leave_time < sector.enter_time) std::abort();
  };
  events.position = [](auto, const auto&) {};
  events.fault = [](const auto&, const auto&) {};
  events.left_out = [](const auto&) {};
  asterix_bridge::RadarFeed radars(asterix_bridge::DataClock(1.7e9), options, events);
  const auto blocks = asterix_bridge::findBlocks(bytes, Framing::kRaw);
  while (const auto step = blocks->next()) {
    radars.add(*step, "fuzz");
    if (is_live) radars.advance(radars.now());
  }
  radars.finish();
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
    switch (data[0] % 12) {
      case 0:
        stream.add({asterix_bridge::FramedBlock{bytes, 0, std::nullopt, std::nullopt}, std::nullopt});
        break;
      case 1:
        for (const auto& step : asterix_bridge::blocksOfDatagram(bytes)) stream.add(step);
        break;
      case 2:
        walk(bytes, asterix_bridge::detectFraming(bytes), stream);
        break;
      case 10:
      case 11:
        feed(bytes, data[0] % 12 == 11);
        break;
      default:
        walk(bytes, static_cast<Framing>(data[0] % 12 - 3), stream);
    }
  } catch (const std::runtime_error&) {
    // No known framing, or a file header that is cut.
  }
  return 0;
}
