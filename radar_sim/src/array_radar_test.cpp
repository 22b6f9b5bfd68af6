#include "array_radar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/units.h>

#include "flight_path.h"

namespace radar_sim {
namespace {

constexpr double kStart = 1000.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Ten dwells a period of 0.1 s, of which eight may go to tracks. Boresight horizontal and north, beams of 0.04.
ArrayParams params() {
  ArrayParams array;
  array.name = "esa";
  array.tilt = 0.0;
  array.beamwidth_u = array.beamwidth_v = 0.04;
  array.reference_snr = 100.0;
  array.reference_range = 50e3;
  array.false_alarms_per_dwell = 0.0;
  array.search_u_from = -0.2;
  array.search_u_to = 0.2;
  array.search_v_from = -0.2;
  array.search_v_to = 0.2;
  return array;
}

/// Steady north of the array at `range` and `u`, level with its centre.
Target target(const std::string& name, double range, double u, Fluctuation fluctuation = Fluctuation::kSteady) {
  PathStart start;
  start.time = kStart;
  start.position = {range * u, range * std::sqrt(1.0 - u * u)};
  Target target;
  target.name = name;
  target.reflection.rcs = 1.0;
  target.reflection.fluctuation = fluctuation;
  target.trajectory = std::make_shared<FlightPath>(start, std::vector<Leg>{}, 0.0);
  return target;
}

/// The array's centre lies so high that nothing is hidden by the horizon, on a level with the targets of target().
class ArrayRadarTest : public ::testing::Test {
 protected:
  ArrayRadar& make(std::vector<Target> targets, const ArrayParams& array, std::vector<Fault> faults = {}) {
    targets_ = std::move(targets);
    ArrayParams high = array;
    high.antenna_height = 20000.0;
    Eigen::Isometry3d map_to_array = Eigen::Isometry3d::Identity();
    map_to_array.linear() = tws::enuFromArrayRotation(high.azimuth, high.tilt).transpose();
    radar_ = std::make_unique<ArrayRadar>(high, map_to_array, targets_, std::move(faults), 1, kStart);
    return *radar_;
  }

  /// Tracks that stand on the targets, and are due in every period.
  void trackTheTargets() {
    std::vector<ArrayTrack> tracks;
    for (std::size_t i = 0; i < targets_.size(); ++i)
      tracks.push_back({static_cast<std::uint32_t>(i), kStart, 0.0, targets_[i].trajectory->at(kStart).position,
                        Eigen::Vector3d::Zero(), 0, 0.01});
    radar_->setTracks(tracks);
  }

  /// The first track dwell of the next period.
  ArrayDwell nextTrackDwell() {
    ResourcePeriod period = radar_->runPeriod();
    EXPECT_TRUE(period.dwells.at(0).plan.is_track_dwell);
    return period.dwells.at(0);
  }

  std::vector<Target> targets_;
  std::unique_ptr<ArrayRadar> radar_;
};

TEST_F(ArrayRadarTest, FillsEachResourcePeriodWithDwellsInOrderOfTime) {
  ArrayRadar& radar = make({}, params());
  EXPECT_DOUBLE_EQ(radar.planTime(), 1000.0);
  EXPECT_DOUBLE_EQ(radar.nextReport(), 1000.1);
  for (std::uint32_t number = 0; number < 3; ++number) {
    const ResourcePeriod period = radar.runPeriod();
    EXPECT_EQ(period.number, number);
    EXPECT_NEAR(period.end, 1000.1 + 0.1 * number, 1e-9);
    EXPECT_FALSE(period.next_expected_dwell.has_value());
    ASSERT_EQ(period.dwells.size(), 10u);
    for (std::uint32_t i = 0; i < 10; ++i) {
      EXPECT_EQ(period.dwells[i].number, 10 * number + i);
      EXPECT_NEAR(period.dwells[i].time, 1000.005 + 0.1 * number + 0.01 * i, 1e-9);
    }
  }
}

// A track 10 km to the right of a boresight that points north moves north at 300 m/s: the beam goes where it will be.
TEST_F(ArrayRadarTest, PointsItsDwellsWhereTheTracksWillBe) {
  ArrayRadar& radar = make({}, params());
  radar.setTracks({{3, kStart - 10.0, kStart - 10.0, {10e3, 37e3, 0.0}, {0.0, 300.0, 0.0}, 0, kNaN}});
  const ArrayDwell dwell = nextTrackDwell();
  const double north = 37e3 + 300.0 * 10.05;  // In the middle of the period.
  EXPECT_NEAR(dwell.plan.beam.u, 10e3 / std::hypot(10e3, north), 1e-9);
  EXPECT_NEAR(dwell.plan.beam.v, 0.0, 1e-12);
  EXPECT_EQ(dwell.plan.expected, std::vector<std::uint32_t>{3});
}

TEST_F(ArrayRadarTest, LeavesTracksBehindItsFaceAlone) {
  ArrayRadar& radar = make({}, params());
  radar.setTracks({{3, kStart, kStart - 10.0, {0.0, -50e3, 0.0}, {0.0, 0.0, 0.0}, 0, kNaN}});
  for (const ArrayDwell& dwell : radar.runPeriod().dwells) EXPECT_FALSE(dwell.plan.is_track_dwell);
}

// Swerling 1 at SNR 20: pfa^(1/21) = 0.518. 2000 dwells; four standard deviations of a share are 0.045.
TEST_F(ArrayRadarTest, DetectsAsOftenAsTheRadarEquationSays) {
  ArrayParams array = params();
  array.reference_snr = 20.0;
  make({target("a", 50e3, 0.0, Fluctuation::kExponential)}, array);
  trackTheTargets();
  int detected = 0;
  for (int i = 0; i < 2000; ++i) detected += static_cast<int>(nextTrackDwell().measurements.size());
  const double expected = std::pow(1e-6, 1.0 / 21.0);
  EXPECT_NEAR(radar_->detectionProbability(0, kStart), expected, 1e-4);  // The sea is round, the sight line slanted.
  EXPECT_NEAR(detected / 2000.0, expected, 0.045);
}

// A tracker believes the covariance. Mean of e'P^-1 e over 1000 measurements of three numbers: 3, sigma sqrt(6/1000).
TEST_F(ArrayRadarTest, StatesTheCovarianceThatItsErrorsHave) {
  make({target("a", 50e3, 0.1)}, params());
  trackTheTargets();
  double sum = 0.0;
  int count = 0;
  while (count < 1000) {
    const ArrayDwell dwell = nextTrackDwell();
    const tws::Ruv truth = radar_->placeOf(targets_[0], dwell.time);
    for (const ArrayMeasurement& m : dwell.measurements) {
      const Eigen::Vector3d error(m.place.range - truth.range, m.place.u - truth.u, m.place.v - truth.v);
      sum += error.dot(m.covariance.inverse() * error);
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 3.0, 4.0 * std::sqrt(6.0 / count));
}

// At SNR 100 the angle error is a beamwidth over 1.6 sqrt(200) = 22.6, that of the range its cell over the same.
TEST_F(ArrayRadarTest, MeasuresWithTheErrorThatTheSnrAllows) {
  ArrayParams array = params();
  array.reference_snr = 1e4;  // So strong that noise hardly changes the measured SNR.
  array.range_sigma_floor = array.angle_sigma_floor = 1e-9;
  make({target("a", 50e3, 0.0)}, array);
  trackTheTargets();
  const ArrayDwell dwell = nextTrackDwell();
  ASSERT_EQ(dwell.measurements.size(), 1u);
  const ArrayMeasurement& m = dwell.measurements[0];
  EXPECT_NEAR(m.snr, 1e4, 600.0);
  EXPECT_NEAR(std::sqrt(m.covariance(1, 1)), 0.04 / (1.6 * std::sqrt(2e4)), 1e-5);
  EXPECT_NEAR(std::sqrt(m.covariance(0, 0)), 30.0 / (1.6 * std::sqrt(2e4)), 0.01);
  EXPECT_NEAR(m.rcs, 1.0, 0.06);
}

// One beam does not part in angle what lies in one range cell: two objects give one measurement between them.
TEST_F(ArrayRadarTest, EchoesOfOneRangeCellMergeAtTheirCentreOfPower) {
  ArrayParams array = params();
  array.reference_snr = 1e6;
  make({target("a", 50e3, -0.005), target("b", 50e3 + 20.0, 0.005), target("c", 50e3 + 100.0, 0.0)}, array);
  targets_[1].reflection.rcs = 3.0;
  trackTheTargets();
  const ArrayDwell dwell = nextTrackDwell();
  ASSERT_EQ(dwell.measurements.size(), 2u);
  EXPECT_NEAR(dwell.measurements[0].place.range, 50e3 + 15.0, 6.0);  // three quarters of the way, floor 2 m
  EXPECT_NEAR(dwell.measurements[0].place.u, 0.0025, 0.0006);
  EXPECT_NEAR(dwell.measurements[1].place.range, 50e3 + 100.0, 8.0);
}

// Twenty false alarms a dwell over 3000 dwells; four standard deviations of their number are 980.
TEST_F(ArrayRadarTest, RaisesFalseAlarmsWithinItsBeamAndItsReceiveWindow) {
  ArrayParams array = params();
  array.false_alarms_per_dwell = 20.0;
  ArrayRadar& radar = make({}, array);
  int count = 0;
  for (int period = 0; period < 300; ++period) {
    for (const ArrayDwell& dwell : radar.runPeriod().dwells) {
      for (const ArrayMeasurement& m : dwell.measurements) {
        ++count;
        EXPECT_GE(m.place.range, array.min_range - 50.0);
        EXPECT_LE(m.place.range, array.max_range + 50.0);
        EXPECT_LE(beamwidthsApart(array, dwell.plan.beam, {m.place.u, m.place.v}), 1.0);
        EXPECT_GT(m.snr, -std::log(array.false_alarm_probability));
      }
    }
  }
  EXPECT_NEAR(count, 60000, 980);
}

// If this fails, a scenario with one more target is another scenario altogether.
TEST_F(ArrayRadarTest, AnotherTargetChangesNobodysMeasurements) {
  const Target one = target("a", 50e3, 0.0, Fluctuation::kExponential);
  make({one}, params());
  trackTheTargets();
  std::vector<ArrayMeasurement> alone;
  for (int i = 0; i < 50; ++i)
    for (const auto& m : nextTrackDwell().measurements) alone.push_back(m);
  make({one, target("b", 70e3, 0.01)}, params());
  radar_->setTracks({{0, kStart, 0.0, targets_[0].trajectory->at(kStart).position, Eigen::Vector3d::Zero(), 0, 0.01}});
  std::vector<ArrayMeasurement> together;
  for (int i = 0; i < 50; ++i)
    for (const auto& m : nextTrackDwell().measurements)
      if (m.place.range < 60e3) together.push_back(m);
  ASSERT_EQ(together.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(together[i].place.range, alone[i].place.range);
    EXPECT_EQ(together[i].place.u, alone[i].place.u);
    EXPECT_EQ(together[i].snr, alone[i].snr);
  }
}

TEST_F(ArrayRadarTest, AMissedScanHasDwellsWithoutMeasurementsAndAnOutageIsSilent) {
  const Fault missed{FaultKind::kMissedScan, "esa", kStart, kStart + 1.0};
  const Fault outage{FaultKind::kOutage, "esa", kStart + 2.0, kStart + 3.0};
  ArrayRadar& radar = make({target("a", 50e3, 0.0)}, params(), {missed, outage});
  trackTheTargets();
  EXPECT_EQ(nextTrackDwell().measurements.size(), 0u);
  EXPECT_EQ(radar.detectionProbability(0, kStart + 0.5), 0.0);
  EXPECT_GT(radar.detectionProbability(0, kStart + 1.5), 0.9);
  EXPECT_FALSE(radar.isSilentAt(kStart + 0.5));
  EXPECT_TRUE(radar.isSilentAt(kStart + 2.5));
}

// Truth asks the tracker for nothing that the radar never looks for.
TEST_F(ArrayRadarTest, DoesNotPromiseToDetectWhereItDoesNotSearch) {
  ArrayRadar& radar = make({target("in", 50e3, 0.19), target("out", 50e3, 0.21)}, params());
  EXPECT_GT(radar.detectionProbability(0, kStart), 0.9);
  EXPECT_EQ(radar.detectionProbability(1, kStart), 0.0);
}

// Behind the face there is a mirror image of every direction; seen there, a target would haunt the front.
TEST_F(ArrayRadarTest, SeesNothingBehindItsFaceNorOutOfRange) {
  ArrayRadar& radar =
      make({target("near", 1500.0, 0.0), target("far", 151e3, 0.0), target("seen", 50e3, 0.0)}, params());
  EXPECT_EQ(radar.detectionProbability(0, kStart), 0.0);
  EXPECT_EQ(radar.detectionProbability(1, kStart), 0.0);
  EXPECT_GT(radar.detectionProbability(2, kStart), 0.99);
  ArrayParams turned = params();
  turned.azimuth = tws::radians(180.0);
  EXPECT_EQ(make({target("behind", 50e3, 0.0)}, turned).detectionProbability(0, kStart), 0.0);
}

}  // namespace
}  // namespace radar_sim
