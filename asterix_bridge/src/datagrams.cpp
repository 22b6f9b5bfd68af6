#include "datagrams.h"

#include <algorithm>

namespace asterix_bridge {
namespace {

constexpr std::uint16_t kIpv4 = 0x0800;
constexpr std::uint16_t kIpv6 = 0x86DD;
constexpr std::uint16_t kLlc = 0x05DC;  // types up to this are lengths: LLC follows
constexpr std::uint16_t kBare = 1;      // ASTERIX right behind LLC
constexpr std::uint8_t kUdp = 17;
constexpr std::size_t kMostOpen = 64;
constexpr std::size_t kGreatestDatagram = 65535;

struct Network {
  std::uint16_t type;
  ByteReader reader;
};

bool isVlan(std::uint16_t type) { return type == 0x8100 || type == 0x88A8 || type == 0x9100 || type == 0x9200; }

std::uint16_t behindVlans(ByteReader& reader, std::uint16_t type) {
  while (isVlan(type)) {
    reader.take(2);
    type = reader.u16();
  }
  return type;
}

// An Ethernet frame with a length in place of a type; what pads it to 60 bytes stays out.
Network readLlc(ByteReader& reader, std::size_t length) {
  const std::size_t offset = reader.offset();
  ByteReader llc(reader.take(std::min(length, reader.remaining())), offset);
  const std::uint16_t points = llc.u16();
  llc.take(1);
  if (points != 0xAAAA) return {kBare, llc};
  llc.take(3);
  const std::uint16_t type = llc.u16();
  return {type, llc};
}

Network readEthernet(ByteReader& reader) {
  reader.take(12);
  const std::uint16_t type = behindVlans(reader, reader.u16());
  return type <= kLlc ? readLlc(reader, type) : Network{type, reader};
}

// Reads the link layer away.
Network readLink(ByteReader& reader, unsigned link) {
  std::uint16_t type = 0;
  switch (link) {
    case 1:
      return readEthernet(reader);
    case 113:
      reader.take(14);
      type = behindVlans(reader, reader.u16());
      return {type, reader};
    case 276:
      type = reader.u16();
      reader.take(18);
      type = behindVlans(reader, type);
      return {type, reader};
    case 0:    // four bytes in the order of the recording machine, or
    case 108:  // of the network
      reader.take(4);
      break;
    case 12:
    case 14:
    case 101:
    case 228:
    case 229:
      break;
    default:
      throw DecodeError(0, "link type " + std::to_string(link) + " is not known; `editcap -T ether` may help");
  }
  ByteReader ahead = reader;
  return {ahead.u8() >> 4 == 6 ? kIpv6 : kIpv4, reader};
}

void append(std::vector<std::uint8_t>& key, Bytes bytes) { key.insert(key.end(), bytes.data, bytes.data + bytes.size); }

void checkProtocol(std::uint8_t protocol, std::size_t offset) {
  constexpr std::uint8_t kTcp = 6;
  if (protocol == kTcp) throw DecodeError(offset, "TCP, no UDP datagram");
  if (protocol != kUdp) throw DecodeError(offset, "no UDP datagram");
}

Bytes udpPayload(ByteReader udp) {
  udp.take(4);
  const std::size_t length = udp.u16();
  udp.take(2);
  if (length < 8) throw DecodeError(udp.offset(), "UDP length " + std::to_string(length));
  return udp.take(length - 8);
}

}  // namespace

std::optional<Bytes> Datagrams::payloadOf(Bytes packet, unsigned link) {
  ByteReader whole(packet);
  Network network = readLink(whole, link);
  ByteReader& reader = network.reader;
  if (network.type == kBare) return reader.take(reader.remaining());
  if (network.type == kIpv4) return ofIpv4(reader);
  if (network.type == kIpv6) return ofIpv6(reader);
  throw DecodeError(reader.offset(), "no IP packet");
}

// Without what pads the packet behind its end.
std::optional<Bytes> Datagrams::ofIpv4(ByteReader& reader) {
  const std::size_t header = std::size_t{4} * (reader.u8() & 15u);
  reader.take(1);
  const std::size_t total = reader.u16();
  std::vector<std::uint8_t> key{4};
  append(key, reader.take(2));
  const unsigned flags = reader.u16();
  reader.take(1);
  const std::uint8_t protocol = reader.u8();
  checkProtocol(protocol, reader.offset());
  reader.take(2);
  append(key, reader.take(8));
  reader.take(header < 20 ? reader.remaining() + 1 : header - 20);
  const std::size_t rest =
      total == 0 ? reader.remaining() : total - std::min(total, header);  // 0: left to the network card
  const std::size_t offset = reader.offset();
  const Bytes bytes = reader.take(rest);
  if (!(flags & 0x3FFFu)) return udpPayload(ByteReader(bytes, offset));
  return add(key, {(flags & 0x1FFFu) * std::size_t{8}, !(flags & 0x2000u), bytes});
}

std::optional<Bytes> Datagrams::ofIpv6(ByteReader& reader) {
  constexpr std::uint8_t kHopByHop = 0, kRouting = 43, kFragment = 44, kDestination = 60;
  reader.take(4);
  const std::size_t rest = reader.u16();
  std::uint8_t next = reader.u8();
  reader.take(1);
  std::vector<std::uint8_t> key{6};
  append(key, reader.take(32));
  const std::size_t offset = reader.offset();
  ByteReader body(reader.take(rest == 0 ? reader.remaining() : rest), offset);
  while (next == kHopByHop || next == kRouting || next == kDestination) {
    next = body.u8();
    const std::size_t length = body.u8() * std::size_t{8} + 6;
    body.take(length);
  }
  if (next != kFragment) {
    checkProtocol(next, body.offset());
    return udpPayload(body);
  }
  next = body.u8();
  checkProtocol(next, body.offset());
  body.take(1);
  const unsigned place = body.u16();
  append(key, body.take(4));
  return add(key, {place & 0xFFF8u, !(place & 1u), body.take(body.remaining())});
}

Datagrams::Parts& Datagrams::partsOf(const std::vector<std::uint8_t>& key) {
  const auto found = std::find_if(open_.begin(), open_.end(), [&](const Parts& parts) { return parts.key == key; });
  if (found != open_.end()) return *found;
  if (open_.size() == kMostOpen) open_.pop_front();
  Parts parts;
  parts.key = key;
  open_.push_back(std::move(parts));
  return open_.back();
}

std::optional<Bytes> Datagrams::add(const std::vector<std::uint8_t>& key, const Fragment& fragment) {
  if (fragment.offset + fragment.bytes.size > kGreatestDatagram)
    throw DecodeError(0, "a fragment beyond the greatest datagram");
  Parts& parts = partsOf(key);
  const Bytes bytes = fragment.bytes;
  if (!parts.parts.try_emplace(fragment.offset, bytes.data, bytes.data + bytes.size).second) return std::nullopt;
  parts.held += bytes.size;
  if (fragment.is_last) parts.size = fragment.offset + bytes.size;
  if (!complete(parts)) return std::nullopt;
  open_.erase(std::find_if(open_.begin(), open_.end(), [&](const Parts& other) { return other.key == key; }));
  return udpPayload(ByteReader({assembled_.data(), assembled_.size()}));
}

// Puts the parts together when they leave no gap.
bool Datagrams::complete(const Parts& parts) {
  if (!parts.size || parts.held < *parts.size) return false;
  assembled_.clear();
  for (const auto& [offset, bytes] : parts.parts) {
    if (offset != assembled_.size()) return false;
    assembled_.insert(assembled_.end(), bytes.begin(), bytes.end());
  }
  return assembled_.size() == *parts.size;
}

}  // namespace asterix_bridge
