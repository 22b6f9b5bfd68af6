#pragma once

#include <cstddef>
#include <vector>

#include "frame_view.h"

namespace esa_frame_builder {

/// One plot of several targets: those in one beam that range does not resolve come back as one, at their centre of
/// power.
struct MergedPlot {
  std::vector<std::size_t> members;  // indices of the tracks, ascending; two or more
  Eigen::Vector3d place;             // the predicted centre of power [m]
  Eigen::Matrix3d covariance;        // of the prediction, and of how the power may be shared out
};

/// The merged plot of track `track` and other firm tracks in dwell `dwell`, as `views` (one a track) predict;
/// without members: none.
MergedPlot mergedPlot(std::size_t track, std::size_t dwell, const std::vector<const FrameTrack*>& tracks,
                      const std::vector<FrameView>& views, double range_resolution);

/// The measurement of one member: it lies off its prediction as the merged plot lies off the predicted centre.
tws::SpatialMeasurement memberMeasurement(const MergedPlot& merged, const tws::SpatialMeasurement& measured,
                                          const tws::SpatialState& member);

}  // namespace esa_frame_builder
