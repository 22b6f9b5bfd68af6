#include "recording.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <utime.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "framing_test_helpers.h"
#include "radar_feed.h"

namespace asterix_bridge {
namespace {

constexpr double kDay = 86400.0;
constexpr long kSomeDay = 18000;  // since 1970

// CAT002 of source 8/9: north mark, time of day.
Octets north(double time_of_day) {
  const auto units = static_cast<std::uint32_t>(std::lround(time_of_day * 128.0));
  return blockOf(2, {0xD0, 0x08, 0x09, 0x01, static_cast<std::uint8_t>(units >> 16),
                     static_cast<std::uint8_t>(units >> 8), static_cast<std::uint8_t>(units)});
}

// CAT001 plot of source 8/9: 64 NM, 90 degrees, the time of day without what is beyond 512 s.
Octets plot(double time_of_day) {
  Octets record = plot001();
  const auto units = static_cast<std::uint16_t>(std::lround(std::fmod(time_of_day, 512.0) * 128.0));
  record[10] = static_cast<std::uint8_t>(units >> 8);
  record[11] = static_cast<std::uint8_t>(units);
  return blockOf(1, record);
}

/// A file that is removed again, written at a time since 1970 [s].
class File {
 public:
  File(const Octets& content, long write_time)
      : path_(std::filesystem::temp_directory_path() / ("asterix_recording_test_" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
    const utimbuf times{write_time, write_time};
    EXPECT_EQ(utime(path_.c_str(), &times), 0);
  }
  ~File() { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

double startOf(const Octets& content, long write_time, std::optional<double> date = std::nullopt) {
  const File file(content, write_time);
  const Recording recording(file.path());
  return contentsOf(recording, clockFor(recording, date)).start;
}

// Tracks of the wrong day cannot be compared with anything else.
TEST(Recording, WithoutADateIsOfTheDayBeforeItWasWritten) {
  const Octets content = north(66000.0) + plot(66001.0);
  const long evening = kSomeDay * 86400 + 70000;
  EXPECT_DOUBLE_EQ(startOf(content, evening), kSomeDay * kDay + 66000.0);
  EXPECT_DOUBLE_EQ(startOf(content, evening + 20000), kSomeDay * kDay + 66000.0);  // written after midnight
  EXPECT_DOUBLE_EQ(startOf(content, evening - 10000), (kSomeDay - 1) * kDay + 66000.0);
}

TEST(Recording, IsOfTheDateThatIsGiven) {
  const Octets content = north(86399.0) + plot(86399.5) + north(1.0);
  EXPECT_DOUBLE_EQ(startOf(content, kSomeDay * 86400, 100.0 * kDay), 100.0 * kDay + 86399.0);
}

// CAT001 plots that come before the first mark need its time as well.
TEST(Recording, RebuildsTheTimeOfPlotsBeforeTheFirstMark) {
  const Octets content = plot(65990.0) + plot(65995.0) + north(66000.0) + plot(66001.0);
  EXPECT_DOUBLE_EQ(startOf(content, kSomeDay * 86400 + 70000), kSomeDay * kDay + 65990.0);
}

TEST(Recording, TellsWhatItHolds) {
  const File file(north(66000.0) + plot(66001.0) + plot(66002.0) + blockOf(62, {0x80, 1, 2}), kSomeDay * 86400);
  const Recording recording(file.path());
  const Contents contents = contentsOf(recording, clockFor(recording, std::nullopt));
  ASSERT_EQ(contents.radars.size(), 1u);
  const RadarContents& radar = contents.radars.at({8, 9});
  EXPECT_EQ(radar.reports, 2u);
  EXPECT_EQ(radar.marks, 1u);
  EXPECT_FALSE(radar.position);
  EXPECT_DOUBLE_EQ(contents.end - contents.start, 2.0);
  EXPECT_EQ(contents.faults, 1u);
}

TEST(Recording, ThatCannotBeReadIsRefusedByName) {
  for (const std::string path : {"/nowhere.ast", "/tmp", ""}) {
    try {
      const Recording recording(path);
      ADD_FAILURE() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), path + ": cannot be read");
    }
  }
}

// What is left out must be counted, and said for what it is.
TEST(RadarFeed, CountsWhatItLeavesOutAndWhy) {
  std::map<std::string, int> left_out;
  std::vector<std::string> faults;
  RadarFeed::Events events;
  events.sector = [](SourceId, CutSector&&) {};
  events.position = [](SourceId, const tws::Geodetic&) {};
  events.fault = [&](const std::string& counter, const std::string& reason) {
    faults.push_back(counter + ": " + reason);
  };
  events.left_out = [&](const std::string& counter) { ++left_out[counter]; };
  RadarFeed feed(DataClock(kSomeDay * kDay), {}, events);
  const auto add = [&](const Octets& block) {
    for (const FramingStep& step : blocksOfDatagram(bytesOf(block), 100)) feed.add(step, "10.0.0.1:8600");
  };
  add(blockOf(1, {0xC0, 8, 9, 0x80}));              // a track without detection
  add(blockOf(1, {0xC0, 8, 9, 0x21, 0x80}));        // a test target
  add(blockOf(1, {0xC2, 8, 9, 0x20, 0x00, 0x80}));  // a plot without position
  add(blockOf(1, {0xE0, 8, 9, 0x20, 1, 0, 1, 0}));  // a plot without time
  add(blockOf(48, {0x20, 0x20}));                   // a plot without source
  add(blockOf(48, {0x01, 0x01, 0x01, 0x01, 0x02}));
  feed.finish();
  EXPECT_EQ(left_out, (std::map<std::string, int>{{"reports without detection", 1}, {"test targets", 1}}));
  ASSERT_EQ(faults.size(), 4u);
  EXPECT_EQ(faults[0], "reports without measured position: from radar_8_9");
  EXPECT_EQ(faults[1], "records without a source: 10.0.0.1:8600, byte 100: a target report without SAC and SIC");
  EXPECT_EQ(faults[2].find("bad blocks: 10.0.0.1:8600, byte 108: no item has the field reference number"), 0u)
      << faults[2];
  EXPECT_EQ(faults[3], "reports without time: from radar_8_9");
}

/// What comes out of blocks: each report's radar and time.
std::vector<std::pair<SourceId, double>> reportsIn(const std::vector<FramedBlock>& blocks) {
  std::vector<std::pair<SourceId, double>> reports;
  RecordStream::Events events;
  events.report = [&](const TargetReport& report, double time) { reports.emplace_back(*report.source, time); };
  events.message = [](const ServiceMessage&, double) {};
  events.fault = [](FaultKind, const BlockFault&) { ADD_FAILURE(); };
  RecordStream stream(DataClock(kSomeDay * kDay), events);
  for (const FramedBlock& block : blocks) stream.add(FramingStep{block, std::nullopt});
  stream.finish();
  return reports;
}
FramedBlock framed(const Octets& block) { return {bytesOf(block), 0, std::nullopt, std::nullopt}; }

// Radars that say source and time once a block, or once a sector, lose all plots otherwise.
TEST(RecordStream, LendsARecordTheSourceAndTimeThatItLacks) {
  const Octets untimed{0xF0, 0x08, 0x09, 0x20, 0x20, 0x00, 0x40, 0x00, 0x02, 0x9C};
  const Octets sourceless{0x70, 0x20, 0x20, 0x00, 0x40, 0x00, 0x02, 0x9C};
  const Octets block = blockOf(1, untimed + sourceless);
  const Octets mark = north(100.0), later = north(104.0);
  const auto waited = reportsIn({framed(block), framed(mark), framed(later), framed(block)});
  ASSERT_EQ(waited.size(), 4u);
  EXPECT_EQ(waited[1].first.sic, 9);
  EXPECT_DOUBLE_EQ(waited[1].second, kSomeDay * kDay + 100.0);
  EXPECT_DOUBLE_EQ(waited[2].second, kSomeDay * kDay + 104.0);
  FramedBlock received = framed(block);
  received.time = 5000.0;
  EXPECT_DOUBLE_EQ(reportsIn({received}).at(0).second, 5000.0);
  const Octets timed_first = blockOf(1, plot001() + sourceless);
  const auto lent = reportsIn({framed(mark), framed(timed_first)});
  EXPECT_DOUBLE_EQ(lent.at(1).second, lent.at(0).second);
  EXPECT_TRUE(std::isnan(reportsIn({framed(block)}).at(0).second));
}

}  // namespace
}  // namespace asterix_bridge
