#include "core/detection_file.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>

namespace adit_tracker {
namespace {

tws::RadarSector sectorWith(std::int64_t running, const std::vector<double>& ranges, double azimuth_step = 0.0) {
  tws::RadarSector sector;
  sector.running = running;
  sector.enter_time = static_cast<double>(running);
  sector.leave_time = static_cast<double>(running + 1);
  for (const double range : ranges) {
    tws::Plot plot;
    plot.range = range;
    plot.azimuth = tws::wrapTwoPi(azimuth_step * static_cast<double>(sector.plots.size()));
    plot.time = sector.enter_time + 0.001 * static_cast<double>(sector.plots.size());
    sector.plots.push_back(plot);
  }
  return sector;
}

// If this fails, tracks and clutter points miss detections that are there, or take ones that are not near.
TEST(DetectionSector, FindsTheSameAsAWalkThroughAll) {
  auto generator = tws::seededGenerator();
  DetectionFile file;
  for (std::int64_t running = 0; running < 200; ++running) {
    std::vector<double> ranges(static_cast<std::size_t>(tws::uniformInt(generator, 0, 30)));
    for (double& r : ranges) r = tws::uniformInt(generator, 1, 40);          // Coarse: many are equal.
    DetectionSector& sector = file.add(sectorWith(running, ranges, -0.01));  // From north anticlockwise.
    ASSERT_EQ(sector.detections.size(), ranges.size());
    for (std::size_t i = 0; i < sector.detections.size(); i += 3) sector.detections[i].used = true;
    const double range = tws::uniformInt(generator, -5, 45), range_gate = tws::uniformInt(generator, 0, 10);
    const double azimuth = 0.01 * tws::uniformInt(generator, 0, 20), azimuth_gate = 0.125;
    const auto inside = [&](const Detection& d) {
      return !d.used && std::abs(d.plot.range - range) <= range_gate &&
             std::abs(tws::angularDifference(d.plot.azimuth, azimuth)) <= azimuth_gate;
    };
    const auto expected = std::count_if(sector.detections.begin(), sector.detections.end(), inside);
    std::ptrdiff_t found = 0;
    sector.near(range, azimuth, range_gate, azimuth_gate, [&](Detection& d, double dr, double da) {
      ++found;
      EXPECT_TRUE(inside(d));
      EXPECT_EQ(dr, d.plot.range - range);
      EXPECT_EQ(da, tws::angularDifference(d.plot.azimuth, azimuth));
    });
    ASSERT_EQ(found, expected);
  }
}

// If this fails, which of two plots at one range a track takes may differ from run to run.
TEST(DetectionSector, KeepsPlotsOfOneRangeInOrderOfTime) {
  DetectionFile file;
  const DetectionSector& sector = file.add(sectorWith(7, {300.0, 200.0, 300.0, 200.0}));
  EXPECT_LT(sector.detections[0].plot.time, sector.detections[1].plot.time);
  EXPECT_LT(sector.detections[2].plot.time, sector.detections[3].plot.time);
  EXPECT_EQ(sector.detections[1].plot.range, 200.0);
}

TEST(DetectionFile, GivesAnEmptySectorForOneThatIsNotThere) {
  DetectionFile file;
  file.add(sectorWith(5, {100.0}));
  EXPECT_EQ(file.at(5).detections.size(), 1U);
  for (const std::int64_t running : {-1, 4, 6, 133}) {
    EXPECT_EQ(file.at(running).running, -1);
    EXPECT_TRUE(file.at(running).detections.empty());
  }
}

// If this fails, detections of an old turn are taken for new ones at the same azimuth.
TEST(DetectionFile, ForgetsASectorWhenTheSameOneTwoTurnsLaterComes) {
  DetectionFile file;
  file.add(sectorWith(5, {100.0})).detections[0].used = true;
  file.add(sectorWith(5 + 64, {100.0}));
  EXPECT_EQ(file.at(5).running, 5);
  file.add(sectorWith(5 + 128, {100.0}));
  EXPECT_EQ(file.at(5).running, -1);
  EXPECT_FALSE(file.at(5 + 128).detections[0].used);
}

}  // namespace
}  // namespace adit_tracker
