#include "evaluator.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

EvaluatorParams tenMetres() {
  EvaluatorParams params;
  params.cutoff = 10.0;
  params.from = 0.0;
  return params;
}

Epoch epochAt(double time, std::vector<TruthState> truths, std::vector<TrackState> tracks) {
  Epoch epoch;
  epoch.time = time;
  epoch.truths = std::move(truths);
  epoch.tracks = std::move(tracks);
  return epoch;
}

// If this fails, two tracks that pass each other look like two swaps although each stays with its target.
TEST(Evaluator, KeepsAPairWhileItIsCloserThanTheCutOff) {
  Evaluator evaluator(tenMetres());
  evaluator.add(epochAt(0, {truthAt(1, 0, 0), truthAt(2, 20, 0)}, {trackAt(5, 0, 0), trackAt(6, 20, 0)}));
  evaluator.add(epochAt(1, {truthAt(1, 0, 0), truthAt(2, 4, 0)}, {trackAt(5, 4, 0), trackAt(6, 0, 0)}));
  EXPECT_EQ(valueOf(evaluator.metrics(), "swaps"), 0.0);
  EXPECT_NEAR(valueOf(evaluator.metrics(), "gospa_loc"), 0.0, 1e-12);  // The set metrics have no memory.
}

// If this fails, a track on a boat counts as false, or an aircraft that no radar can see as missed.
TEST(Evaluator, ATruthThatIsNotRequiredNeitherCostsNorFalsifies) {
  Evaluator evaluator(tenMetres());
  TruthState boat = truthAt(2, 100, 0), unseen = truthAt(3, 300, 0);
  boat.required = unseen.required = false;
  evaluator.add(
      epochAt(0, {truthAt(1, 0, 0), boat, unseen}, {trackAt(5, 0, 3), trackAt(6, 100, 0), trackAt(7, 101, 0)}));
  EXPECT_NEAR(valueOf(evaluator.metrics(), "gospa_m"), 3.0, 1e-12);
  EXPECT_EQ(valueOf(evaluator.metrics(), "completeness"), 1.0);
  EXPECT_EQ(valueOf(evaluator.metrics(), "spuriousness"), 0.0);
  EXPECT_EQ(valueOf(evaluator.metrics(), "spurious_tracks"), 0.0);
  EXPECT_EQ(valueOf(evaluator.metrics(), "mota"), 1.0);
}

TEST(Evaluator, CountsOnlyTheEvaluatedInterval) {
  EvaluatorParams params = tenMetres();
  params.from = 1.0;
  params.to = 2.0;
  Evaluator evaluator(params);
  for (const double time : {0.0, 1.0, 2.0, 3.0}) evaluator.add(epochAt(time, {truthAt(1, 0, 0)}, {}));
  EXPECT_EQ(valueOf(evaluator.metrics(), "epochs"), 2.0);
}

TEST(Evaluator, RefusesTimeThatDoesNotGoOnAndNumbersThatComeTwiceAndGoesOn) {
  Evaluator evaluator(tenMetres());
  evaluator.add(epochAt(5, {truthAt(1, 0, 0)}, {trackAt(5, 0, 0)}));
  EXPECT_THROW(evaluator.add(epochAt(5, {}, {})), std::invalid_argument);
  EXPECT_THROW(evaluator.add(epochAt(std::nan(""), {}, {})), std::invalid_argument);
  EXPECT_THROW(evaluator.add(epochAt(6, {truthAt(1, 0, 0), truthAt(1, 9, 0)}, {})), std::invalid_argument);
  EXPECT_THROW(evaluator.add(epochAt(6, {}, {trackAt(5, 0, 0), trackAt(5, 9, 0)})), std::invalid_argument);
  evaluator.add(epochAt(6, {truthAt(1, 0, 0)}, {trackAt(5, 0, 0)}));
  EXPECT_EQ(valueOf(evaluator.metrics(), "epochs"), 2.0);
}

}  // namespace
}  // namespace track_evaluation
