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

bool isPcap(Bytes bytes) {
  return begins(bytes, {0xA1, 0xB2, 0xC3, 0xD4}) || begins(bytes, {0xD4, 0xC3, 0xB2, 0xA1}) ||
         begins(bytes, {0xA1, 0xB2, 0x3C, 0x4D}) || begins(bytes, {0x4D, 0x3C, 0xB2, 0xA1});
}

}  // namespace

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
  constexpr std::size_t kMost = 50;
  BlockChain::Fit best;
  Framing framing = Framing::kRaw;
  for (const Framing candidate : {Framing::kRaw, Framing::kTimed, Framing::kRecorder}) {
    const BlockChain::Fit fit = BlockChain(recording, candidate).fit(kMost);
    if (std::pair(fit.good, fit.ends) <= std::pair(best.good, best.ends)) continue;
    best = fit;
    framing = candidate;
  }
  if (best.good == 0 && !best.ends)
    throw std::runtime_error("this is no ASTERIX in a known framing (raw, pcap, pcapng, recorder, length and time)");
  return framing;
}

std::unique_ptr<BlockFinder> findBlocks(Bytes recording, Framing framing) {
  if (framing == Framing::kPcap || framing == Framing::kPcapNg) return std::make_unique<PacketFile>(recording, framing);
  return std::make_unique<BlockChain>(recording, framing);
}

std::vector<FramingStep> blocksOfDatagram(Bytes datagram, std::size_t offset) {
  constexpr std::size_t kAll = 65536;
  const bool timed = BlockChain(datagram, Framing::kTimed).fit(kAll).ends;
  BlockChain chain(datagram, timed ? Framing::kTimed : Framing::kRaw, offset);
  std::vector<FramingStep> steps;
  while (auto step = chain.next()) steps.push_back(*step);
  return steps;
}

}  // namespace asterix_bridge
