#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "byte_reader.h"

namespace asterix_bridge {

/// What stands around the data blocks of a recording.
enum class Framing {
  kRaw,       // nothing: block after block
  kRecorder,  // a header of 2200 bytes; after each block 10 bytes, of which 6 to 8 are the time of day [1/128 s]
  kTimed,     // before each block its length, these 6 bytes included, and the time of day [ms], 2 and 4 bytes
  kPcap,      // packets as tcpdump writes them, with microseconds or nanoseconds
  kPcapNg,    // packets as Wireshark writes them
  kRff,       // a header of 128 bytes with dates; before each block 4 bytes time [ms] and 2 bytes length, LSB first
  kFinal,     // IOSS final: before each block 8 bytes, their length with all around first, the time of day [1/100 s]
              // last; behind it four times A5
};
std::string toText(Framing framing);

/// One data block as it was found.
struct FramedBlock {
  Bytes bytes;                        // of the recording's buffer, from the category on; as long as the block says
  std::size_t offset = 0;             // in the recording
  std::optional<double> time_of_day;  // of reception, UTC [s]
  std::optional<double> time;         // of reception, since 1970 [s]
};

/// What was passed over because it is no data block.
struct FramingFault {
  std::size_t offset = 0;
  std::string reason;
};

/// One step through a recording: a block, or a fault, never both.
struct FramingStep {
  std::optional<FramedBlock> block;
  std::optional<FramingFault> fault;
};

/// Walks through the blocks of a buffer, which must outlive it. What is broken is passed over to the next block that
/// fits: each such place is one fault.
class BlockFinder {
 public:
  virtual ~BlockFinder() = default;
  /// Nothing: the end.
  virtual std::optional<FramingStep> next() = 0;
};

/// Whether a pcap file's header begins here.
bool isPcap(Bytes bytes);
/// The framing that a recording's bytes show, by up to a megabyte of them. Throws std::runtime_error that says why when
/// they show none.
Framing detectFraming(Bytes recording);
std::unique_ptr<BlockFinder> findBlocks(Bytes recording, Framing framing);

/// The blocks of one datagram, raw or timed; `offset` is where it stands in the recording.
std::vector<FramingStep> blocksOfDatagram(Bytes datagram, std::size_t offset = 0);

}  // namespace asterix_bridge
