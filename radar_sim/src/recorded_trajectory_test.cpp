#include "recorded_trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_core/units.h>

namespace radar_sim {
namespace {

const tws::LocalFrame kMap({tws::radians(48.0), tws::radians(11.0), 0.0});

/// Fixes each second of an aircraft that circles at 200 m/s and 3 °/s.
tws::Geodetic onCircle(double time) {
  const double radius = 3819.72;
  const double angle = tws::radians(3.0) * time;
  return kMap.toGeodetic({30e3 + radius * std::sin(angle), 40e3 + radius * std::cos(angle), 5000.0});
}

std::vector<RecordedFix> circle(double from, double to) {
  std::vector<RecordedFix> fixes;
  for (double time = from; time <= to; time += 1.0) fixes.push_back({time, onCircle(time)});
  return fixes;
}

// The fit over ±5 s draws the circle in by about a·t²/2 averaged, 10.5 m/s² · 10 s²/2 = 52 m; that, and no more, is
// lost.
TEST(RecordedTrajectory, FollowsTheFixes) {
  RecordingWindow window;
  window.at = 1000.0;
  const RecordedTrajectory trajectory(circle(0.0, 100.0), window, kMap);
  for (double time = 10.0; time < 90.0; time += 0.7) {
    const TargetState state = trajectory.at(1000.0 + time);
    EXPECT_NEAR((state.position - kMap.toEnu(onCircle(time))).norm(), 0.0, 75.0) << time;
    EXPECT_NEAR(state.velocity.norm(), 200.0, 12.0) << time;
    EXPECT_NEAR(state.height, kMap.toGeodetic(state.position).altitude, 1.0);
  }
}

TEST(RecordedTrajectory, HasTheDerivativeOfItsPositionAsVelocity) {
  const RecordedTrajectory trajectory(circle(0.0, 100.0), RecordingWindow{}, kMap);
  for (const double time : {3.3, 20.0, 47.9, 99.0}) {
    const double h = 1e-3;
    const Eigen::Vector3d difference =
        (trajectory.at(time + h).position - trajectory.at(time - h).position) / (2.0 * h);
    EXPECT_NEAR((difference - trajectory.at(time).velocity).norm(), 0.0, 0.01) << time;
  }
}

// Receivers stamp fixes up to a second late, which is 200 m at 200 m/s: an aircraft that jumped so would be dropped by
// any tracker.
TEST(RecordedTrajectory, SmoothsLateStamps) {
  std::vector<RecordedFix> fixes;
  for (int second = 0; second <= 100; ++second) {
    const double late = second % 3 == 0 ? 0.6 : second % 3 == 1 ? -0.3 : 0.0;
    const double x = 200.0 * (second + late);
    fixes.push_back({static_cast<double>(second), kMap.toGeodetic({x, 10e3, 5000.0})});
  }
  const RecordedTrajectory trajectory(fixes, RecordingWindow{}, kMap);
  for (double time = 10.0; time < 90.0; time += 1.0) {
    EXPECT_NEAR(trajectory.at(time).velocity.norm(), 200.0, 15.0) << time;
    EXPECT_NEAR(trajectory.at(time).position.x(), 200.0 * (time + 0.1), 35.0) << time;
  }
}

TEST(RecordedTrajectory, DoesNotExistInAGap) {
  std::vector<RecordedFix> fixes = circle(0.0, 50.0);
  for (const RecordedFix& fix : circle(200.0, 250.0)) fixes.push_back(fix);
  RecordingWindow window;
  window.from = 10.0;
  window.to = 240.0;
  window.at = 1000.0;
  const RecordedTrajectory trajectory(fixes, window, kMap);
  EXPECT_FALSE(trajectory.existsAt(999.9));
  EXPECT_TRUE(trajectory.existsAt(1039.9));
  EXPECT_FALSE(trajectory.existsAt(1100.0));
  EXPECT_EQ(trajectory.nextExistence(1100.0), 1190.0);
  EXPECT_TRUE(trajectory.existsAt(1229.0));
  EXPECT_TRUE(std::isinf(trajectory.nextExistence(1230.0)));
  EXPECT_NEAR((trajectory.at(1190.0).position - kMap.toEnu(onCircle(200.0))).norm(), 0.0, 150.0);
}

TEST(RecordedTrajectory, LeavesStaleFixesOut) {
  std::vector<RecordedFix> fixes = circle(0.0, 60.0);
  fixes[30].place = fixes[29].place;
  const RecordedTrajectory with_stale(fixes, RecordingWindow{}, kMap);
  fixes.erase(fixes.begin() + 30);
  const RecordedTrajectory without(fixes, RecordingWindow{}, kMap);
  EXPECT_EQ(with_stale.at(30.0).position, without.at(30.0).position);
}

TEST(RecordedTrajectory, NeedsTwoFixes) {
  EXPECT_THROW(RecordedTrajectory(circle(0.0, 0.0), RecordingWindow{}, kMap), std::invalid_argument);
  RecordingWindow window;
  window.from = 1000.0;
  EXPECT_THROW(RecordedTrajectory(circle(0.0, 100.0), window, kMap), std::invalid_argument);
}

class RecordingFile : public ::testing::Test {
 protected:
  /// What readRecording says of a file with this content; empty: nothing.
  std::string complaint(const std::string& content) {
    std::ofstream(path_) << content;
    try {
      readRecording(path_);
      return "";
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind(path_, 0), 0u) << what;
      return what.substr(path_.size());
    }
  }
  const tws::TemporaryFolder folder_;
  const std::string path_ = folder_.file("recording.csv");
};

TEST_F(RecordingFile, IsReadWithDosLineEndsToo) {
  EXPECT_EQ(complaint("t_s,lat_deg,lon_deg,alt_m\r\n0,48,11,500\r\n1,48,11.001,500\r\n"), "");
  const auto fixes = readRecording(path_);
  ASSERT_EQ(fixes.size(), 2u);
  EXPECT_DOUBLE_EQ(fixes[1].place.longitude, tws::radians(11.001));
}

TEST_F(RecordingFile, IsRefusedWithLineAndReason) {
  const std::string header = "t_s,lat_deg,lon_deg,alt_m\n";
  EXPECT_NE(complaint("time,lat\n0,0\n").find(":1: has no column t_s"), std::string::npos);
  EXPECT_NE(complaint("").find(":1: is empty"), std::string::npos);
  EXPECT_NE(complaint(header + "0,48,11,500\n1,48,x,500\n").find(":3: lon_deg 'x' is no number"), std::string::npos);
  EXPECT_NE(complaint(header + "0,48,11\n").find(":2: alt_m is empty"), std::string::npos);
  EXPECT_NE(complaint(header + "0,48,11,500,9\n").find(":2: 5 values under 4 column names"), std::string::npos);
  EXPECT_NE(complaint(header + "0,48,11,nan\n").find(":2: alt_m 'nan' is not finite"), std::string::npos);
  EXPECT_NE(complaint(header + "0,98,11,500\n").find(":2: latitude"), std::string::npos);
  EXPECT_NE(complaint(header + "5,48,11,500\n5,48,11,500\n").find(":3: time does not increase"), std::string::npos);
  EXPECT_THROW(readRecording("/nowhere.csv"), std::runtime_error);
}

}  // namespace
}  // namespace radar_sim
