#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace track_correlator {

/// What happens when the correlation of a pair ends and another partner appears.
enum class Scheme {
  kParallelCounter,  ///< Three scans in the gate while the track coasts (the paper's second scheme).
  kPlain,            ///< The row is cleared first, and the new pair initiated as any other: seven scans.
  kDistance          ///< No history at all: what is nearest now is correlated. For comparison.
};

struct FusionParams {
  Scheme scheme = Scheme::kParallelCounter;
  int initiate_above = 2;  ///< A pair is correlated when its fusion count exceeds this.
  int clear_scans = 5;     ///< A row without an update for so many scans is cleared (m1).
  int parallel_scans = 3;  ///< Consecutive scans that let a new partner take over.
};

/// A row of the fusion table, figure 6, without the tracks' parameters. Tracks are named by their uids, time is the
/// running sector of the clock.
struct FusionRow {
  std::uint32_t primary = 0, secondary = 0;
  bool primary_lost = false, secondary_lost = false;
  std::int64_t last = 0;  ///< Running sector at the last correlation; its turn is the scan count (n_sc).
  int fusion_count = 0;   ///< n_fc

  // The parallel counter.
  std::uint32_t rival = 0;  ///< The track that would take the lost one's place.
  int rival_count = 0;
  std::int64_t rival_last = 0;
  int outside = 0;  ///< Consecutive scans beyond the release distance.
};

/// Whole turns from one running sector to another, to the nearest.
std::int64_t scansBetween(std::int64_t earlier, std::int64_t later);

/// The history of correlations. Rows that are initiated hold one primary and one secondary exclusively; pairs on their
/// way there are only counted.
class FusionTable {
 public:
  enum class Outcome { kCounted, kInitiated, kUpdated, kTakenOver };

  explicit FusionTable(const FusionParams& params) : params_(params) {}

  /// The initiated row of a track; null: none.
  FusionRow* ofPrimary(std::uint32_t primary) { return find(row_of_primary_, primary); }
  FusionRow* ofSecondary(std::uint32_t secondary) { return find(row_of_secondary_, secondary); }

  const FusionRow* ofPrimary(std::uint32_t primary) const { return find(row_of_primary_, primary); }
  const FusionRow* ofSecondary(std::uint32_t secondary) const { return find(row_of_secondary_, secondary); }

  /// The pair has been associated in the sector `running`: subroutine 1, and the parallel counter when one of them
  /// belongs to a row whose other track is lost. kTakenOver: such a row now holds this pair.
  Outcome correlate(std::uint32_t primary, std::uint32_t secondary, std::int64_t running);

  /// The row's pair is correlated once more, by distance or by history.
  void update(FusionRow& row, std::int64_t running);

  /// The track exists no more: its row coasts, or is removed when both are lost. True: nobody else holds its place.
  bool losePrimary(std::uint32_t primary);
  bool loseSecondary(std::uint32_t secondary);

  /// A row that has not been updated for so many scans is to be cleared.
  bool expired(const FusionRow& row, std::int64_t running) const;
  void remove(const FusionRow& row);

  std::size_t rows() const { return rows_.size(); }

 private:
  struct Candidate {
    std::uint32_t secondary = 0;
    int fusion_count = 0;
    std::int64_t last = 0;
  };
  using Index = std::unordered_map<std::uint32_t, std::uint32_t>;

  FusionRow* find(const Index& index, std::uint32_t uid) {
    return const_cast<FusionRow*>(std::as_const(*this).find(index, uid));
  }
  const FusionRow* find(const Index& index, std::uint32_t uid) const;
  bool lose(FusionRow* row, bool FusionRow::*lost);
  Outcome countRival(FusionRow& row, std::uint32_t rival, std::int64_t running);
  void takeOver(FusionRow& row);
  Outcome countCandidate(std::uint32_t primary, std::uint32_t secondary, std::int64_t running);
  void initiate(std::uint32_t primary, const Candidate& candidate);

  FusionParams params_;
  std::map<std::uint32_t, FusionRow> rows_;  // by a number of their own
  Index row_of_primary_, row_of_secondary_;
  std::unordered_map<std::uint32_t, std::vector<Candidate>> candidates_;  // of each primary
  std::uint32_t next_row_ = 0;
};

}  // namespace track_correlator
