// Framings, packets, codec, times, beams and sectors: whatever the bytes, nothing is read outside them, every step goes
// on, and what comes out of a feed is in order. See README.md.
#include <cmath>

#include "fuzzing.h"
#include "radar_feed.h"

namespace {

using asterix_bridge::Bytes;
using asterix_bridge::CutSector;
using asterix_bridge::Framing;
using asterix_bridge::RadarFeed;
using fuzzing::found;

void check(const CutSector& sector) {
  if (sector.sector < 0 || sector.sector > 63) found("a sector that is none");
  if (!(sector.leave_time > sector.enter_time) || !std::isfinite(sector.leave_time)) found("a sector without a time");
  for (const auto& timed : sector.reports)
    if (!std::isfinite(timed.time)) found("a report without a time");
}

RadarFeed::Events events() {
  RadarFeed::Events events;
  events.sector = [](auto, CutSector&& sector) { check(sector); };
  events.position = [](auto, const auto&) {};
  events.fault = [](const std::string& counter, const std::string& reason) {
    if (counter.empty() || reason.empty()) found("a fault without a reason");
  };
  events.left_out = [](const std::string&) {};
  return events;
}

void walk(Bytes bytes, Framing framing, RadarFeed& feed) {
  const auto blocks = asterix_bridge::findBlocks(bytes, framing);
  std::size_t steps = 0;
  while (const auto step = blocks->next()) {
    if (++steps > bytes.size + 2) found("no end of steps");
    feed.add(*step, "input");
  }
}

void add(Bytes bytes, int how, RadarFeed& feed) {
  switch (how) {
    case 0:
      feed.add({asterix_bridge::FramedBlock{bytes, 0, std::nullopt, std::nullopt}, std::nullopt}, "input");
      return;
    case 1:
      for (const auto& step : asterix_bridge::blocksOfDatagram(bytes)) feed.add(step, "input");
      return;
    case 2:
      walk(bytes, asterix_bridge::detectFraming(bytes), feed);
      return;
    default:
      walk(bytes, static_cast<Framing>(how - 3), feed);
  }
}

}  // namespace

// The first byte says how the rest is read, and whether as from the network.
void fuzzing::fuzz(std::string_view input) {
  if (input.empty()) return;
  const auto* data = reinterpret_cast<const std::uint8_t*>(input.data());
  RadarFeed::Options options;
  options.test_targets = options.sectors.steady = (data[0] & 0x40U) != 0;
  constexpr double kStart = 1.7e9;
  RadarFeed feed(asterix_bridge::DataClock(kStart), options, events());
  try {
    add({data + 1, input.size() - 1}, data[0] % 10, feed);
    feed.advance(kStart + 100.0);
  } catch (const std::runtime_error&) {
    // No known framing, or a file header that is cut.
  }
  feed.finish();
}
