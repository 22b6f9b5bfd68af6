#include "packets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asterix_bridge {
namespace {

constexpr std::size_t kPcapHeader = 24;

}  // namespace

PacketFile::PacketFile(Bytes recording, Framing framing) : recording_(recording), framing_(framing) {
  if (framing != Framing::kPcap) return;
  if (recording.size < kPcapHeader) throw std::runtime_error("the header of the pcap file is cut");
  readPcapHeader();
}

void PacketFile::readPcapHeader() {
  is_swapped_ = recording_.data[position_] == 0xD4 || recording_.data[position_] == 0x4D;
  const std::uint32_t magic = u32(position_);
  interfaces_.assign(1, {u32(position_ + 20) & 0xFFFFu, magic == 0xA1B23C4D ? 1e-9 : 1e-6});
  position_ += kPcapHeader;
}

std::uint16_t PacketFile::u16(std::size_t position) const {
  const std::uint8_t* p = recording_.data + position;
  return static_cast<std::uint16_t>(is_swapped_ ? p[0] | p[1] << 8 : p[0] << 8 | p[1]);
}

std::uint32_t PacketFile::u32(std::size_t position) const {
  const std::uint32_t first = u16(position);
  const std::uint32_t second = u16(position + 2);
  return is_swapped_ ? second << 16 | first : first << 16 | second;
}

std::optional<FramingStep> PacketFile::next() {
  while (steps_.empty()) {
    const std::optional<Packet> packet = nextPacket();
    if (packet) add(*packet);
    if (!packet && steps_.empty()) return std::nullopt;
  }
  FramingStep step = steps_.front();
  steps_.pop_front();
  return step;
}

std::optional<PacketFile::Packet> PacketFile::nextPacket() {
  if (position_ >= recording_.size) return std::nullopt;
  return framing_ == Framing::kPcap ? nextPcap() : nextPcapNg();
}

// What cannot be read ends the file: the next packet's place is known by this one's length only.
void PacketFile::fail(const std::string& reason) {
  FramingStep step;
  step.fault = FramingFault{position_, reason + "; the rest of the file cannot be read"};
  steps_.push_back(step);
  position_ = recording_.size;
}

// Files that were put one behind the other by `cat` have a header in the middle.
std::optional<PacketFile::Packet> PacketFile::nextPcap() {
  const Bytes rest{recording_.data + position_, recording_.size - position_};
  if (rest.size >= kPcapHeader && isPcap(rest)) readPcapHeader();
  const std::size_t left = recording_.size - position_;
  if (left == 0) return std::nullopt;
  const std::size_t length = left < 16 ? left : u32(position_ + 8);
  if (left < 16 || length > left - 16) {
    fail("packet cut by the end of the file");
    return std::nullopt;
  }
  const double time = u32(position_) + u32(position_ + 4) * interfaces_[0].tick;
  const Packet packet{{recording_.data + position_ + 16, length}, position_ + 16, interfaces_[0].link, time};
  position_ += 16 + length;
  return packet;
}

std::optional<PacketFile::Packet> PacketFile::nextPcapNg() {
  constexpr std::uint32_t kSection = 0x0A0D0D0A;
  while (position_ < recording_.size) {
    const std::size_t left = recording_.size - position_;
    if (left >= 12 && u32(position_) == kSection) {
      is_swapped_ = recording_.data[position_ + 8] == 0x4D;
      interfaces_.clear();
    }
    const std::size_t length = left < 12 ? 0 : u32(position_ + 4);
    if (length < 12 || length > left || length % 4 != 0) {
      fail("block of the pcapng file cut or broken");
      return std::nullopt;
    }
    const std::size_t start = position_;
    const std::optional<Packet> packet = readPcapNgBlock(u32(start), start, length);
    position_ = start + length;
    if (packet) return packet;
  }
  return std::nullopt;
}

std::optional<PacketFile::Packet> PacketFile::readPcapNgBlock(std::uint32_t type, std::size_t start,
                                                              std::size_t length) {
  constexpr std::uint32_t kInterface = 1, kOld = 2, kSimple = 3, kEnhanced = 6;
  if (type == kInterface && length >= 20) addInterface(start, length);
  if (type == kSimple && length >= 16 && !interfaces_.empty()) {
    const std::size_t size = std::min<std::size_t>(u32(start + 8), length - 16);
    return Packet{{recording_.data + start + 12, size}, start + 12, interfaces_[0].link, std::nullopt};
  }
  if ((type != kEnhanced && type != kOld) || length < 32) return std::nullopt;
  const std::uint32_t interface = type == kOld ? u16(start + 8) : u32(start + 8);  // the old one counts drops behind
  const std::size_t size = u32(start + 20);
  if (interface >= interfaces_.size() || size > length - 32) return std::nullopt;
  const double ticks = u32(start + 12) * 4294967296.0 + u32(start + 16);
  return Packet{{recording_.data + start + 28, size},
                start + 28,
                interfaces_[interface].link,
                ticks * interfaces_[interface].tick};
}

// Option 9, if_tsresol, is the resolution of time: a power of ten, or of two with the first bit set.
void PacketFile::addInterface(std::size_t start, std::size_t length) {
  Interface interface { u16(start + 8), 1e-6 };
  const std::size_t end = start + length - 4;
  for (std::size_t option = start + 16; option + 4 <= end && u16(option) != 0;) {
    const std::size_t size = u16(option + 2);
    if (u16(option) == 9 && size >= 1 && option + 5 <= end) {
      const std::uint8_t resolution = recording_.data[option + 4];
      interface.tick = resolution & 0x80u ? std::ldexp(1.0, -(resolution & 0x7F)) : std::pow(10.0, -resolution);
    }
    option += 4 + (size + 3) / 4 * 4;
  }
  interfaces_.push_back(interface);
}

void PacketFile::add(const Packet& packet) {
  try {
    const std::optional<Bytes> payload = datagrams_.payloadOf(packet.bytes, packet.link);
    if (!payload) return;
    const bool is_inside = payload->data >= packet.bytes.data && payload->data <= packet.bytes.data + packet.bytes.size;
    const auto ahead = is_inside ? static_cast<std::size_t>(payload->data - packet.bytes.data) : 0;
    for (FramingStep& step : blocksOfDatagram(*payload, packet.offset + ahead)) {
      if (step.block) step.block->time = packet.time;
      steps_.push_back(step);
    }
  } catch (const DecodeError& error) {
    FramingStep step;
    step.fault = FramingFault{packet.offset + error.offset(), error.what()};
    steps_.push_back(step);
  }
}

}  // namespace asterix_bridge
