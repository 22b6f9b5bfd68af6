#include "radar_cells.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

namespace tws_rviz {
namespace {

/// 20 cells of 5 km in each sector, in which nothing is known.
RadarCells quiet() {
  RadarCells cells;
  cells.site.origin = Eigen::Vector2d(10e3, -5e3);
  cells.site.turn = tws::radians(90.0);
  cells.depth = 5e3;
  cells.bins = 20;
  cells.false_plots.assign(64 * 20, 0.0006f);
  cells.blind.assign(64 * 20, 0);
  return cells;
}

TEST(RadarCells, AQuietSkyIsNotShaded) {
  Drawing drawing;
  addRadarCells(drawing, quiet(), PpiStyle(200e3));
  EXPECT_TRUE(drawing.triangles.empty());
}

// If this fails, rain stands on the screen where it is not.
TEST(RadarCells, AShadedCellLiesWhereItsSectorAndRangeAre) {
  RadarCells cells = quiet();
  cells.false_plots[16 * 20 + 8] = 0.1f;  // 40 to 45 km, in the radar's east: its north lies in the picture's east
  Drawing drawing;
  addRadarCells(drawing, cells, PpiStyle(200e3));
  ASSERT_EQ(drawing.triangles.size(), 6U);
  for (const Vertex& v : drawing.triangles) {
    const Eigen::Vector2d from_site = v.position - cells.site.origin;
    EXPECT_GE(from_site.norm(), 40e3 - 1.0);
    EXPECT_LE(from_site.norm(), 45e3 + 1.0);
    const double azimuth = tws::wrapTwoPi(std::atan2(from_site.x(), from_site.y()));
    EXPECT_GE(azimuth, tws::kPi - 1e-6) << "the picture's south";
    EXPECT_LE(azimuth, tws::kPi + tws::kSectorWidth + 1e-6);
  }
}

TEST(RadarCells, DenserIsStrongerAndBlindIsAnotherColour) {
  const auto shade = [](float false_plots, bool blind) {
    RadarCells cells = quiet();
    cells.false_plots[0] = false_plots;
    cells.blind[0] = blind;
    Drawing drawing;
    addRadarCells(drawing, cells, PpiStyle(200e3));
    return drawing.triangles.at(0).color;
  };
  EXPECT_LT(shade(0.01f, false).a, shade(0.1f, false).a);
  EXPECT_EQ(shade(10.0f, false).a, shade(100.0f, false).a);
  EXPECT_NE(shade(0.1f, true).b, shade(0.1f, false).b);
}

// If this fails, a map of a large radar costs RViz thousands of triangles where some hundreds do.
TEST(RadarCells, CellsOfOneShadeAreDrawnAsOne) {
  RadarCells cells = quiet();
  cells.blind.assign(64 * 20, 1);
  Drawing drawing;
  addRadarCells(drawing, cells, PpiStyle(200e3));
  EXPECT_EQ(drawing.triangles.size(), 64U * 3U);
}

}  // namespace
}  // namespace tws_rviz
