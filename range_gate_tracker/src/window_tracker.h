#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <tws_core/antenna.h>
#include <tws_core/number_file.h>
#include <tws_core/plot.h>

#include "held_plots.h"
#include "target_type.h"
#include "track_window.h"
#include "window_index.h"
#include "window_motion.h"
#include "window_params.h"

namespace range_gate_tracker {

/// "A track file in which all the relevant information associated with the track is stored" (Henery 1985, section 2.5).
struct TrackFile {
  std::uint32_t number = 0;  ///< Unique among living tracks.
  std::uint32_t uid = 0;     ///< Never used twice.
  bool designated = false;   ///< Started by the operator.
  int hits = 0;              ///< Scans with a detection.
  int misses = 0;            ///< Scans without one since the last detection.
  double first_time = 0.0;   ///< Of the first detection, or of the designation [s].
  double last_update = 0.0;  ///< Of the latest detection [s].
  TypeBaseline baseline;
  tws::Plot measured;  ///< The latest one: the centre of gravity of the plots. Or the marker's place.
  std::optional<WindowMotion::State> motion;  ///< Nothing: designated, and not yet detected.
  PredictionError error;
  TargetType type = TargetType::kUnknown;
  int priority = 4;
  TrackWindow window;    ///< Where the next detection is looked for.
  TrackWindow previous;  ///< Where the latest one was.
};

enum class WindowEvent { kStarted, kUpdated, kMissed, kDropped };

/// What the tracker says of a track. `file` holds good during the call only.
struct WindowUpdate {
  const TrackFile* file;
  WindowEvent event;
};

/// What happened when a sector was processed.
struct WindowReport {
  std::int64_t running = 0;  ///< The sector's running number.
  double enter_time = 0.0;   ///< The beam entered it [s].
  std::vector<WindowUpdate> updates;
};

struct WindowCounts {
  std::uint64_t refused_tracks = 0;  ///< All numbers were in use.
  std::uint64_t rejected_plots = 0;  ///< Range, azimuth or time was no number, or the range not above 0.
  std::uint64_t crowded_plots = 0;   ///< In sectors with more than kMostPlots: they started no tracks.
};

/// Track-while-scan by windows, after Henery 1985, sections 2.4 and 2.5, on one rotating radar. Same sectors and
/// requests, same reports.
class WindowTracker {
 public:
  using OnReport = std::function<void(const WindowReport&)>;
  /// In a sector with more plots than this no track starts by itself: it is a flood, of which each plot would open a
  /// window. Tracks and markers take from it what is in their windows.
  static constexpr std::size_t kMostPlots = 2000;

  /// Throws std::invalid_argument as check(). `on_report` is called once for each sector.
  WindowTracker(const WindowParams& params, OnReport on_report);
  WindowTracker(const WindowTracker&) = delete;
  WindowTracker& operator=(const WindowTracker&) = delete;

  /// The radar's sectors in order of their running numbers; what a gap held is lost.
  void process(const tws::RadarSector& sector);

  /// The operator's marker stands at a range [m] > 0 and azimuth [rad]: an acquisition window opens there. The new
  /// track's number; nothing when all are in use or no sector was processed yet.
  std::optional<std::uint32_t> designate(double range, double azimuth);
  /// The operator cancels a track; it is reported with the next sector. False: there is no such track.
  bool cancel(std::uint32_t number);
  void cancelAll();

  /// By number.
  const std::map<std::uint32_t, TrackFile>& tracks() const { return tracks_; }
  /// A target is isConfirmed to be there, and not merely looked for.
  bool isConfirmed(const TrackFile& track) const;
  /// At a time [s]; of a track that was never detected: its marker, at rest.
  WindowKinematics at(const TrackFile& track, double time) const;
  const WindowCounts& counts() const { return counts_; }
  const WindowParams& params() const { return params_; }

 private:
  void detect(const tws::RadarSector& sector);
  void decide(TrackFile& track);
  std::vector<HeldPlot*> plotsIn(const TrackFile& track);
  int rankOf(const TrackFile& track) const;
  bool isClaimed(const HeldPlot& held, const TrackFile& by) const;
  void take(TrackFile& track, const tws::Plot& plot);
  void miss(TrackFile& track);
  void openNext(TrackFile& track);
  void openWindow(TrackFile& track, const WindowKinematics& predicted, const WindowSize& size);
  void initiate(std::int64_t running);
  void startAt(const HeldPlot& held);
  bool isAwaited(const HeldPlot& held, std::int64_t running) const;
  bool belongsToATrack(const HeldPlot& held) const;
  TrackFile* open(double time);
  void close(std::map<std::uint32_t, TrackFile>::iterator track);
  void cancelLost();
  void report(const tws::RadarSector& sector);

  const WindowParams params_;
  OnReport on_report_;
  WindowMotion motion_;
  tws::Antenna antenna_;
  double now_ = 0.0;  // the beam has left the latest sector [s]
  tws::NumberFile numbers_;
  std::uint32_t next_uid_ = 0;
  std::map<std::uint32_t, TrackFile> tracks_;
  WindowIndex windows_;  // current and previous ones of all tracks
  HeldPlots plots_;
  std::vector<std::pair<std::uint32_t, WindowEvent>> news_;  // by number
  std::vector<TrackFile> dropped_;
  WindowCounts counts_;
};

}  // namespace range_gate_tracker
