#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fading_detections.h"
#include "identities.h"
#include "planar_frame.h"
#include "ppi_params.h"
#include "ppi_style.h"
#include "radar_cells.h"
#include "status_board.h"
#include "sweep.h"
#include "track_picture.h"

namespace tws_rviz {

struct ClutterMark {
  Eigen::Vector2d position;  // [m]
  bool absorbing = true;     // false: still on probation
};

/// All that a PPI shows: the latest of each radar and tracker, drawn layer by layer for any instant of data time
/// [s]. Radars and trackers are known by their place in the parameters' lists.
class PpiPicture {
 public:
  explicit PpiPicture(const PpiParams& params);

  /// `site`: where the radar stands.
  void add(std::size_t radar, const BeamMark& mark, const PlanarFrame& site);
  void add(std::size_t radar, const PlotMark& detection);
  /// A tracker has published at this time [s], even if it has no tracks. Correlators come after the trackers.
  void setLatest(std::size_t tracker, double time) { latest_[tracker] = time; }
  /// A tracker's track without identity of its own takes that of the secondary radars' nearest plot; a correlator
  /// knows.
  void add(TrackReport report);
  void add(const IdentityPlot& plot) { identities_.add(plot); }
  /// The whole clutter map of `time`, or all true positions.
  void setClutter(double time, std::vector<ClutterMark> marks) { clutter_ = {time, std::move(marks)}; }
  /// What a tracker has learned of the radar of that name: it stays until the next one.
  /// Throws std::invalid_argument when it is none of the picture's.
  void setCells(const std::string& radar, RadarCells cells);
  /// What is taken out of its plots, or why nothing is: the same.
  void setAlignment(const std::string& radar, const std::string& alignment);
  void setTruth(double time, std::vector<Eigen::Vector2d> positions) { truth_ = {time, std::move(positions)}; }

  /// Where a radar stands, by its name; nothing: no mark of it came yet, or it is none of the picture's.
  std::optional<PlanarFrame> siteOf(const std::string& radar) const;

  Drawing background() const;
  Drawing maps() const;
  Drawing sweeps(double time) const;
  Drawing detections(double time) const;
  Drawing clutter(double time) const;
  Drawing truth(double time) const;
  /// Also forgets the tracks that are too old, and places the labels.
  TrackLayers tracks(double time);
  /// Radars and trackers that never published are not listed.
  Drawing status(double time) const;

 private:
  struct Radar {
    RadarParams params;
    PlanarFrame site;
    Sweep sweep;
    FadingDetections detections;
    bool has_mark = false;
    std::string alignment;
  };
  // What one message brings whole, shown until the next one or until it is too old.
  template <class T>
  struct Snapshot {
    double time = 0.0;
    std::vector<T> items;
  };

  /// Throws std::invalid_argument when it is none of the picture's.
  Radar& radarNamed(const std::string& name);
  double persistence(const Radar& radar) const;
  double spacing() const;
  /// The trackers in whose place a correlator's picture stands at this time.
  std::set<std::size_t> covered(double time) const;
  bool isOld(double since, double time) const { return time - since > params_.tracks.timeout; }

  PpiParams params_;
  PpiStyle style_;
  std::vector<Radar> radars_;
  TrackPicture tracks_;
  Identities identities_;
  std::vector<std::optional<double>> latest_;  // of each tracker: when it published last [s]
  std::map<std::string, RadarCells> cells_;    // by radar
  Snapshot<ClutterMark> clutter_;
  Snapshot<Eigen::Vector2d> truth_;
};

}  // namespace tws_rviz
