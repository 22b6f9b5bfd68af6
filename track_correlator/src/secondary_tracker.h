#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "plot_matcher.h"
#include "secondary_params.h"
#include "secondary_plot.h"
#include "secondary_track.h"

namespace track_correlator {

enum class SecondaryEvent { kUpdated, kCoasted, kDropped };

/// What the tracker says of one track.
struct SecondaryUpdate {
  SecondaryEvent event;
  SecondaryTrack track;  ///< Its state holds at track.time; a coasted one has been moved on.
};

/// All that is said of one sector, also when it is nothing.
struct SecondaryReport {
  std::int64_t running = 0;  ///< The sector processed,
  double enter_time = 0.0;   ///< and when the beam entered it [s].
  std::vector<SecondaryUpdate> updates;
};

struct SecondaryCounts {
  std::uint64_t plots = 0;           ///< Taken in.
  std::uint64_t mended_codes = 0;    ///< Garbled mode 3/A codes in whose place the track holds its own.
  std::uint64_t split_plots = 0;     ///< Second plots of one aircraft.
  std::uint64_t crowded_plots = 0;   ///< In sectors with more than kMostPlots: they started no tracks.
  std::uint64_t lost_sectors = 0;    ///< Never came; taken for empty.
  std::uint64_t late_sectors = 0;    ///< Came twice or too late; left out.
  std::uint64_t dropped_tracks = 0;  ///< Dropped for missing plots, firm ones only.
};

/// The secondary tracker of Kumar, Paul and Ramakrishnan, sections I and II.2: plots of a secondary radar to tracks
/// with identity, codes and height. Works a fixed number of sectors (Δ₁) behind the antenna, sector by sector: tracks
/// of a sector against the plots of that sector and its neighbours. Plots come to tracks by unique code, else by
/// position; codes are held by history; a track without a plot coasts. Motion: the constant-velocity filter of
/// tws_core.
class SecondaryTracker {
 public:
  using OnReport = std::function<void(const SecondaryReport&)>;
  /// In a sector with more plots than this no track starts: it is a flood. Tracks take from it what is theirs.
  static constexpr std::size_t kMostPlots = 2000;

  /// Throws std::invalid_argument that names the parameter when one is out of range.
  SecondaryTracker(const SecondaryParams& params, OnReport on_report);

  /// The next sector of the radar. A gap of up to eight turns is filled with empty sectors; behind a longer one, or
  /// when the radar counts anew, the tracks are dropped and all begins with the second sector of the new count. Numbers
  /// that the antenna cannot have passed in that time (its beam broke: another phase, its clock was set) stand for no
  /// sectors: no track has missed a plot there.
  void add(SecondarySector sector);

  const std::vector<SecondaryTrack>& tracks() const { return tracks_; }
  const SecondaryCounts& counts() const { return counts_; }

 private:
  struct Stored {
    SecondarySector sector;
    double enter_time = 0.0;
    std::vector<bool> used;
  };

  void store(SecondarySector sector);
  void begin(const SecondarySector& sector);
  void fillGap(const SecondarySector& next);
  bool leapsTo(const SecondarySector& next) const;
  void dropAll();
  void process(std::size_t index);
  std::vector<std::size_t> tracksNear(std::int64_t running, double time, std::vector<std::size_t>& due) const;
  void update(SecondaryTrack& track, const PlacedPlot& plot, bool garbled);
  void miss(SecondaryTrack& track, double time, std::vector<SecondaryUpdate>& updates);
  void startTracks(Stored& stored, std::vector<SecondaryUpdate>& updates);
  bool isSplit(const SecondaryPlot& plot) const;
  void removeDropped();

  SecondaryParams params_;
  OnReport on_report_;
  PlotMatcher matcher_;
  std::vector<SecondaryTrack> tracks_;
  std::deque<Stored> stored_;          ///< The sectors from the one before the next to process to the newest.
  std::optional<std::int64_t> stray_;  ///< A running number that was out of line.
  double sector_duration_ = 0.0;       ///< Of the latest one that followed the one before [s]; 0: none did.
  std::uint32_t last_uid_ = 0;
  SecondaryCounts counts_;
};

}  // namespace track_correlator
