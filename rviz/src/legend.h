#pragma once

#include "drawing.h"
#include "ppi_style.h"

namespace tws_rviz {

/// What the symbols mean, in the lower corners outside the circle.
void addLegend(Drawing& drawing, const PpiStyle& style);

}  // namespace tws_rviz
