#include "legend.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "background.h"

namespace tws_rviz {
namespace {

constexpr double kRange = 200e3;

Drawing legend() {
  Drawing drawing;
  addLegend(drawing, PpiStyle(kRange));
  return drawing;
}

// If this fails, an operator who does not know a symbol finds no explanation of it.
TEST(Legend, NamesEachSymbolOnce) {
  std::set<std::string> said;
  for (const Label& label : legend().labels) EXPECT_TRUE(said.insert(label.text).second);
  for (const char* meaning :
       {"firm", "coasting", "tentative", "handed off", "elevation search", "answers IFF", "clutter",
        "clutter on probation", "false plots", "radar is blind", "secondary radar alone", "both kinds of radar"})
    EXPECT_EQ(said.count(meaning), 1U) << meaning;
}

// It would cover aircraft, or not be seen.
TEST(Legend, StandsOutsideTheCircleAndInsideThePicture) {
  const Drawing drawing = legend();
  for (const Vertex& vertex : drawing.triangles) {
    EXPECT_GT(vertex.position.norm(), 1.02 * kRange);
    EXPECT_LT(vertex.position.cwiseAbs().maxCoeff(), 1.12 * kRange);
  }
  for (const Label& label : drawing.labels) {
    const Eigen::Vector2d half = 0.5 * textSize(label.text, label.height);
    EXPECT_LT(label.centre.cwiseAbs().x() + half.x(), 1.12 * kRange) << label.text;
    const Eigen::Vector2d nearest = (label.centre.cwiseAbs() - half).cwiseMax(0.0);
    EXPECT_GT(nearest.norm(), 1.02 * kRange) << label.text;
  }
}

// RViz replaces a text whose number comes twice; the bearings are on the same layer.
TEST(Legend, ItsLabelsHaveNumbersOfTheirOwn) {
  Drawing drawing = drawBackground(PpiStyle(kRange), 50e3);
  addLegend(drawing, PpiStyle(kRange));
  std::set<std::uint32_t> ids;
  for (const Label& label : drawing.labels) EXPECT_TRUE(ids.insert(label.id).second) << label.text;
}

}  // namespace
}  // namespace tws_rviz
