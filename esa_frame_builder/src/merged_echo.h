#pragma once

#include <cstddef>
#include <vector>

#include "frame_view.h"

namespace esa_frame_builder {

/// One echo that several tracks may have in common: targets in one beam that range does not part come back as one, at
/// their centre of power.
struct MergedEcho {
  std::vector<std::size_t> members;  // indices of the tracks, ascending; two or more
  Eigen::Vector3d place;             // the predicted centre of power [m]
  Eigen::Matrix3d covariance;        // of the prediction, and of how the power may be shared out
};

/// The echo that track `track` shares in dwell `dwell` with other firm tracks, as `views` (one a track) predict;
/// without members: none.
MergedEcho mergedEcho(std::size_t track, std::size_t dwell, const std::vector<const FrameTrack*>& tracks,
                      const std::vector<FrameView>& views, double range_resolution);

/// What the echo says of one member: it lies off its prediction as the echo lies off the predicted centre.
tws::SpatialMeasurement shareOf(const MergedEcho& echo, const tws::SpatialMeasurement& measured,
                                const tws::SpatialState& member);

}  // namespace esa_frame_builder
