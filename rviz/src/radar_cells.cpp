#include "radar_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tws_core/sectors.h>

namespace tws_rviz {
namespace {

constexpr double kFaintest = 0.003;                     // [1/km²]
constexpr float kPerDecade = 0.16f, kGreatest = 0.32f;  // opacity

Rgba shadeOf(float false_plots, bool blind, const PpiStyle& style) {
  if (blind) return style.blind;
  const double decades = std::log10(std::max(kFaintest, static_cast<double>(false_plots)) / kFaintest);
  Rgba shade = style.clutter;
  shade.a = std::min(kGreatest, kPerDecade * static_cast<float>(decades));
  return shade;
}

/// The cells of one sector from bin `from` up to `to`, which have one shade.
void addStrip(Drawing& drawing, const RadarCells& cells, int sector, int from, int to, const Rgba& shade) {
  const double left = tws::sectorStart(sector) + cells.site.turn, right = left + tws::kSectorWidth;
  const auto corner = [&](int bin, double azimuth) {
    return Vertex{cells.site.origin + bin * cells.depth * unitVector(azimuth), shade};
  };
  addTriangle(drawing, corner(from, left), corner(to, left), corner(to, right));
  if (from > 0) addTriangle(drawing, corner(from, left), corner(to, right), corner(from, right));
}

bool isSame(const Rgba& a, const Rgba& b) { return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a; }

}  // namespace

Rgba densestShade(const PpiStyle& style) { return shadeOf(std::numeric_limits<float>::infinity(), false, style); }

void addRadarCells(Drawing& drawing, const RadarCells& cells, const PpiStyle& style) {
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    const auto shade = [&](int bin) {
      const auto i =
          static_cast<std::size_t>(sector) * static_cast<std::size_t>(cells.bins) + static_cast<std::size_t>(bin);
      return shadeOf(cells.false_plots[i], cells.blind[i] != 0, style);
    };
    for (int from = 0, to = 0; from < cells.bins; from = to) {
      const Rgba same = shade(from);
      while (to < cells.bins && isSame(shade(to), same)) ++to;
      if (same.a > 0.0f) addStrip(drawing, cells, sector, from, to, same);
    }
  }
}

}  // namespace tws_rviz
