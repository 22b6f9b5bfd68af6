#include "io/beam_times.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

namespace adit_tracker {
namespace {

using Plots = std::vector<tws::Plot>;

/// A radar that turns once in 4 s for two minutes, from north at t = 0; five plots a second, the range of each its true
/// time.
class BeamTimes : public ::testing::Test {
 protected:
  BeamTimes() {
    spec_.id = "a";
    auto generator = tws::seededGenerator();
    for (int i = 0; i < 600; ++i) {
      tws::Plot plot;
      plot.range = plot.time = tws::uniform(generator, 0.1, 120.0);
      plot.azimuth = tws::wrapTwoPi(tws::kTwoPi * plot.time / 4.0 + tws::uniform(generator, -0.003, 0.003));
      plots_.push_back(plot);
    }
    sort();
  }

  void sort() {
    std::sort(plots_.begin(), plots_.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  }
  void cutOff(double step) {
    for (tws::Plot& plot : plots_) plot.time = std::floor(plot.time / step) * step;
  }
  tws::Rotation learn() {
    return learnBeam(spec_, plots_, [this](const std::string& finding) { said_ += finding + "\n"; });
  }
  /// The greatest error of the plots' times, but for what they are off alike [s].
  double worstTime() const {
    double least = 1e9, most = -1e9;
    for (const tws::Plot& plot : plots_) {
      least = std::min(least, plot.time - plot.range);
      most = std::max(most, plot.time - plot.range);
    }
    return (most - least) / 2.0;
  }
  bool isInOrder() const {
    return std::is_sorted(plots_.begin(), plots_.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  }

  RadarSpec spec_;
  Plots plots_;
  std::string said_;
};

// If this fails, the tracks of healthy files change.
TEST_F(BeamTimes, OfAHealthyRadarStay) {
  const Plots before = plots_;
  const tws::Rotation rotation = learn();
  EXPECT_NEAR(rotation.period(), 4.0, 0.001);
  for (std::size_t i = 0; i < plots_.size(); ++i) EXPECT_EQ(plots_[i].time, before[i].time);
  cutOff(1.0 / 128.0);
  learn();
  EXPECT_EQ(said_, "");
}

TEST_F(BeamTimes, GoOnOverAStepOfTheClock) {
  for (tws::Plot& plot : plots_)
    if (plot.time > 80.0) plot.time -= 3.0;
  sort();
  EXPECT_TRUE(learn().breaks().empty());
  EXPECT_LT(worstTime(), 0.02);
  EXPECT_TRUE(isInOrder());
  EXPECT_NE(said_.find("its clock was put back by 3.00 s"), std::string::npos) << said_;
}

TEST_F(BeamTimes, OfWholeSecondsAreRefined) {
  cutOff(1.0);
  learn();
  EXPECT_LT(worstTime(), 4.0 / 64.0);  // Within a sector: plots come in order.
  EXPECT_TRUE(isInOrder());
  EXPECT_EQ(said_, "its times are whole steps of 1 s; they are refined by the beam's azimuth\n");
}

// If this fails, a rounded time cannot be told from one that was cut off where the beam says which it was.
TEST_F(BeamTimes, AreThoseOfABeamThatIsGiven) {
  for (tws::Plot& plot : plots_) plot.time = std::round(plot.time);
  sort();
  spec_.period = 4.0;
  spec_.phase = 0.0;
  learn();
  for (const tws::Plot& plot : plots_) ASSERT_NEAR(plot.time, plot.range, 0.01);
}

TEST_F(BeamTimes, OfWholeScansAreThoseOfABeamFromNorth) {
  cutOff(4.0);
  EXPECT_NEAR(learn().period(), 4.0, 1e-6);
  for (const tws::Plot& plot : plots_) {
    // An azimuth that is wrong by up to 0.003 rad cannot tell on which side of north it was.
    if (std::abs(tws::angularDifference(plot.azimuth, 0.0)) < 0.006) continue;
    ASSERT_NEAR(plot.time, plot.range, 0.01);
  }
}

// One aircraft that comes straight in is met at even times, which are exact.
TEST_F(BeamTimes, AtEvenStepsByChanceStay) {
  plots_.clear();
  for (int turn = 0; turn < 40; ++turn) {
    plots_.emplace_back();
    plots_.back().time = 1.0 + 4.0 * turn;
    plots_.back().azimuth = 1.0;
  }
  learn();
  EXPECT_EQ(plots_[10].time, 41.0);
  EXPECT_EQ(said_, "");
}

// If this fails, tracks are pretended of an antenna that was not understood, or nobody learns why there are none.
TEST_F(BeamTimes, OfAnotherScanAreRefused) {
  const auto reason = [this] {
    try {
      learn();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (tws::Plot& plot : plots_) plot.azimuth = 1.0 + std::abs(std::remainder(plot.time, 9.0));
  const std::string to_and_fro = "radar a: the antenna scans to and fro, at about 57 deg/s: that is not read";
  EXPECT_EQ(reason(), to_and_fro);
  spec_.period = 4.0;
  EXPECT_EQ(reason(), to_and_fro);
  spec_.phase = 0.0;
  EXPECT_EQ(reason(), to_and_fro);
  spec_ = RadarSpec();
  spec_.id = "a";
  for (tws::Plot& plot : plots_) plot.azimuth = tws::wrapTwoPi(-tws::kTwoPi * plot.time / 1.5);
  EXPECT_EQ(reason(), "radar a: the antenna turns counter-clockwise, once in 1.500 s: that is not read");
  for (tws::Plot& plot : plots_) plot.azimuth = tws::kTwoPi - plot.azimuth;
  cutOff(1.0);
  EXPECT_NE(reason().find("whole steps of 1 s: turns of less than 2.5 s are not found"), std::string::npos) << reason();
}

}  // namespace
}  // namespace adit_tracker
