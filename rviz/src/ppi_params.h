#pragma once

#include <string>
#include <vector>

#include <tws_core/units.h>
#include <tws_runtime/parameters.h>

#include "drawing.h"
#include "track_picture.h"

namespace tws_rviz {

struct RadarParams {
  std::string name;
  std::string detections;    // topic; default NAME/detections
  std::string sector_marks;  // topic; default NAME/sector_marks
  Rgba color;                // default: from a palette, by place in the list
  std::string plots;         // topic of SsrPlots; default NAME/plots
};

struct TrackerParams {
  std::string name;           // for the table in the corner
  std::string topic;          // of Tracks
  std::string prefix;         // stands before the track numbers
  bool symbols_only = false;  // triangles without leaders, trails and labels
};

/// What joins tracks of other trackers: while it publishes, its picture stands in place of theirs.
struct CorrelatorParams {
  std::string name;
  std::string topic;                // of CorrelatedTracks
  std::vector<std::string> covers;  // topics of trackers; those that are not drawn otherwise may be among them
};

/// Parameters of the PPI; config/ppi.yaml is the reference.
struct PpiParams {
  std::string frame = "map";              // of the markers
  double picture_range = 200000.0;        // radius of the picture [m]
  double ring_spacing = 0.0;              // between range rings [m]; 0: chosen by the range
  double text_scale = 1.0;                // of all text
  double redraw_rate = 20.0;              // of sweep and detections, in wall time [Hz]
  double track_rate = 5.0;                // of tracks, clutter and truth at most, in wall time [Hz]
  double afterglow = tws::radians(60.0);  // angle that glows behind the beam [rad]
  double persistence_scans = 2.0;         // scans after which a detection has faded
  TrackLook tracks;
  std::string clutter_topic = "adit/clutter_map";        // empty: none
  std::string maps_topic = "adit/radar_maps";            // empty: none
  std::string registration_topic = "adit/registration";  // empty: none
  bool legend = true;                                    // what the symbols mean
  bool truth = false;
  std::string truth_topic = "truth";
  std::vector<RadarParams> radars;            // default: sps12, sps39, sps10
  std::vector<TrackerParams> trackers;        // default: adit/tracks, esa/tracks
  std::vector<CorrelatorParams> correlators;  // default: correlated/tracks, which covers adit/tracks
};

/// Throws tws_runtime::ParameterError that names what is unknown, out of range or missing.
PpiParams loadPpiParams(tws_runtime::ParameterReader reader);

}  // namespace tws_rviz
