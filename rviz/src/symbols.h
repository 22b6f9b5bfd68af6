#pragma once

#include "drawing.h"
#include "ppi_style.h"
#include "track_picture.h"

namespace tws_rviz {

/// The colour of a track's symbol, leader, trail and label.
const Rgba& colorOf(const TrackReport& report, const PpiStyle& style);

/// A track's symbol with all that its report says of it, without speed leader.
void addTrackSymbol(Drawing& drawing, const TrackReport& report, const PpiStyle& style);

/// A point of a clutter map: a cross, or a small dim plus as long as it is on probation.
void addClutterSymbol(Drawing& drawing, const Eigen::Vector2d& position, bool absorbing, const PpiStyle& style);

}  // namespace tws_rviz
