#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "drawing.h"
#include "ppi_style.h"

namespace tws_rviz {

/// One measurement in sine space; the range tells apart what lies in one direction.
struct SineSpaceMeasurement {
  double range;  // [m]
  double u, v;
};

/// One dwell of an array: where its beam pointed and what it saw.
struct DwellMark {
  double time = 0.0;  // [s]
  std::uint32_t number = 0;
  bool on_track = false;
  double u = 0.0, v = 0.0;                      // beam point
  double beamwidth_u = 0.0, beamwidth_v = 0.0;  // full width at half power
  std::vector<SineSpaceMeasurement> measurements;
  std::uint32_t group = 0;         // sequence of overlapping beams that it is part of; 0: none
  std::uint32_t group_dwells = 0;  // beams of that sequence
};

/// A closed frame: its dwells, with the measurements that selection kept.
struct FrameMark {
  double time = 0.0;  // when it closed [s]
  std::uint32_t number = 0;
  std::vector<DwellMark> dwells;
};

struct SineSpaceTrack {
  std::uint32_t number = 0;
  bool firm = false;
  double u = 0.0, v = 0.0;
};

/// What an electronically scanned array does, as the array sees it: the plane of sine space, u to the right, v up.
/// Beams as they point, frames as they close, what was kept and what selection discarded, tracks. Drawn at any instant
/// of data time [s]; one unit of sine space is kMetresPerUnit on the screen.
/// Above it an inset magnifies the sequence of overlapping beams that has the most of them.
class SineSpacePicture {
 public:
  static constexpr double kMetresPerUnit = 100e3;

  /// The picture shows |u| up to `half_width`, in (0, 1], and v from `low` to `high`, low < high; dwells and
  /// measurements fade within `persistence` [s], > 0.
  SineSpacePicture(double half_width, double low, double high, double persistence);

  void add(DwellMark dwell);
  /// Measurements of its dwells that it has not kept are taken for discarded.
  void add(const FrameMark& frame);
  void setTracks(std::vector<SineSpaceTrack> tracks) { tracks_ = std::move(tracks); }

  Drawing background() const;
  /// Half-power contours of the dwells' beams: search dim, dwells on tracks bright; the newest closed frame's on top.
  Drawing beams(double time) const;
  /// Dots: kept; red crosses: discarded.
  Drawing measurements(double time) const;
  Drawing tracks() const;
  /// The newest closed frame as text.
  Drawing status() const;

 private:
  struct AgedMeasurement {
    double time;
    SineSpaceMeasurement measurement;
    bool kept;
  };

  /// A part of sine space and its place on the screen.
  struct View {
    Eigen::Vector2d centre;  // in sine space
    Eigen::Vector2d half;    // half width and height in sine space
    Eigen::Vector2d place;   // of the centre on the screen [units of sine space at magnification 1]
    double magnification;
    bool shows(const Eigen::Vector2d& direction) const;
    Eigen::Vector2d at(const Eigen::Vector2d& direction) const;  // on the screen [m]
  };
  std::vector<View> views() const;
  void follow(const DwellMark& dwell);
  double freshness(double since, double time) const;
  void forgetOld(double time);
  void addContour(Drawing& drawing, const View& view, const DwellMark& dwell, double width, const Rgba& color) const;
  void addGrid(Drawing& drawing) const;

  /// The sequence of beams in the inset.
  struct Sequence {
    std::uint32_t group = 0, dwells = 0;
    double time = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int received = 0;
  };

  double half_width_, low_, high_, persistence_;
  PpiStyle style_;
  Sequence sequence_;                               // of which dwells come in
  Eigen::Vector2d zoom_ = Eigen::Vector2d::Zero();  // where the inset looks
  std::deque<DwellMark> dwells_;                    // in order of arrival
  std::deque<AgedMeasurement> measurements_;
  FrameMark frame_;  // the newest closed one
  std::size_t kept_ = 0, discarded_ = 0;
  std::vector<SineSpaceTrack> tracks_;
};

}  // namespace tws_rviz
