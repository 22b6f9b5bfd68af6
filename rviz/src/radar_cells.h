#pragma once

#include <cstdint>
#include <vector>

#include "drawing.h"
#include "planar_frame.h"
#include "ppi_style.h"

namespace tws_rviz {

/// What a tracker has learned of a radar, by sector and range: cells of sector 0 from the radar outward, then of the
/// next one.
struct RadarCells {
  PlanarFrame site;
  double depth = 0.0;               // of a cell [m]
  int bins = 0;                     // cells of a sector
  std::vector<float> false_plots;   // expected on a scan [1/km²]
  std::vector<std::uint8_t> blind;  // 1: the radar sees hardly anything there
};

/// Of where false plots come most densely.
Rgba densestShade(const PpiStyle& style);

/// Shades the cells from which false plots come densely, the more the denser (from 3 to 300 on 1000 km² a scan), and
/// those where the radar is blind.
void addRadarCells(Drawing& drawing, const RadarCells& cells, const PpiStyle& style);

}  // namespace tws_rviz
