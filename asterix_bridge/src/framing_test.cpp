#include "framing.h"

#include <gtest/gtest.h>

#include <ctime>

#include <tws_core/random_test_helpers.h>

#include "framing_test_helpers.h"

namespace asterix_bridge {
namespace {

const Octets kPlot = blockOf(1, plot001());                                    // 15 bytes
const Octets kNorth = blockOf(2, {0xD0, 0x08, 0x09, 0x01, 0x00, 0x00, 0x80});  // 10 bytes

Octets repeat(const Octets& part, int times) {
  Octets all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(Framing, IsFoundByLookingAtTheBytes) {
  EXPECT_EQ(detectFraming(bytesOf(kPlot + kNorth + kPlot)), Framing::kRaw);
  EXPECT_EQ(detectFraming(bytesOf(kPlot)), Framing::kRaw);
  EXPECT_EQ(detectFraming(bytesOf(repeat(timed(kPlot, 1), 4))), Framing::kTimed);
  const Octets recorder = Octets(2200, 0xCD) + repeat(recorded(kPlot, 1), 4);
  EXPECT_EQ(detectFraming(bytesOf(recorder)), Framing::kRecorder);
  EXPECT_EQ(detectFraming(bytesOf({0xD4, 0xC3, 0xB2, 0xA1})), Framing::kPcap);
  EXPECT_EQ(detectFraming(bytesOf({0x0A, 0x0D, 0x0D, 0x0A})), Framing::kPcapNg);
}

// A text file read as a radar's data would fill the log, not the screen.
TEST(Framing, OfAnotherKindOfFileIsRefused) {
  const std::string text(5000, 'x');
  EXPECT_THROW(detectFraming(bytesOf(Octets(text.begin(), text.end()))), std::runtime_error);
  EXPECT_THROW(detectFraming(Bytes{}), std::runtime_error);
}

Octets rff(const Octets& blocks) {
  const std::string dates = "01.01.2024 10:00:00 01.01.2024 10:10:00 ";
  Octets header(dates.begin(), dates.end());
  header.resize(128);
  return header + blocks;
}
Octets rffBlock(const Octets& block, std::uint8_t ms) {
  return Octets{0, 0, 0, ms, static_cast<std::uint8_t>(block.size()), 0} + block;
}
Octets finalBlock(const Octets& block, std::uint8_t hundredths) {
  return Octets{0, static_cast<std::uint8_t>(block.size() + 12), 0, 1, 1, 0x36, 0xEE, hundredths} + block +
         Octets(4, 0xA5);
}

TEST(Framing, OfOtherRecordersIsFoundWithItsTimes) {
  const Octets final = repeat(finalBlock(kPlot, 0x81), 4);
  EXPECT_EQ(detectFraming(bytesOf(final)), Framing::kFinal);
  EXPECT_DOUBLE_EQ(*findAll(final, Framing::kFinal).blocks.at(3).time_of_day, 36000.01);
  const Octets comsoft = rff(repeat(rffBlock(kPlot, 101), 4));
  EXPECT_EQ(detectFraming(bytesOf(comsoft)), Framing::kRff);
  EXPECT_DOUBLE_EQ(*findAll(comsoft, Framing::kRff).blocks.at(3).time, 1704103200.101);
}

// A recording that was cut anywhere, or begins with other radars' data, is a recording still.
TEST(Framing, IsFoundWhateverStandsAtTheBeginning) {
  const Octets other = blockOf(62, Octets(21, 0));
  const Octets many = repeat(other, 60) + repeat(kPlot, 20);
  ASSERT_EQ(detectFraming(bytesOf(many)), Framing::kRaw);
  EXPECT_EQ(findAll(many, Framing::kRaw).blocks.size(), 80u);
  Octets cut = repeat(kPlot, 20);
  cut.erase(cut.begin(), cut.begin() + 5);
  ASSERT_EQ(detectFraming(bytesOf(cut)), Framing::kRaw);
  EXPECT_EQ(findAll(cut, Framing::kRaw).blocks.size(), 19u);
  auto random = tws::seededGenerator();
  Octets noise(997);
  for (std::uint8_t& octet : noise) octet = static_cast<std::uint8_t>(random());
  ASSERT_EQ(detectFraming(bytesOf(noise + repeat(kPlot, 20))), Framing::kRaw);
}

TEST(Framing, ThatIsNoneSaysWhatTheFileIs) {
  const auto reason = [](const Octets& file) {
    try {
      detectFraming(bytesOf(file));
      return std::string("none");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  const std::string hello = "Hello, this is not ASTERIX\n", bag = "#ROSBAG V2.0\n";
  EXPECT_NE(reason(Octets(hello.begin(), hello.end())).find("text"), std::string::npos);
  EXPECT_NE(reason(Octets(bag.begin(), bag.end())).find("bag"), std::string::npos);
  EXPECT_EQ(reason({0x30, 0x00, 0x03}), "3 bytes are too few for an ASTERIX record");
  EXPECT_NE(reason(Octets{0x1F, 0x8B} + Octets(98, 7)).find("compressed"), std::string::npos);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kMostTime = 60.0;  // [s]; each access is watched
#else
constexpr double kMostTime = 20.0;  // [s] of processor time, which a crowded machine stretches; the square is minutes
#endif

// A hostile or broken file must cost seconds a megabyte, not minutes a datagram: each byte may begin a block.
TEST(RawFraming, IsLookedThroughInLinearTime) {
  const Octets hostile[] = {Octets(1 << 19, 0x30), Octets(1 << 19, 0x01), repeat({0x30, 0xF0}, 1 << 18),
                            repeat({0x30, 0x80, 0x01}, 1 << 17), repeat({0x01, 0xF1, 0x01}, 1 << 17)};
  for (const Octets& file : hostile) {
    const std::clock_t start = std::clock();
    for (const auto framing : {Framing::kRaw, Framing::kRecorder}) findAll(file, framing);
    const double took = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_LT(took, kMostTime) << int{file[0]} << ' ' << int{file[1]};
  }
}

TEST(RawFraming, GivesEachBlockWithItsOffset) {
  const Octets recording = kPlot + kNorth + kPlot;
  const Found found = findAll(recording, Framing::kRaw);
  EXPECT_TRUE(found.faults.empty());
  ASSERT_EQ(found.blocks.size(), 3u);
  EXPECT_EQ(found.contents[1], kNorth);
  EXPECT_EQ(found.blocks[1].offset, 15u);
  EXPECT_FALSE(found.blocks[1].time_of_day);
}

TEST(RecorderFraming, TellsWhenTheBlockWasReceived) {
  const Octets recording = Octets(2200, 0xCD) + recorded(kPlot, 128) + recorded(kNorth, 0x546000);
  const Found found = findAll(recording, Framing::kRecorder);
  ASSERT_EQ(found.blocks.size(), 2u);
  EXPECT_EQ(found.blocks[0].offset, 2200u);
  EXPECT_EQ(found.blocks[1].offset, 2225u);
  EXPECT_EQ(found.contents[1], kNorth);
  EXPECT_DOUBLE_EQ(*found.blocks[0].time_of_day, 1.0);
  EXPECT_DOUBLE_EQ(*found.blocks[1].time_of_day, 43200.0);
}

TEST(TimedFraming, TellsWhenTheBlockWasReceived) {
  const Octets recording = timed(kPlot, 43200000) + timed(kNorth, 250);
  const Found found = findAll(recording, Framing::kTimed);
  ASSERT_EQ(found.blocks.size(), 2u);
  EXPECT_EQ(found.contents[0], kPlot);
  EXPECT_EQ(found.blocks[0].offset, 6u);
  EXPECT_DOUBLE_EQ(*found.blocks[0].time_of_day, 43200.0);
  EXPECT_DOUBLE_EQ(*found.blocks[1].time_of_day, 0.25);
}

TEST(Datagram, MayHoldSeveralBlocksRawOrTimed) {
  EXPECT_EQ(blocksOfDatagram(bytesOf(kPlot + kNorth)).size(), 2u);
  const Octets packet = timed(kPlot, 1) + timed(kNorth, 2);
  const auto steps = blocksOfDatagram(bytesOf(packet), 100);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].block->offset, 106u);
  EXPECT_TRUE(blocksOfDatagram(Bytes{}).empty());
}

TEST(Datagram, ThatIsCutIsAFault) {
  Octets packet = kPlot + kPlot;
  packet.pop_back();
  const auto steps = blocksOfDatagram(bytesOf(packet), 100);
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_TRUE(steps[0].block);
  ASSERT_TRUE(steps[1].fault);
  EXPECT_EQ(steps[1].fault->offset, 115u);
}

// One broken block must cost that block and no more.
TEST(RawFraming, GoesOnBehindABlockWithAWrongLength) {
  for (const std::uint8_t wrong : {0, 3, 14, 16, 200}) {
    Octets recording = repeat(kPlot, 8);
    recording[3 * 15 + 2] = wrong;
    const Found found = findAll(recording, Framing::kRaw);
    EXPECT_EQ(found.faults.size(), 1u) << int{wrong};
    ASSERT_EQ(found.blocks.size(), 7u) << int{wrong};
    EXPECT_EQ(found.blocks[3].offset, 60u) << int{wrong};
    EXPECT_EQ(found.faults.at(0).offset, 45u) << int{wrong};
  }
}

TEST(RecorderFraming, SaysThatTheLastBlockIsCutAndKeepsTheOthers) {
  Octets recording = Octets(2200, 0xCD) + repeat(recorded(kPlot, 128), 3);
  recording.resize(recording.size() - 13);
  const Found found = findAll(recording, Framing::kRecorder);
  EXPECT_EQ(found.blocks.size(), 2u);
  ASSERT_EQ(found.faults.size(), 1u);
  EXPECT_EQ(found.faults[0].offset, 2250u);
  EXPECT_NE(found.faults[0].reason.find("12 bytes"), std::string::npos) << found.faults[0].reason;
}

TEST(RawFraming, GoesOnBehindRandomBytes) {
  auto random = tws::seededGenerator();
  for (int round = 0; round < 200; ++round) {
    Octets noise(1 + random() % 40);
    for (std::uint8_t& octet : noise) octet = static_cast<std::uint8_t>(0xE0 | random());  // no category that we know
    const Octets recording = repeat(kPlot, 4) + noise + repeat(kNorth, 4);
    const Found found = findAll(recording, Framing::kRaw);
    EXPECT_EQ(found.blocks.size(), 8u);
    EXPECT_EQ(found.faults.size(), 1u);
  }
}

}  // namespace
}  // namespace asterix_bridge
