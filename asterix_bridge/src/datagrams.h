#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "byte_reader.h"

namespace asterix_bridge {

/// Takes captured packets and gives the payloads of their UDP datagrams; fragments are put together.
class Datagrams {
 public:
  /// Nothing: a fragment whose datagram is not complete yet. The bytes are the packet's, or good until the next call.
  /// `link` is the link-layer type of pcap files: Ethernet (1; with or without VLAN, LLC with SNAP, or LLC with ASTERIX
  /// right behind it), null and loop (0, 108), raw IP (12, 14, 101, 228, 229), Linux cooked (113, 276). Throws
  /// DecodeError that says why there is no payload.
  std::optional<Bytes> payloadOf(Bytes packet, unsigned link);

 private:
  struct Fragment {
    std::size_t offset;
    bool is_last;
    Bytes bytes;
  };
  struct Parts {
    std::vector<std::uint8_t> key;  // addresses, protocol, identification
    std::map<std::size_t, std::vector<std::uint8_t>> parts;
    std::size_t held = 0;  // bytes in them
    std::optional<std::size_t> size;
  };
  std::optional<Bytes> ofIpv4(ByteReader& reader);
  std::optional<Bytes> ofIpv6(ByteReader& reader);
  std::optional<Bytes> add(const std::vector<std::uint8_t>& key, const Fragment& fragment);
  Parts& partsOf(const std::vector<std::uint8_t>& key);
  bool complete(const Parts& parts);

  std::deque<Parts> open_;               // the oldest first, at most kMostOpen
  std::vector<std::uint8_t> assembled_;  // the latest whole datagram
};

}  // namespace asterix_bridge
