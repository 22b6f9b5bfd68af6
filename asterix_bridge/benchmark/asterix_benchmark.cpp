// Decoding of recordings, against rosbag's reading of the same plots as messages. The recording is made here, or the
// one that ASTERIX_FILE names.
#include <benchmark/benchmark.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/conversions.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "../src/conversions.h"  // radar_sim has one, too
#include "radar_feed.h"

namespace asterix_bridge {
namespace {

namespace fs = std::filesystem;

void put(std::string& out, std::uint32_t value, int octets) {
  while (octets-- > 0) out += static_cast<char>(value >> (8 * octets));
}

void putPlot(std::string& out, std::uint32_t time, std::uint32_t sector, std::uint32_t plot) {
  put(out, 0xFFF6, 2);  // FSPEC: 010 140 020 040 070 090 130, 220 240 250 161 - 200 170
  put(out, 0x0809, 2);
  put(out, time, 3);
  put(out, 0xA0, 1);
  put(out, 0x2000 + plot * 0x800, 2);
  put(out, sector * 0x800 + plot * 0x80, 2);
  put(out, 0x029C, 2);
  put(out, 0x0578, 2);
  put(out, 0xE03003BF, 4);
  put(out, 0x4CA100 + plot, 3);
  put(out, 0x0420F183, 4);
  put(out, 0x2820, 2);
  put(out, 1, 1);
  out.append(8, '\x40');
  put(out, 0x0100 + plot, 2);
  put(out, 0x04004000, 4);
  put(out, 0x40, 1);
}

/// A Mode S radar that turns once in 5 s and reports 500 aircraft, for 100 s: blocks of one sector each, as CAT048 with
/// the items that such radars send, and a CAT034 sector mark.
std::string syntheticRecording() {
  constexpr std::uint32_t kTurns = 20, kSectors = 32, kPlots = 16;
  std::string recording;
  for (std::uint32_t i = 0; i < kTurns * kSectors; ++i) {
    const std::uint32_t time = 128 * 30000 + 20 * i;  // 5 s are 640 units
    const std::uint32_t sector = i % kSectors;
    put(recording, 0x22000B, 3);
    put(recording, 0xF0, 1);  // FSPEC: 010 000 030 020
    put(recording, 0x0809, 2);
    put(recording, sector == 0 ? kNorthMarker : kSectorCrossing, 1);
    put(recording, time, 3);
    put(recording, sector * 8, 1);
    std::string plots;
    for (std::uint32_t plot = 0; plot < kPlots; ++plot) putPlot(plots, time + plot * 20 / kPlots, sector, plot);
    put(recording, 0x30, 1);
    put(recording, static_cast<std::uint32_t>(plots.size() + 3), 2);
    recording += plots;
  }
  return recording;
}

std::string pathOfRecording() {
  if (const char* path = std::getenv("ASTERIX_FILE")) return path;
  std::string path = fs::temp_directory_path() / ("asterix_benchmark_" + std::to_string(getpid()) + ".ast");
  std::ofstream(path, std::ios::binary) << syntheticRecording();
  return path;
}

const Recording& recording() {
  static const Recording loaded = [] {
    const std::string path = pathOfRecording();
    Recording result(path);
    if (!std::getenv("ASTERIX_FILE")) fs::remove(path);
    return result;
  }();
  return loaded;
}

RadarFeed::Events eventsOf(const std::function<void(SourceId, CutSector&&)>& on_sector) {
  return {on_sector, [](SourceId, const tws::Geodetic&) {}, [](const std::string&, const std::string&) {},
          [](const std::string&) {}};
}

void count(benchmark::State& state, std::uint64_t records, std::uint64_t bytes) {
  state.counters["records"] =
      benchmark::Counter(static_cast<double>(records), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes"] =
      benchmark::Counter(static_cast<double>(bytes), benchmark::Counter::kIsIterationInvariantRate);
}

/// Framing and all fields of all records.
void decode(benchmark::State& state) {
  std::uint64_t records = 0;
  for (auto _ : state) {
    Block block;
    records = 0;
    const auto blocks = recording().blocks();
    while (const auto step = blocks->next()) {
      if (!step->block) continue;
      decodeBlock(step->block->bytes, step->block->offset, block);
      records += block.reports.size() + block.messages.size();
      benchmark::DoNotOptimize(block);
    }
  }
  count(state, records, recording().size());
}
BENCHMARK(decode)->Unit(benchmark::kMillisecond);

/// The same, and full times, the beam, sectors.
void cutIntoSectors(benchmark::State& state) {
  std::uint64_t records = 0;
  for (auto _ : state) {
    RadarFeed feed(clockFor(recording(), std::nullopt), {},
                   eventsOf([](SourceId, CutSector&& sector) { benchmark::DoNotOptimize(sector); }));
    const auto blocks = recording().blocks();
    while (const auto step = blocks->next()) feed.add(*step, "");
    feed.finish();
    records = feed.records();
  }
  count(state, records, recording().size());
}
BENCHMARK(cutIntoSectors)->Unit(benchmark::kMillisecond);

/// A bag with the recording's plots as messages; returns how many plots.
std::uint64_t writeBag(const std::string& path) {
  rosbag::Bag bag(path, rosbag::bagmode::Write);
  std::uint64_t plots = 0;
  RadarFeed feed(clockFor(recording(), std::nullopt), {}, eventsOf([&](SourceId, CutSector&& sector) {
                   plots += sector.reports.size();
                   const ros::Time time = tws_runtime::toTime(sector.leave_time);
                   bag.write("/radar/detections", time,
                             tws_runtime::toDetections(toRadarSector(sector, false), "r", "r"));
                   bag.write("/radar/plots", time, toSsrPlots(sector, "r"));
                 }));
  const auto blocks = recording().blocks();
  while (const auto step = blocks->next()) feed.add(*step, "");
  feed.finish();
  return plots;
}

/// rosbag's reading of the messages of the same plots.
void readBag(benchmark::State& state) {
  const std::string path = fs::temp_directory_path() / ("asterix_benchmark_" + std::to_string(getpid()) + ".bag");
  const std::uint64_t plots = writeBag(path);
  const std::uint64_t size = fs::file_size(path);
  for (auto _ : state) {
    const rosbag::Bag bag(path);
    rosbag::View view(bag);
    for (const rosbag::MessageInstance& message : view) {
      if (const auto detections = message.instantiate<tws_msgs::Detections>()) benchmark::DoNotOptimize(*detections);
      if (const auto replies = message.instantiate<tws_msgs::SsrPlots>()) benchmark::DoNotOptimize(*replies);
    }
  }
  fs::remove(path);
  count(state, plots, size);
}
BENCHMARK(readBag)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace asterix_bridge

BENCHMARK_MAIN();
