#pragma once

#include "drawing.h"
#include "ppi_style.h"

namespace tws_rviz {

/// Distance between range rings [m], 1, 2 or 5 times a power of ten, that gives 4 to 10 rings. `range` > 0 [m].
double ringSpacing(double range);

/// The fixed picture: range rings with their distance in km, a spoke every 30° with its bearing, ticks every 5° at the
/// rim. North is up. Rings stand every `spacing` [m] up to the style's range, and at the range itself.
Drawing drawBackground(const PpiStyle& style, double spacing);

}  // namespace tws_rviz
