#include "framing.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "block_chain.h"
#include "packets.h"

namespace asterix_bridge {
namespace {

bool begins(Bytes bytes, std::initializer_list<std::uint8_t> start) {
  return bytes.size >= start.size() && std::equal(start.begin(), start.end(), bytes.data);
}

// How a file of blocks looks in one framing.
struct Look {
  long good = 0;    // blocks of a category that is decoded, without a fault
  long others = 0;  // further blocks
  long faults = 0;  // places at which no block fits
};

// Many good blocks and few places between them tell a framing; the first bytes may be anything.
Look lookAs(Framing framing, Bytes recording) {
  constexpr std::size_t kMost = 1 << 20;  // bytes
  constexpr long kEnough = 1000;          // steps
  BlockChain chain(recording, framing);
  Look look;
  Block block;
  while (chain.position() < kMost && look.good + look.others + look.faults < kEnough) {
    const auto step = chain.next();
    if (!step) break;
    if (step->block) decodeBlock(step->block->bytes, 0, block);
    ++(step->fault ? look.faults : block.fault ? look.others : look.good);
  }
  return look;
}

bool isBetter(const Look& a, const Look& b) {
  if ((a.good > 0) != (b.good > 0)) return a.good > 0;
  return a.good > 0 ? a.good - a.faults > b.good - b.faults : a.others - a.faults > b.others - b.faults;
}

bool isText(Bytes bytes) {
  const std::size_t size = std::min<std::size_t>(bytes.size, 4096);
  const auto is_plain = [](std::uint8_t byte) { return (byte >= 0x20 && byte < 0x7F) || (byte >= 9 && byte <= 13); };
  return static_cast<std::size_t>(std::count_if(bytes.data, bytes.data + size, is_plain)) * 20 >= size * 19;
}

// What a file of another kind is, and the next step; empty: it may be ASTERIX.
std::string otherKind(Bytes bytes) {
  if (begins(bytes, {'#', 'R', 'O', 'S', 'B', 'A', 'G'})) return "this is a bag; name it FILE.bag";
  if (begins(bytes, {0x1F, 0x8B}) || begins(bytes, {'P', 'K', 3, 4}))
    return "this is a compressed file; unpack it first";
  if (begins(bytes, {0x34, 0xCD, 0xB2, 0xA1}) || begins(bytes, {0xA1, 0xB2, 0xCD, 0x34}))
    return "this is a modified pcap file (magic A1B2CD34), whose packets' headers are of several kinds; `editcap -F "
           "pcap "
           "IN OUT` makes a plain one of it";
  if (begins(bytes, {0xFF, 0xFE}) || begins(bytes, {0xFE, 0xFF})) return "this is text in UTF-16, no ASTERIX";
  return "";
}

// What a file is that shows no framing.
std::string whatItIs(Bytes bytes) {
  if (bytes.size < 8) return std::to_string(bytes.size) + " bytes are too few for an ASTERIX record";
  if (isText(bytes)) return "this is text, no ASTERIX; plots in a CSV file go into adit_csv";
  return "this is no ASTERIX in a known framing (raw, pcap, pcapng, recorder, length and time, RFF, IOSS final)";
}

}  // namespace

bool isPcap(Bytes bytes) {
  return begins(bytes, {0xA1, 0xB2, 0xC3, 0xD4}) || begins(bytes, {0xD4, 0xC3, 0xB2, 0xA1}) ||
         begins(bytes, {0xA1, 0xB2, 0x3C, 0x4D}) || begins(bytes, {0x4D, 0x3C, 0xB2, 0xA1});
}

std::string toText(Framing framing) {
  switch (framing) {
    case Framing::kRaw:
      return "raw blocks";
    case Framing::kRecorder:
      return "recorder, header of 2200 bytes";
    case Framing::kTimed:
      return "blocks with length and time";
    case Framing::kPcap:
      return "pcap";
    case Framing::kRff:
      return "RFF";
    case Framing::kFinal:
      return "IOSS final";
    case Framing::kPcapNg:
      break;
  }
  return "pcapng";
}

// Of the framings without a mark of their own, the one that gives most good blocks; without any, the one that leads
// through the whole file.
Framing detectFraming(Bytes recording) {
  if (recording.size == 0) throw std::runtime_error("the file is empty");
  if (isPcap(recording)) return Framing::kPcap;
  if (begins(recording, {0x0A, 0x0D, 0x0D, 0x0A})) return Framing::kPcapNg;
  if (const std::string other = otherKind(recording); !other.empty()) throw std::runtime_error(other);
  Look best;
  Framing framing = Framing::kRaw;
  for (const Framing candidate : {Framing::kRaw, Framing::kTimed, Framing::kRecorder, Framing::kRff, Framing::kFinal}) {
    const Look look = lookAs(candidate, recording);
    if (!isBetter(look, best)) continue;
    best = look;
    framing = candidate;
  }
  constexpr long kFew = 3;  // places that any file may have
  if (best.good + best.others == 0 || best.faults > std::max(kFew, best.good + best.others))
    throw std::runtime_error(whatItIs(recording));
  return framing;
}

std::unique_ptr<BlockFinder> findBlocks(Bytes recording, Framing framing) {
  if (framing == Framing::kPcap || framing == Framing::kPcapNg) return std::make_unique<PacketFile>(recording, framing);
  return std::make_unique<BlockChain>(recording, framing);
}

std::vector<FramingStep> blocksOfDatagram(Bytes datagram, std::size_t offset) {
  constexpr std::size_t kAll = 65536;
  const auto fits = [&](Framing framing) { return BlockChain(datagram, framing).leadsToTheEnd(kAll); };
  const Framing framing = fits(Framing::kTimed)   ? Framing::kTimed
                          : fits(Framing::kFinal) ? Framing::kFinal
                                                  : Framing::kRaw;
  BlockChain chain(datagram, framing, offset);
  std::vector<FramingStep> steps;
  while (auto step = chain.next()) steps.push_back(*step);
  return steps;
}

}  // namespace asterix_bridge
