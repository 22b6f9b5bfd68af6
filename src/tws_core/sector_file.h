#pragma once

#include <cstdint>
#include <vector>

#include <tws_core/sectors.h>

namespace tws {

/// Which track (or clutter) numbers lie in which azimuth sector: a chain of numbers for each sector. NRL Report 7952,
/// "Track-Number Assignment to Azimuth-Sector Files" (TBX/IDT, CBX/IDC). Firm tracks go first, tentative ones last.
/// Linked both ways, so that adding and removing are O(1) anywhere, without the report's NTL.
///
///   for (auto n = file.first(sector); n != SectorFile::kNone; n = next) {
///     next = file.next(n);   // before n may be removed or moved
///     …
///   }
class SectorFile {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// For numbers 0..numbers-1. Throws std::invalid_argument when sectors < 1.
  explicit SectorFile(std::uint32_t numbers, int sectors = kSectors);

  /// Both throw std::invalid_argument when the number is unknown or already in a sector, or the sector unknown.
  void addFirst(std::uint32_t number, int sector) {
    checkAdd(number, sector);
    link(number, sector, kNone, sectors_[index(sector)].first);
  }
  void addLast(std::uint32_t number, int sector) {
    checkAdd(number, sector);
    link(number, sector, sectors_[index(sector)].last, kNone);
  }

  /// Throws std::invalid_argument when the number is in no sector.
  void remove(std::uint32_t number) {
    if (sector(number) < 0) refuse("remove: is in no sector", number, -1);
    Link& own = links_[number];
    Chain& chain = sectors_[index(own.sector)];
    (own.previous == kNone ? chain.first : links_[own.previous].next) = own.next;
    (own.next == kNone ? chain.last : links_[own.next].previous) = own.previous;
    --chain.count;
    own = Link{};
  }

  /// The sector the number is in; -1: none, also for an unknown number.
  int sector(std::uint32_t number) const { return number < links_.size() ? links_[number].sector : -1; }
  /// kNone when the sector is empty. Sectors are not checked: 0..sectors-1.
  std::uint32_t first(int sector) const { return sectors_[index(sector)].first; }
  /// The number that follows in the same sector; kNone after the last. Numbers are not checked either.
  std::uint32_t next(std::uint32_t number) const { return links_[number].next; }
  std::uint32_t count(int sector) const { return sectors_[index(sector)].count; }

 private:
  struct Link {
    std::uint32_t next = kNone;
    std::uint32_t previous = kNone;
    std::int32_t sector = -1;
  };
  struct Chain {
    std::uint32_t first = kNone;
    std::uint32_t last = kNone;
    std::uint32_t count = 0;
  };

  static std::size_t index(int sector) { return static_cast<std::size_t>(sector); }

  void checkAdd(std::uint32_t number, int sector) const {
    if (number >= links_.size()) refuse("add: is unknown", number, sector);
    if (links_[number].sector >= 0) refuse("add: is in a sector already", number, sector);
    if (sector < 0 || index(sector) >= sectors_.size()) refuse("add: no such sector", number, sector);
  }

  void link(std::uint32_t number, int sector, std::uint32_t previous, std::uint32_t next) {
    Chain& chain = sectors_[index(sector)];
    (previous == kNone ? chain.first : links_[previous].next) = number;
    (next == kNone ? chain.last : links_[next].previous) = number;
    links_[number] = {next, previous, sector};
    ++chain.count;
  }

  [[noreturn]] static void refuse(const char* why, std::uint32_t number, int sector);

  std::vector<Link> links_;     // IDT, and the way back
  std::vector<Chain> sectors_;  // TBX
};

}  // namespace tws
