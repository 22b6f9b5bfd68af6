#include "fusion_table.h"

#include <algorithm>

#include <tws_core/sectors.h>

namespace track_correlator {

std::int64_t scansBetween(std::int64_t earlier, std::int64_t later) {
  return (later - earlier + tws::kHalfTurn) / tws::kSectors;
}

const FusionRow* FusionTable::find(const Index& index, std::uint32_t uid) const {
  const auto found = index.find(uid);
  return found == index.end() ? nullptr : &rows_.at(found->second);
}

FusionTable::Outcome FusionTable::correlate(std::uint32_t primary, std::uint32_t secondary, std::int64_t running) {
  FusionRow* by_primary = ofPrimary(primary);
  FusionRow* by_secondary = ofSecondary(secondary);
  if (by_primary != nullptr && by_primary == by_secondary) {
    update(*by_primary, running);
    return Outcome::kUpdated;
  }
  if (by_primary != nullptr) return countRival(*by_primary, secondary, running);
  if (by_secondary != nullptr) return countRival(*by_secondary, primary, running);
  return countCandidate(primary, secondary, running);
}

void FusionTable::update(FusionRow& row, std::int64_t running) {
  ++row.fusion_count;
  row.last = running;
  row.rival_count = 0;
}

FusionTable::Outcome FusionTable::countRival(FusionRow& row, std::uint32_t rival, std::int64_t running) {
  const bool consecutive = row.rival_count > 0 && row.rival == rival && scansBetween(row.rival_last, running) <= 1;
  row.rival_count = consecutive ? row.rival_count + 1 : 1;
  row.rival = rival;
  row.rival_last = running;
  if (row.rival_count < params_.parallel_scans) return Outcome::kCounted;
  takeOver(row);
  update(row, running);
  return Outcome::kTakenOver;
}

void FusionTable::takeOver(FusionRow& row) {
  Index& index = row.secondary_lost ? row_of_secondary_ : row_of_primary_;
  std::uint32_t& place = row.secondary_lost ? row.secondary : row.primary;
  const std::uint32_t number = index.at(place);
  index.erase(place);
  place = row.rival;
  // The rival may itself have been left alone by its partner.
  if (const auto old = index.find(place); old != index.end()) remove(rows_.at(old->second));
  index[place] = number;
  (row.secondary_lost ? row.secondary_lost : row.primary_lost) = false;
}

FusionTable::Outcome FusionTable::countCandidate(std::uint32_t primary, std::uint32_t secondary, std::int64_t running) {
  std::vector<Candidate>& own = candidates_[primary];
  own.erase(std::remove_if(own.begin(), own.end(),
                           [&](const Candidate& c) { return scansBetween(c.last, running) >= params_.clear_scans; }),
            own.end());
  auto found = std::find_if(own.begin(), own.end(), [&](const Candidate& c) { return c.secondary == secondary; });
  if (found == own.end()) found = own.insert(own.end(), Candidate{secondary, 0, 0});
  ++found->fusion_count;
  found->last = running;
  if (found->fusion_count <= params_.initiate_above && params_.scheme != Scheme::kDistance) return Outcome::kCounted;
  initiate(primary, *found);
  return Outcome::kInitiated;
}

void FusionTable::initiate(std::uint32_t primary, const Candidate& candidate) {
  FusionRow row;
  row.primary = primary;
  row.secondary = candidate.secondary;
  row.fusion_count = candidate.fusion_count;
  row.last = candidate.last;
  rows_[next_row_] = row;
  row_of_primary_[primary] = row_of_secondary_[candidate.secondary] = next_row_++;
  candidates_.erase(primary);
}

bool FusionTable::losePrimary(std::uint32_t primary) {
  candidates_.erase(primary);
  return lose(ofPrimary(primary), &FusionRow::primary_lost);
}

bool FusionTable::loseSecondary(std::uint32_t secondary) {
  return lose(ofSecondary(secondary), &FusionRow::secondary_lost);
}

bool FusionTable::lose(FusionRow* row, bool FusionRow::*lost) {
  if (row == nullptr) return true;
  row->*lost = true;
  row->rival_count = 0;
  const bool both = row->primary_lost && row->secondary_lost;
  if (both) remove(*row);
  return both;
}

bool FusionTable::expired(const FusionRow& row, std::int64_t running) const {
  return scansBetween(row.last, running) >= params_.clear_scans;
}

void FusionTable::remove(const FusionRow& row) {
  const std::uint32_t number = row_of_primary_.at(row.primary);
  row_of_primary_.erase(row.primary);
  row_of_secondary_.erase(row.secondary);
  rows_.erase(number);
}

}  // namespace track_correlator
