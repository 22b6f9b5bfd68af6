#include "set_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, trackers are compared by numbers that are not what their names say.

/// The metrics of one epoch with all of its truths and tracks, cut-off 10 m, order 2.
class Scene {
 public:
  SetMetrics score() const {
    Distances distances;
    distances.compute(epoch);
    SetMetrics metrics(10.0, 2.0);
    metrics.add(epoch, distances, all(epoch.truths.size()), all(epoch.tracks.size()));
    return metrics;
  }
  double metric(const std::string& name) const {
    MetricList list;
    score().report(list);
    return valueOf(list, name);
  }
  Epoch epoch;

 private:
  static std::vector<std::size_t> all(std::size_t count) {
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }
};

/// Two truths 100 m apart; tracks 3 m and 4 m from them, and one far from all.
Scene twoHeldOneFalse() {
  Scene scene;
  scene.epoch.truths = {truthAt(1, 0, 0), truthAt(2, 100, 0)};
  scene.epoch.tracks = {trackAt(7, 0, 3), trackAt(8, 104, 0), trackAt(9, 500, 0)};
  return scene;
}

TEST(SetMetrics, OspaOfOneFalseTrackIsWorkedByHand) {
  // Schuhmacher et al. eq. (3): ((9 + 16 + 100) / 3)^(1/2).
  EXPECT_NEAR(twoHeldOneFalse().score().last().ospa, std::sqrt(125.0 / 3.0), 1e-12);
}

TEST(SetMetrics, GospaHasItsThreeParts) {
  // Rahmathullah et al. proposition 1 with alpha 2: localisation 9 + 16, each missed or false one c^2 / 2 = 50.
  Scene scene = twoHeldOneFalse();
  scene.epoch.truths.push_back(truthAt(3, -300, 0));
  EXPECT_NEAR(scene.metric("gospa_loc"), 25.0, 1e-12);
  EXPECT_NEAR(scene.metric("gospa_miss"), 50.0, 1e-12);
  EXPECT_NEAR(scene.metric("gospa_false"), 50.0, 1e-12);
  EXPECT_NEAR(scene.metric("gospa_m"), std::sqrt(125.0), 1e-12);
}

TEST(SetMetrics, OfEmptySetsAreZeroAndOfOneEmptySetTheCutOff) {
  Scene scene;
  EXPECT_EQ(scene.score().last().ospa, 0.0);
  EXPECT_EQ(scene.score().last().gospa, 0.0);
  scene.epoch.truths = {truthAt(1, 0, 0)};
  EXPECT_NEAR(scene.score().last().ospa, 10.0, 1e-12);
  EXPECT_NEAR(scene.score().last().gospa, std::sqrt(50.0), 1e-12);
}

TEST(SetMetrics, ATrackAtExactlyTheCutOffDoesNotFollow) {
  Scene scene;
  scene.epoch.truths = {truthAt(1, 0, 0)};
  scene.epoch.tracks = {trackAt(7, 10, 0)};
  EXPECT_EQ(scene.metric("completeness"), 0.0);
  EXPECT_NEAR(scene.metric("gospa_miss") + scene.metric("gospa_false"), 100.0, 1e-12);
}

TEST(SetMetrics, TheOptimalAssignmentIsNotTheGreedyOne) {
  Scene scene;
  scene.epoch.truths = {truthAt(1, 0, 0), truthAt(2, 5, 0)};
  scene.epoch.tracks = {trackAt(7, 4, 0), trackAt(8, 12, 0)};
  // Greedy: 1 m and 12 m (cut off): 1 + 100. Optimal: 4 m and 7 m: 16 + 49.
  EXPECT_NEAR(scene.metric("gospa_loc"), 65.0, 1e-12);
}

TEST(SetMetrics, SiapCountsTwoTracksOnOneTruthAsAmbiguity) {
  Scene scene;
  scene.epoch.truths = {truthAt(1, 0, 0), truthAt(2, 100, 0)};
  scene.epoch.tracks = {trackAt(7, 0, 3), trackAt(8, 0, -5), trackAt(9, 500, 0)};
  EXPECT_EQ(scene.metric("completeness"), 0.5);
  EXPECT_EQ(scene.metric("ambiguity"), 2.0);
  EXPECT_NEAR(scene.metric("spuriousness"), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(scene.metric("pos_accuracy_m"), 4.0, 1e-12);
}

TEST(SetMetrics, SiapVelocityAccuracyIsTheMeanVelocityError) {
  Scene scene;
  scene.epoch.truths = {truthAt(1, 0, 0)};
  scene.epoch.truths[0].ground.velocity = {100.0, 0.0};
  scene.epoch.tracks = {trackAt(7, 0, 3)};
  scene.epoch.tracks[0].state.velocity = {97.0, 4.0};
  EXPECT_NEAR(scene.metric("vel_accuracy_mps"), 5.0, 1e-12);
}

}  // namespace
}  // namespace track_evaluation
