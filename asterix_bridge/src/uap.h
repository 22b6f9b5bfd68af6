#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "byte_reader.h"

namespace asterix_bridge {

/// How the length of a data item is found (EUROCONTROL-SPEC-0149 part 1, section 4.3).
enum class Format : std::uint8_t {
  kSpare,       // no item has this number
  kFixed,       // `length` octets
  kExtended,    // single octets, as long as their last bit (FX) is set
  kRepetitive,  // one octet with a count, then so many times `length` octets
  kCompound,    // octets of presence bits as long as FX is set, then the subfields in `parts`
  kExplicit,    // one octet with the length, itself included: RE and SP
  kRandom,      // random field sequencing: a count, then so many pairs of field reference number and field
};

/// One data item of a user application profile (UAP) and what becomes of it: `decode` gets exactly the item's octets;
/// without it the item is skipped.
template <class Record>
struct Item {
  const char* name = "";
  Format format = Format::kSpare;
  std::uint8_t length = 0;  // [octets]
  void (*decode)(ByteReader& octets, Record& record) = nullptr;
  const Item* parts = nullptr;  // of a compound item
  std::size_t part_count = 0;
};

/// The items in the order of their field reference numbers (FRN), which count from 1.
template <class Record>
struct Uap {
  const Item<Record>* items = nullptr;
  std::size_t count = 0;
};

}  // namespace asterix_bridge
