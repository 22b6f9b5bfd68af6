#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <tws_core/plot.h>

#include <tws_core/site_frame.h>
#include "adit_params.h"
#include "core/track_file.h"
#include "core/track_motion.h"

namespace adit_tracker {

/// Bit 4 of the report's OUT word: is the IFF, a secondary radar, detecting the target? Its plots never hold up the
/// radars: they are kept by their time and looked at when the tracker is so far. What comes in time, in whatever order,
/// gives the same bits.
class IffWatch {
 public:
  /// The tracker works five sectors behind the radars; with this besides, a secondary radar's plots may come about a
  /// second late [s].
  static constexpr double kDelay = 0.5;

  explicit IffWatch(const std::vector<IffParams>& params);

  /// Takes in what a secondary radar (index in the parameters) has received while its beam crossed a sector. False: it
  /// comes too late, and is left out. Plots must be finite with range > 0.
  bool add(std::size_t iff, tws::RadarSector sector, const tws::SiteFrame& site);

  /// Before a sector that a radar entered at `time` [s] is processed: sets and clears Track::answers_iff.
  void apply(double time, TrackFile& tracks, const TrackMotion& motion);

 private:
  struct Sector {
    tws::RadarSector heard;
    tws::SiteFrame site;
  };
  /// A track that answers.
  struct Answer {
    TrackFile::Slot slot;
    std::uint32_t uid;
    double time;  // of its latest plot
  };
  struct Interrogator {
    IffParams params;
    std::deque<Sector> waiting;  // in order of time
    double latest = -1e300;      // leave time of the sector looked at last
    double period = 10.0;        // of a turn, until its sectors tell [s]
    std::vector<Answer> answers;
  };
  struct Pair {
    double distance;
    TrackFile::Slot slot;
    std::size_t plot;
  };

  void look(std::size_t iff, const Sector& sector, TrackFile& tracks, const TrackMotion& motion);
  void collect(const Interrogator& iff, const Sector& sector, const TrackFile& tracks, const TrackMotion& motion);
  void answer(std::size_t iff, TrackFile::Slot slot, double time, TrackFile& tracks);
  void clearMissed(std::size_t iff, const Sector& sector, TrackFile& tracks);
  template <class Gone>
  void clear(std::size_t iff, TrackFile& tracks, const Gone& gone);

  std::vector<Interrogator> interrogators_;
  double applied_ = -1e300;  // up to this time everything has been looked at [s]
  std::vector<Pair> pairs_;  // kept to save allocations
  std::vector<TrackFile::Slot> near_;
};

}  // namespace adit_tracker
