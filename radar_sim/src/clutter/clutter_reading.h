#pragma once

#include <memory>

#include "clutter/area.h"
#include "clutter/clutter.h"
#include "clutter/texture.h"
#include "reading.h"

namespace radar_sim {

/// radars, start_s, end_s, suppression_db: what all kinds of clutter have. `suppression_db` is the kind's default.
void readCommon(ParameterReader& reader, const ReadingContext& context, double suppression_db, ClutterSpec& spec);

/// texture_db, texture_length_m, texture_time_s.
void readTexture(ParameterReader& reader, TextureParams& texture);

/// `outline`: a list of places.
Area readArea(ParameterReader& reader, const ReadingContext& context);

/// The velocity that course_deg and speed say; at rest without them [m/s].
Eigen::Vector2d readVelocity(ParameterReader& reader);

}  // namespace radar_sim
