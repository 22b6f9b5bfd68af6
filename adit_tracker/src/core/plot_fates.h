#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <tws_core/plot.h>

namespace adit_tracker {

struct Detection;
class DetectionFile;

/// A track in whose region a plot lay.
struct PlotClaim {
  std::uint32_t uid;
  float sigmas;         // distance from its prediction, standard deviations; NaN with fixed gates
  float chance = 0.0F;  // that its target made the plot; where chances are not known, 1 for who took it
  bool took = false;    // the plot went to this track
};

/// What became of a plot.
struct PlotFate {
  enum Kind {  // in the order of the constants of tws_msgs/PlotFate
    // Nobody took it: it is rather a track's that took another plot, or as much one track's as another's. Or there was
    // no number left for a new track, or a pause followed.
    kLeft,
    kUpdated,  // it went to a track
    kStarted,  // it started one
    kClutter,  // a clutter point took it
    kSkipped   // nobody looked at it: the tracker was behind
  };
  tws::Plot plot;
  Kind kind;
  std::uint32_t uid;              // of the track that it went to or started; 0: none
  double left;                    // chance that neither a track nor a clutter point made it
  std::vector<PlotClaim> claims;  // in the order of the tracks' first claims
};

/// The plots of a sector, when nothing more can happen to them.
struct SectorFates {
  std::size_t radar;
  std::int64_t running;
  std::vector<PlotFate> plots;  // by range
};

/// Tells what became of the plots, sector by sector, each once; nothing before start().
class PlotTeller {
 public:
  using Sink = std::function<void(const SectorFates&)>;

  void start(Sink sink, std::size_t radars);
  bool isOn() const { return static_cast<bool>(sink_); }

  /// All sectors of the radar before this one that have not been told, as they are.
  void tellBefore(std::size_t radar, DetectionFile& detections, std::int64_t running);
  /// The next plot of the sector to be told next, before it may start a track.
  void add(const Detection& detection);
  /// The plot added last has started a track.
  void started(std::uint32_t uid);
  /// That was all of the sector.
  void tell(std::size_t radar, std::int64_t running);

 private:
  Sink sink_;
  std::vector<std::int64_t> told_;  // of each radar, the last sector
  std::vector<PlotFate> plots_;
};

}  // namespace adit_tracker
