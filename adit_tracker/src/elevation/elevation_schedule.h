#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "elevation/elevation_params.h"

namespace adit_tracker {

/// Whose turn it is for an elevation search: the book-keeping of the report's ELEV. Tracks are known by their uid.
///
/// How the report is read: TF is set to 4 when a target is first searched for. Each time the radar has tried the track,
/// detected or not, TF goes down by 1 unless it is 1 already; then it is set back to 4 and the target joins those that
/// wait (NTARPR). So it is searched on every fourth scan. NTARPR has eight places there; here nobody is lost, and who
/// waits already does not join again.
class ElevationSchedule {
 public:
  using Uid = std::uint32_t;

  explicit ElevationSchedule(const ElevationParams& params) : params_(params) {}

  /// Newly designated (NDESTAR). Designated already: nothing changes.
  void designate(Uid track);
  /// Designated no more, or dropped.
  void remove(Uid track);
  /// The radar has tried to update the track (TRK39).
  void tried(Uid track);

  /// The tracks to be searched for on the next scan (NTEMP), to be called once a scan: the newly designated first, then
  /// those that wait. Who finds no room comes first among those that wait next time.
  std::vector<Uid> next();

  bool empty() const { return counters_.empty(); }
  bool isDesignated(Uid track) const { return counters_.count(track) > 0; }
  std::vector<Uid> designated() const;
  /// Previously designated ones that wait (NCOUNT).
  std::size_t waiting() const { return waiting_.size(); }

 private:
  static constexpr long kNew = 0;  // not searched for yet

  ElevationParams params_;
  std::map<Uid, long> counters_;  // TF of each designated track, or kNew
  std::deque<Uid> new_;           // in the order of designation
  std::deque<Uid> waiting_;       // NTARPR
};

}  // namespace adit_tracker
