#pragma once

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fading_detections.h"
#include "identities.h"
#include "planar_frame.h"
#include "ppi_params.h"
#include "ppi_style.h"
#include "status_board.h"
#include "sweep.h"
#include "track_picture.h"

namespace tws_rviz {

struct ClutterMark {
  Eigen::Vector2d position;  // [m]
  bool absorbing = true;     // false: still on probation
};

/// All that a PPI shows: what was heard last of radars and trackers, drawn layer by layer for any instant of data time
/// [s]. Radars and trackers are known by their place in the parameters' lists.
class PpiPicture {
 public:
  explicit PpiPicture(const PpiParams& params);

  /// `site`: where the radar stands.
  void hear(std::size_t radar, const BeamMark& mark, const PlanarFrame& site);
  void hear(std::size_t radar, const Blip& detection);
  /// A tracker speaks at this time, even if it has no tracks. Correlators come after the trackers.
  void hearTracker(std::size_t tracker, double time) { trackers_heard_[tracker] = time; }
  /// A tracker's track without identity of its own takes that of the secondary radars' nearest plot; a correlator
  /// knows.
  void hear(TrackReport report);
  void hear(const IdentityPlot& plot) { identities_.add(plot); }
  /// The whole clutter map of `time`, or all true positions.
  void hearClutter(double time, std::vector<ClutterMark> marks) { clutter_ = {time, std::move(marks)}; }
  void hearTruth(double time, std::vector<Eigen::Vector2d> positions) { truth_ = {time, std::move(positions)}; }

  /// Where a radar stands, by its name; nothing: it was not heard yet, or is none of the picture's.
  std::optional<PlanarFrame> siteOf(const std::string& radar) const;

  Drawing background() const;
  Drawing sweeps(double time) const;
  Drawing detections(double time) const;
  Drawing clutter(double time) const;
  Drawing truth(double time) const;
  /// Also forgets the tracks that are too old, and places the labels.
  Drawing tracks(double time);
  /// Radars and trackers that were never heard are not mentioned.
  Drawing status(double time) const;

 private:
  struct Radar {
    RadarParams params;
    PlanarFrame site;
    Sweep sweep;
    FadingDetections detections;
    bool heard = false;
  };
  // What one message brings whole, shown until the next one or until it is too old.
  template <class T>
  struct Snapshot {
    double time = 0.0;
    std::vector<T> items;
  };

  double persistence(const Radar& radar) const;
  double spacing() const;
  /// The trackers in whose place a correlator's picture stands at this time.
  std::set<std::size_t> covered(double time) const;
  bool isOld(double heard, double time) const { return time - heard > params_.tracks.timeout; }

  PpiParams params_;
  PpiStyle style_;
  std::vector<Radar> radars_;
  TrackPicture tracks_;
  Identities identities_;
  std::vector<std::optional<double>> trackers_heard_;  // and when last [s]
  Snapshot<ClutterMark> clutter_;
  Snapshot<Eigen::Vector2d> truth_;
};

}  // namespace tws_rviz
