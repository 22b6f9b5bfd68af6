#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "association.h"
#include "fusion_table.h"
#include "known_tracks.h"
#include "mark_clock.h"

namespace track_correlator {

struct CorrelatorParams {
  int delay_sectors = 2;         ///< Sectors behind the clock's beam (Δ₂), 2 .. 32.
  double gate = 18.5;            ///< Greatest squared distance, normalised, 4 degrees of freedom: 99.9 %.
  double position_bias = 100.0;  ///< Standard deviation of what the radars disagree about [m], >= 0,
  double velocity_bias = 10.0;   ///< and of the velocities' [m/s], >= 0.
  FusionParams fusion;
  double release_distance = 3000.0;  ///< A correlated pair further apart [m] than this; 0: no limit, as in the paper,
  int release_scans = 3;             ///< for so many scans in a row is no pair any more, >= 1.
  double track_timeout = 30.0;       ///< A track without an update for so long is lost [s], > 0.
};

constexpr std::uint32_t kNoTrack = std::numeric_limits<std::uint32_t>::max();

/// One aircraft of the correlated picture.
struct CorrelatedUpdate {
  std::uint32_t identity = 0;  ///< From 1; stays while the aircraft is seen by either radar.
  std::uint32_t primary = kNoTrack, secondary = kNoTrack;  ///< Uids.
  bool correlated = false;                                 ///< Else it is one of the two alone.
  bool coasting = false;                                   ///< Correlated, but one of the two is lost at present.
  bool ended = false;                                      ///< The final update of this identity.
  std::int64_t scan_count = 0;                             ///< n_sc
  int fusion_count = 0;                                    ///< n_fc
};

/// The result of one sector.
struct CorrelatorReport {
  std::int64_t running = 0;  ///< Of the clock,
  double time = 0.0;         ///< and when its beam entered it [s]: the instant of the correlation.
  std::vector<CorrelatedUpdate> updates;
};

struct CorrelatorCounts {
  std::uint64_t silent_tracks = 0;  ///< Lost without a final update.
  std::uint64_t initiated = 0, taken_over = 0, released = 0, cleared = 0;
  std::uint64_t clusters = 0;  ///< Solved by the optimal assignment.
  std::uint64_t lost_marks = 0, stray_marks = 0;
};

/// The correlator of Kumar, Paul and Ramakrishnan, section II: at each sector of the clocking radar the primary tracks
/// of that sector against the secondary tracks of it and its neighbours. Inputs must come in order of time.
class Correlator {
 public:
  using OnReport = std::function<void(const CorrelatorReport&)>;

  /// Throws std::invalid_argument that names the parameter when one is out of range.
  Correlator(const CorrelatorParams& params, OnReport on_report);

  void addPrimary(const TrackInput& track);
  void addSecondary(const TrackInput& track);
  /// The beam of the clocking radar enters a sector: the one Δ₂ behind it is processed. Missing marks are filled in.
  void addMark(std::int64_t running, double time);

  /// Whether a later report may still name this track: it lives, a row remembers it, or its final update is due.
  bool holds(bool primary, std::uint32_t uid) const;
  const CorrelatorCounts& counts() const { return counts_; }

 private:
  void process(const Mark& mark);
  void loseSilentTracks(double time);
  void losePrimary(std::uint32_t uid);
  void loseSecondary(std::uint32_t uid);

  void clearExpired(const Mark& mark);
  void clearExpired(const FusionRow* row, std::int64_t running);
  void correlateByHistory(const Mark& mark);
  void correlateByDistance(const Mark& mark);
  void commit(std::uint32_t primary, std::uint32_t secondary, std::int64_t running);
  void settleIdentity(std::uint32_t primary, std::uint32_t secondary, bool primarys);
  void dissolve(const FusionRow* row);
  void forgetHistory(std::int64_t running);
  bool isFree(const FusionRow* row) const;
  double distance(const KnownTrack& primary, const KnownTrack& secondary, double time) const;
  void report(const Mark& mark);
  void end(std::uint32_t identity, std::uint32_t primary, std::uint32_t secondary);
  std::uint32_t identityOf(KnownTrack& track);

  CorrelatorParams params_;
  OnReport on_report_;
  KnownTracks primaries_, secondaries_;
  KnownTracks::Near near_primaries_, near_secondaries_;  // to the mark that is processed
  FusionTable table_;
  Association association_;
  MarkClock clock_;
  std::vector<CorrelatedUpdate> ended_;
  std::uint32_t last_identity_ = 0;
  CorrelatorCounts counts_;
};

}  // namespace track_correlator
