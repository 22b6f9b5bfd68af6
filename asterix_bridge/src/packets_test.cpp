// Packets worked by hand from RFC 768, RFC 791 and RFC 8200, and files from the pcap and pcapng specifications.
#include "packets.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>

#include "packet_test_helpers.h"

namespace asterix_bridge {
namespace {

Octets pcapPacket(const Octets& packet, std::uint32_t seconds, std::uint32_t fraction) {
  const auto size = static_cast<std::uint32_t>(packet.size());
  return little32(seconds) + little32(fraction) + little32(size) + little32(size) + packet;
}
const Octets kPcapHeader = Octets{0xD4, 0xC3, 0xB2, 0xA1, 2, 0, 4, 0} + Octets(8, 0) + little32(65535) + little32(1);

TEST(Pcap, GivesBlocksWithThePacketsTime) {
  const Octets file = kPcapHeader + pcapPacket(ethernet(ipv4(udp(kPlot + kPlot))), 1000, 500000) +
                      pcapPacket(ethernet(ipv4(udp(kPlot))), 1001, 0);
  const Found found = findAll(file, Framing::kPcap);
  EXPECT_TRUE(found.faults.empty());
  ASSERT_EQ(found.blocks.size(), 3u);
  EXPECT_EQ(found.contents[2], kPlot);
  EXPECT_EQ(found.blocks[0].offset, 24u + 16u + 42u);
  EXPECT_DOUBLE_EQ(*found.blocks[1].time, 1000.5);
  EXPECT_DOUBLE_EQ(*found.blocks[2].time, 1001.0);
}

TEST(Pcap, IsReadInEitherByteOrderAndWithNanoseconds) {
  const Octets packet = ethernet(ipv4(udp(kPlot)));
  const auto size = static_cast<std::uint32_t>(packet.size());
  const Octets file = Octets{0xA1, 0xB2, 0x3C, 0x4D, 0, 2, 0, 4} + Octets(8, 0) + big32(65535) + big32(1) +
                      big32(1000) + big32(250000000) + big32(size) + big32(size) + packet;
  const Found found = findAll(file, detectFraming(bytesOf(file)));
  ASSERT_EQ(found.blocks.size(), 1u);
  EXPECT_DOUBLE_EQ(*found.blocks[0].time, 1000.25);
}

// Other traffic in the file must not hide the radar's.
TEST(Pcap, PassesOtherPacketsOverAndReportsACutEnd) {
  Octets file = kPcapHeader + pcapPacket(ethernet(Octets(28, 0), 0x0806), 1, 0) +
                pcapPacket(ethernet(ipv4(udp(kPlot))), 2, 0) + pcapPacket(ethernet(ipv4(udp(kPlot))), 3, 0);
  file.resize(file.size() - 5);
  const Found found = findAll(file, Framing::kPcap);
  EXPECT_EQ(found.blocks.size(), 1u);
  ASSERT_EQ(found.faults.size(), 2u);
  EXPECT_EQ(found.faults[0].reason, "no IP packet");
  EXPECT_EQ(found.faults[1].reason, "packet cut by the end of the file; the rest of the file cannot be read");
}

Octets ngBlock(std::uint32_t type, Octets body) {
  while (body.size() % 4 != 0) body.push_back(0);
  const auto length = static_cast<std::uint32_t>(body.size() + 12);
  return little32(type) + little32(length) + body + little32(length);
}

TEST(PcapNg, GivesBlocksWithThePacketsTimeInTheInterfacesUnit) {
  const Octets packet = ethernet(ipv4(udp(kPlot)));
  const auto size = static_cast<std::uint32_t>(packet.size());
  const Octets section = ngBlock(0x0A0D0D0A, little32(0x1A2B3C4D) + Octets{1, 0, 0, 0} + Octets(8, 0xFF));
  const Octets interface = ngBlock(1, Octets{1, 0, 0, 0} + little32(65535));
  const Octets milli = ngBlock(1, Octets{1, 0, 0, 0} + little32(65535) + Octets{9, 0, 1, 0, 3, 0, 0, 0, 0, 0, 0, 0});
  const auto enhanced = [&](std::uint32_t number, std::uint32_t ticks) {
    return ngBlock(6, little32(number) + little32(0) + little32(ticks) + little32(size) + little32(size) + packet);
  };
  const Octets statistics = ngBlock(5, Octets(12, 0));
  const Octets file = section + interface + milli + enhanced(0, 2500000) + statistics + enhanced(1, 3500) +
                      ngBlock(3, little32(size) + packet);
  const Found found = findAll(file, detectFraming(bytesOf(file)));
  EXPECT_TRUE(found.faults.empty());
  ASSERT_EQ(found.blocks.size(), 3u);
  EXPECT_EQ(found.contents[1], kPlot);
  EXPECT_DOUBLE_EQ(*found.blocks[0].time, 2.5);
  EXPECT_DOUBLE_EQ(*found.blocks[1].time, 3.5);
  EXPECT_FALSE(found.blocks[2].time);
}

// `cat a.pcap b.pcap` is what people do with two files of one recording.
TEST(Pcap, ReadsASecondFileBehindTheFirst) {
  const Octets file = kPcapHeader + pcapPacket(ethernet(ipv4(udp(kPlot))), 1, 0);
  const Found found = findAll(file + file, Framing::kPcap);
  EXPECT_TRUE(found.faults.empty());
  EXPECT_EQ(found.blocks.size(), 2u);
}

TEST(PcapNg, ReadsPacketsOfItsFirstYears) {
  const Octets packet = ethernet(ipv4(udp(kPlot)));
  const auto size = static_cast<std::uint32_t>(packet.size());
  const Octets file =
      ngBlock(0x0A0D0D0A, little32(0x1A2B3C4D) + Octets{1, 0, 0, 0} + Octets(8, 0xFF)) +
      ngBlock(1, Octets{1, 0, 0, 0} + little32(65535)) +
      ngBlock(2, Octets{0, 0, 7, 0} + little32(0) + little32(2500000) + little32(size) + little32(size) + packet);
  const Found found = findAll(file, Framing::kPcapNg);
  ASSERT_EQ(found.blocks.size(), 1u);
  EXPECT_DOUBLE_EQ(*found.blocks[0].time, 2.5);
}

// A broken file must end in a report, not in a crash.
TEST(PacketFile, SurvivesRandomMutations) {
  auto random = tws::seededGenerator();
  const Octets packet = ethernet(ipv4(udp(kPlot)));
  const auto size = static_cast<std::uint32_t>(packet.size());
  const Octets pcap = kPcapHeader + pcapPacket(packet, 1, 0) + pcapPacket(packet, 2, 0);
  const Octets pcapng = ngBlock(0x0A0D0D0A, little32(0x1A2B3C4D) + Octets{1, 0, 0, 0} + Octets(8, 0xFF)) +
                        ngBlock(1, Octets{1, 0, 0, 0} + little32(65535) + Octets{9, 0, 1, 0, 3, 0, 0, 0, 0, 0, 0, 0}) +
                        ngBlock(6, little32(0) + little32(0) + little32(7) + little32(size) + little32(size) + packet);
  for (int round = 0; round < 20000; ++round) {
    Octets bad = round % 2 == 0 ? pcap : pcapng;
    for (unsigned i = 0; i < 1 + random() % 4; ++i)
      bad[4 + random() % (bad.size() - 4)] = static_cast<std::uint8_t>(random());
    bad.resize(24 + random() % (bad.size() - 23));
    const Found found = findAll(bad, round % 2 == 0 ? Framing::kPcap : Framing::kPcapNg);
    ASSERT_LE(found.blocks.size(), 20u);
  }
}

}  // namespace
}  // namespace asterix_bridge
