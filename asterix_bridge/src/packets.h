#pragma once

#include <deque>

#include "datagrams.h"
#include "framing.h"

namespace asterix_bridge {

/// The blocks of the UDP datagrams in a file of packets, pcap or pcapng.
class PacketFile : public BlockFinder {
 public:
  /// Throws std::runtime_error when the file's header is broken.
  PacketFile(Bytes recording, Framing framing);
  std::optional<FramingStep> next() override;

 private:
  struct Interface {
    unsigned link;
    double tick;  // of its time stamps [s]
  };
  struct Packet {
    Bytes bytes;
    std::size_t offset;
    unsigned link;
    std::optional<double> time;  // since 1970 [s]
  };

  void readPcapHeader();
  std::uint32_t u32(std::size_t position) const;
  std::uint16_t u16(std::size_t position) const;
  std::optional<Packet> nextPacket();
  std::optional<Packet> nextPcap();
  std::optional<Packet> nextPcapNg();
  std::optional<Packet> readPcapNgBlock(std::uint32_t type, std::size_t start, std::size_t length);
  void addInterface(std::size_t start, std::size_t length);
  void add(const Packet& packet);
  void fail(const std::string& reason);

  Bytes recording_;
  Framing framing_;
  bool is_swapped_ = false;  // least significant byte first
  std::size_t position_ = 0;
  std::vector<Interface> interfaces_;
  Datagrams datagrams_;
  std::deque<FramingStep> steps_;
};

}  // namespace asterix_bridge
