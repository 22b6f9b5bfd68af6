#include "buoy_sensor.h"

#include <gtest/gtest.h>
#include <radar_sim/radar_sim_node.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/run.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "sensor_kinds.h"

namespace radar_sim {
namespace {

// If one of these fails, a new kind of radar needs more than its own files and its row in the table.

/// The package's kinds and one more: this is the row.
std::vector<SensorKind> kindsWithBuoys() {
  std::vector<SensorKind> kinds = sensorKinds();
  kinds.push_back({"buoys", SensorKind::Form::kList, readBuoy});
  return kinds;
}

const std::string kRadars = "duration_s: 30\nradars: [{name: sps12, type: SPS-12}]\n";
const std::string kTarget = "targets: [{name: a, east_m: 3000, north_m: 4000, height_m: 0, speed_mps: 0}]\n";

class NewKind : public testing::Test {
 protected:
  void run(const std::string& scenario) {
    std::ofstream(path_) << scenario;
    YAML::Node parameters;
    parameters["scenario"] = path_;
    tws_runtime::LocalGraph graph(std::cerr);
    tws_runtime::Bus& ear = graph.addNode("ear");
    ear.subscribe<tws_msgs::Detections>("/rock/detections", [this](const auto& m) { reports.push_back(m); });
    ear.subscribe<tws_msgs::Detections>("/sps12/detections", [this](const auto& m) { radar << m; });
    ear.subscribe<tws_msgs::SectorMark>("/sps12/sector_marks", [this](const auto& m) { radar << m; });
    RadarSimNode source(graph.addNode("radar_sim", parameters), kindsWithBuoys());
    sensors = source.sensors();
    tws_runtime::runOffline(graph, {&source});
  }

  std::string complaint(const std::string& scenario) {
    try {
      run(scenario);
      return "nothing was wrong";
    } catch (const tws_runtime::ParameterError& error) {
      return error.what();
    }
  }

  const tws::TemporaryFolder folder_;
  const std::string path_ = folder_.file("buoys.yaml");
  std::vector<tws_msgs::Detections> reports;
  std::ostringstream radar;
  std::vector<SensorTopics> sensors;
};

TEST_F(NewKind, RunsInAScenarioBesideTheOthers) {
  run(kRadars + kTarget + "buoys: [{name: rock, period_s: 5}]\n");
  ASSERT_EQ(reports.size(), 7u);  // at 0, 5, ... 30 s
  EXPECT_EQ(reports.back().header.stamp, ros::Time(1030));
  ASSERT_EQ(reports.front().detections.size(), 1u);
  EXPECT_NEAR(reports.front().detections[0].range, 5000.0, 3.0);
  EXPECT_NEAR(reports.front().detections[0].azimuth, std::atan2(3.0, 4.0), 1e-3);
}

// What a graph holds follows from this list: a sensor that is not on it is neither recorded nor tracked.
TEST_F(NewKind, IsNamedWithItsTopicsAsTheOthersAre) {
  run(kRadars + "buoys: [{name: rock}]\n");
  ASSERT_EQ(sensors.size(), 3u);
  EXPECT_EQ(sensors[0].name, "truth");
  EXPECT_EQ(sensors[1].kind, "radars");
  EXPECT_EQ(sensors[1].published.size(), 2u);
  EXPECT_EQ(sensors[2].kind, "buoys");
  EXPECT_EQ(sensors[2].name, "rock");
  ASSERT_EQ(sensors[2].published.size(), 1u);
  EXPECT_EQ(sensors[2].published[0].name, "rock/detections");
  EXPECT_EQ(sensors[2].published[0].type, "tws_msgs/Detections");
  EXPECT_TRUE(sensors[2].subscribed.empty());
}

TEST_F(NewKind, HasTheFaultsThatItCanHaveAndNoOthers) {
  const std::string scenario = kRadars + kTarget + "buoys: [{name: rock, period_s: 5}]\nfaults:\n";
  run(scenario + "  - {type: outage, radar: rock, from_s: 10, to_s: 20}\n");
  ASSERT_EQ(reports.size(), 5u);
  EXPECT_EQ(reports[2].header.stamp, ros::Time(1020));
  EXPECT_EQ(reports[2].running_sector, 4u);
  EXPECT_NE(complaint(scenario + "  - {type: missed_scan, radar: rock, from_s: 1, to_s: 2}\n").find("one of sps12"),
            std::string::npos);
}

TEST_F(NewKind, ItsNameAndSiteAreCheckedWithThoseOfTheOthers) {
  EXPECT_NE(complaint(kRadars + "buoys: [{name: sps12}]\n").find("'sps12' is used twice"), std::string::npos);
  EXPECT_NE(complaint(kRadars + "buoys: [{name: rock, site: moon}]\n").find("no site 'moon'"), std::string::npos);
  EXPECT_NE(complaint(kRadars + "buoys: [{name: rock, color: red}]\n").find("not a known key"), std::string::npos);
  EXPECT_NE(complaint(kRadars + "boys: [{name: rock}]\n").find("did you mean 'buoys'?"), std::string::npos);
}

TEST_F(NewKind, ChangesNothingOfTheOthers) {
  run(kRadars + kTarget);
  const std::string without = radar.str();
  radar.str("");
  run(kRadars + kTarget + "buoys: [{name: rock}]\n");
  EXPECT_EQ(radar.str(), without);
}

}  // namespace
}  // namespace radar_sim
