// Packets worked by hand from RFC 768, RFC 791, RFC 1042 and RFC 8200.
#include "datagrams.h"

#include <gtest/gtest.h>

#include "packet_test_helpers.h"

namespace asterix_bridge {
namespace {

Octets payloadOf(Datagrams& datagrams, const Octets& packet, unsigned link) {
  const auto bytes = datagrams.payloadOf(bytesOf(packet), link);
  return bytes ? Octets(bytes->data, bytes->data + bytes->size) : Octets{};
}
Octets payloadOf(const Octets& packet, unsigned link) {
  Datagrams datagrams;
  return payloadOf(datagrams, packet, link);
}
Octets ipv6(std::uint8_t next, const Octets& rest) {
  return Octets{0x60, 0, 0, 0} + big16(rest.size()) + Octets{next, 64} + Octets(32, 1) + rest;
}

// A recording from another machine, switch or network card must not come out empty.
TEST(Datagrams, AreFoundBehindEveryLinkLayer) {
  const Octets ip = ipv4(udp(kPlot));
  EXPECT_EQ(payloadOf(ethernet(ip), 1), kPlot);
  EXPECT_EQ(payloadOf(ethernet(ip) + Octets(11, 0), 1), kPlot);  // padded to the least length of a frame
  const Octets tagged = big16(5) + big16(0x0800) + ip;
  for (const std::size_t vlan : {0x8100, 0x88A8, 0x9100, 0x9200})
    EXPECT_EQ(payloadOf(ethernet(tagged, vlan), 1), kPlot);
  EXPECT_EQ(payloadOf(ethernet(big16(5) + big16(0x8100) + tagged, 0x9100), 1), kPlot);
  EXPECT_EQ(payloadOf(Octets{2, 0, 0, 0} + ip, 0), kPlot);
  EXPECT_EQ(payloadOf(Octets{0, 0, 0, 2} + ip, 108), kPlot);
  for (const unsigned raw : {12u, 14u, 101u, 228u}) EXPECT_EQ(payloadOf(ip, raw), kPlot) << raw;
  EXPECT_EQ(payloadOf(ipv6(17, udp(kPlot)), 229), kPlot);
  EXPECT_EQ(payloadOf(Octets(14, 0) + big16(0x0800) + ip, 113), kPlot);
  EXPECT_EQ(payloadOf(Octets(14, 0) + big16(0x8100) + tagged, 113), kPlot);
  EXPECT_EQ(payloadOf(big16(0x0800) + Octets(18, 0) + ip, 276), kPlot);
  EXPECT_EQ(payloadOf(ethernet(ipv6(17, udp(kPlot)), 0x86DD), 1), kPlot);
}

TEST(Datagrams, AreFoundBehindLlc) {
  const Octets snap = Octets{0xAA, 0xAA, 3, 0, 0, 0} + big16(0x0800) + ipv4(udp(kPlot));
  EXPECT_EQ(payloadOf(ethernet(snap, snap.size()), 1), kPlot);
  const Octets bare = Octets{0xFE, 0xFE, 3} + kPlot;
  EXPECT_EQ(payloadOf(ethernet(bare + Octets(28, 0), bare.size()), 1), kPlot);  // padded
}

TEST(Datagrams, AreFoundBehindExtensionHeadersOfIpv6) {
  const Octets options = Octets{43, 0, 1, 4, 0, 0, 0, 0} + Octets{17, 1} + Octets(14, 0) + udp(kPlot);
  EXPECT_EQ(payloadOf(ethernet(ipv6(0, options), 0x86DD), 1), kPlot);
}

// Sectors with many plots do not fit into one Ethernet frame.
TEST(Datagrams, ArePutTogetherFromFragmentsInAnyOrder) {
  Octets large;
  for (int i = 0; i < 200; ++i) large = large + kPlot;
  const Octets whole = udp(large);
  const auto part = [&](std::size_t from, std::size_t to) { return Octets(whole.data() + from, whole.data() + to); };
  const Octets first = ipv4(part(0, 1480), 17, 0x2000);
  const Octets second = ipv4(part(1480, 2960), 17, 0x2000 | 185);
  const Octets last = ipv4(part(2960, whole.size()), 17, 370);
  Datagrams datagrams;
  EXPECT_TRUE(payloadOf(datagrams, last, 101).empty());
  EXPECT_TRUE(payloadOf(datagrams, first, 101).empty());
  EXPECT_TRUE(payloadOf(datagrams, first, 101).empty());
  EXPECT_EQ(payloadOf(datagrams, second, 101), large);
}

TEST(Datagrams, HoldFewUnfinishedOnes) {
  Datagrams datagrams;
  const auto fragment = [](std::uint8_t id, std::size_t flags) {
    Octets packet = ipv4(flags == 1 ? Octets(7, 1) : udp(Octets{}), 17, flags);
    packet[5] = id;
    return packet;
  };
  for (int id = 0; id < 200; ++id) payloadOf(datagrams, fragment(static_cast<std::uint8_t>(id), 0x2000), 101);
  EXPECT_FALSE(datagrams.payloadOf(bytesOf(fragment(0, 1)), 101));  // its first part is forgotten
}

TEST(Datagrams, AreRefusedWithTheReason) {
  const auto reason = [](const Octets& packet, unsigned link) {
    try {
      payloadOf(packet, link);
      return std::string("none");
    } catch (const DecodeError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(reason(ethernet(ipv4(udp(kPlot), 6)), 1), "TCP, no UDP datagram");
  EXPECT_EQ(reason(ethernet(ipv4(udp(kPlot), 1)), 1), "no UDP datagram");
  EXPECT_EQ(reason(ethernet(Octets(28, 0), 0x0806), 1), "no IP packet");
  EXPECT_EQ(reason(ethernet(ipv4(udp(kPlot))), 147), "link type 147 is not known; `editcap -T ether` may help");
  Octets cut = ethernet(ipv4(udp(kPlot)));
  cut.resize(50);
  EXPECT_EQ(reason(cut, 1), "needs 23 bytes, 16 are left");
}

}  // namespace
}  // namespace asterix_bridge
