#include "symbols.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace tws_rviz {
namespace {

const PpiStyle kStyle(200e3);

/// Number of vertices, and how far the symbol reaches to the north.
std::pair<std::size_t, double> lookOf(const TrackReport& report) {
  Drawing drawing;
  addTrackSymbol(drawing, report, kStyle);
  double north = 0.0;
  for (const Vertex& vertex : drawing.triangles) north = std::max(north, vertex.position.y());
  return {drawing.triangles.size(), north};
}

// If this fails, an operator cannot tell what he has ordered, or who answers.
TEST(Symbols, HandedOffDesignatedAndAnsweringTracksDifferInEveryCombination) {
  std::set<std::pair<std::size_t, double>> looks;
  for (int marks = 0; marks < 8; ++marks) {
    TrackReport report;
    report.state = TrackState::kFirm;
    report.position = {0.0, 0.0};
    report.handed_off = (marks & 1) != 0;
    report.designated = (marks & 2) != 0;
    report.iff = (marks & 4) != 0;
    looks.insert(lookOf(report));
  }
  EXPECT_EQ(looks.size(), 8U);
}

// In a correlator's picture nearly all tracks would bear a second mark for the same thing.
TEST(Symbols, ATrackThatASecondaryRadarSeesHasNoSecondMarkForIt) {
  for (const TrackKind kind : {TrackKind::kCorrelated, TrackKind::kSecondary}) {
    TrackReport report;
    report.position = {0.0, 0.0};
    report.kind = kind;
    const auto look = lookOf(report);
    report.iff = true;
    EXPECT_EQ(lookOf(report), look);
  }
}

// If this fails, what is still passed on to the tracks looks like what is taken out.
TEST(Symbols, AClutterPointOnProbationIsSmallerAndDimmerThanOneThatAbsorbs) {
  Drawing absorbing, probation;
  addClutterSymbol(absorbing, {0.0, 0.0}, true, kStyle);
  addClutterSymbol(probation, {0.0, 0.0}, false, kStyle);
  ASSERT_EQ(absorbing.triangles.size(), probation.triangles.size());
  EXPECT_LT(probation.triangles[0].color.a, absorbing.triangles[0].color.a);
  const auto reach = [](const Drawing& drawing) {
    double most = 0.0;
    for (const Vertex& vertex : drawing.triangles) most = std::max(most, vertex.position.norm());
    return most;
  };
  EXPECT_LT(reach(probation), 0.7 * reach(absorbing));
}

}  // namespace
}  // namespace tws_rviz
