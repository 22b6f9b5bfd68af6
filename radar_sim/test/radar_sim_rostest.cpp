#include <gtest/gtest.h>
#include <radar_sim/radar_sim_node.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/run.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace radar_sim {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A message as bytes, without header.seq, which roscpp fills.
template <class M>
Bytes bytesOf(M message) {
  message.header.seq = 0;
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

/// What one run published.
struct Heard {
  std::map<std::string, std::vector<Bytes>> bytes;  // by topic
  std::map<std::string, std::vector<tws_msgs::Detections>> detections;
  std::map<std::string, std::vector<tws_msgs::SectorMark>> marks;
  std::vector<tws_msgs::SsrPlots> plots;
  std::vector<tws_msgs::Truth> truths;
  std::vector<std::string> order;  // topics

  template <class M>
  void note(const std::string& topic, const M& message) {
    bytes[topic].push_back(bytesOf(message));
    order.push_back(topic);
  }
};

/// Makes `heard` listen to all topics, through a function listen<M>(topic, handler).
template <class Listen>
void hearAll(Heard& heard, const Listen& listen) {
  for (const std::string radar : {"sps12", "sps39"}) {
    listen("/" + radar + "/detections", [&heard, radar](const tws_msgs::Detections& message) {
      heard.note("/" + radar + "/detections", message);
      heard.detections[radar].push_back(message);
    });
    listen("/" + radar + "/sector_marks", [&heard, radar](const tws_msgs::SectorMark& message) {
      heard.note("/" + radar + "/sector_marks", message);
      heard.marks[radar].push_back(message);
    });
  }
  listen("/ssr/plots", [&heard](const tws_msgs::SsrPlots& message) {
    heard.note("/ssr/plots", message);
    heard.plots.push_back(message);
  });
  listen("/ssr/sector_marks", [&heard](const tws_msgs::SectorMark& message) {
    heard.note("/ssr/sector_marks", message);
    heard.marks["ssr"].push_back(message);
  });
  listen("/truth", [&heard](const tws_msgs::Truth& message) {
    heard.note("/truth", message);
    heard.truths.push_back(message);
  });
}

/// The type of a handler's message.
template <class Handler, class M>
M messageOf(void (Handler::*)(const M&) const);

Heard runInOneProcess() {
  Heard heard;
  std::string file;
  EXPECT_TRUE(ros::param::get("~scenario", file));
  tws_runtime::LocalGraph graph(std::cerr);
  tws_runtime::Bus& ear = graph.addNode("ear");
  hearAll(heard, [&](const std::string& topic, auto handler) {
    using M = decltype(messageOf(&decltype(handler)::operator()));
    ear.subscribe<M>(topic, handler);
  });
  YAML::Node parameters;
  parameters["scenario"] = file;
  parameters["duration"] = 20;
  parameters["seed"] = 7;
  RadarSimNode source(graph.addNode("radar_sim", parameters));
  tws_runtime::runOffline(graph, {&source});
  return heard;
}

class RadarSimTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    offline = runInOneProcess();
    ros::NodeHandle node;
    std::vector<ros::Subscriber> subscribers;
    const boost::function<void(const tf2_msgs::TFMessage&)> hear_frames = [](const tf2_msgs::TFMessage& message) {
      for (const auto& transform : message.transforms) transforms[transform.child_frame_id] = transform;
    };
    subscribers.push_back(node.subscribe<tf2_msgs::TFMessage>("/tf_static", 0, hear_frames));
    hearAll(live, [&](const std::string& topic, auto handler) {
      using M = decltype(messageOf(&decltype(handler)::operator()));
      const boost::function<void(const M&)> hear = handler;
      subscribers.push_back(node.subscribe<M>(topic, 0, hear));
    });
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(40.0);
    while (live.order.size() < offline.order.size() && ros::WallTime::now() < end) {
      ros::spinOnce();
      ros::WallDuration(0.01).sleep();
    }
  }

  static Heard offline;
  static Heard live;
  static std::map<std::string, geometry_msgs::TransformStamped> transforms;
};

Heard RadarSimTest::offline;
Heard RadarSimTest::live;
std::map<std::string, geometry_msgs::TransformStamped> RadarSimTest::transforms;

// Offline results would say nothing about the live system.
TEST_F(RadarSimTest, PublishesTheSameBytesLiveAndInOneProcess) {
  EXPECT_EQ(offline.bytes.size(), 7u);
  for (const auto& [topic, messages] : offline.bytes) EXPECT_TRUE(live.bytes[topic] == messages) << topic;
}

// Trackers count on a sector's detections being there when its mark comes.
TEST_F(RadarSimTest, PublishesTheDetectionsOfASectorJustBeforeTheMarkThatClosesIt) {
  for (std::size_t i = 0; i < offline.order.size(); ++i) {
    if (offline.order[i].find("/detections") == std::string::npos && offline.order[i] != "/ssr/plots") continue;
    ASSERT_LT(i + 1, offline.order.size());
    const std::size_t length = offline.order[i].find('/', 1);
    EXPECT_EQ(offline.order[i].substr(0, length), offline.order[i + 1].substr(0, length));
    EXPECT_NE(offline.order[i + 1].find("/sector_marks"), std::string::npos);
  }
  for (const std::string radar : {"sps12", "sps39"}) {
    ASSERT_EQ(live.detections[radar].size(), live.marks[radar].size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < live.marks[radar].size(); ++i) {
      const tws_msgs::Detections& detections = live.detections[radar][i];
      const tws_msgs::SectorMark& mark = live.marks[radar][i];
      count += static_cast<std::uint32_t>(detections.detections.size());
      EXPECT_EQ(detections.header.stamp, mark.header.stamp);
      EXPECT_EQ(detections.header.frame_id, radar);
      EXPECT_EQ(detections.sector, mark.closed_sector);
      EXPECT_EQ(detections.running_sector + 1, mark.running_sector);
      EXPECT_EQ(mark.running_sector % 64, mark.sector);
      EXPECT_EQ(mark.closed_count, detections.detections.size());
      EXPECT_EQ(mark.running_count, count);
    }
  }
}

// Ten seconds with sps39, four without, six with: 20 s at 6 s a turn are 213 marks, 16 s at 8 s are 128.
TEST_F(RadarSimTest, IsSilentDuringAnOutage) {
  EXPECT_EQ(live.marks["sps12"].size(), 213u);
  EXPECT_EQ(live.marks["sps39"].size(), 128u);
  for (const tws_msgs::SectorMark& mark : live.marks["sps12"]) {
    const double time = mark.header.stamp.toSec() - 1000.0;
    EXPECT_EQ(mark.other_radars.size(), time >= 10.0 && time < 14.0 ? 0u : 1u) << time;
  }
}

TEST_F(RadarSimTest, PublishesTruthOnceASecondWithThePlotsNearIt) {
  ASSERT_EQ(live.truths.size(), 21u);
  const tws_msgs::Truth& truth = live.truths.front();
  EXPECT_EQ(truth.header.frame_id, "map");
  ASSERT_EQ(truth.targets.size(), 2u);
  EXPECT_EQ(truth.targets[0].kind, tws_msgs::TruthTarget::AIRCRAFT);
  EXPECT_EQ(truth.targets[1].kind, tws_msgs::TruthTarget::CLUTTER);
  ASSERT_EQ(truth.targets[0].slant_range.size(), truth.radars.size());
  EXPECT_NEAR(truth.targets[1].slant_range[0], 20e3, 20.0);
  EXPECT_NEAR(truth.targets[1].detection_probability[0], 0.9, 1e-9);
  int near_rock = 0;
  for (const tws_msgs::Detections& message : live.detections["sps12"]) {
    for (const tws_msgs::Detection& plot : message.detections) near_rock += std::abs(plot.range - 20e3) < 600.0;
  }
  EXPECT_GE(near_rock, 1);
}

TEST_F(RadarSimTest, PublishesTheFrameOfEachRadar) {
  ASSERT_EQ(transforms.count("sps12"), 1u);
  ASSERT_EQ(transforms.count("ssr"), 1u);
  EXPECT_NEAR(transforms["ssr"].transform.translation.z, 25.0, 1e-6);
  EXPECT_EQ(transforms["sps12"].header.frame_id, "map");
  EXPECT_NEAR(transforms["sps12"].transform.translation.z, 25.0, 1e-6);
  EXPECT_NEAR(transforms["sps39"].transform.translation.z, 35.0, 1e-6);
  EXPECT_NEAR(transforms["sps39"].transform.rotation.w, 1.0, 1e-9);
}

// Codes as octal digits, levels in hundreds of feet: 6000 m are 19 685 ft.
TEST_F(RadarSimTest, PublishesThePlotsOfASecondaryRadarBeforeTheMarksOfItsMast) {
  ASSERT_EQ(live.plots.size(), live.marks["ssr"].size());
  ASSERT_EQ(live.marks["ssr"].size(), live.marks["sps12"].size());
  std::size_t plots = 0;
  for (std::size_t i = 0; i < live.plots.size(); ++i) {
    const tws_msgs::SectorMark& mark = live.marks["ssr"][i];
    EXPECT_EQ(mark.header.stamp, live.marks["sps12"][i].header.stamp);
    EXPECT_EQ(mark.running_sector, live.marks["sps12"][i].running_sector);
    EXPECT_EQ(live.plots[i].header.stamp, mark.header.stamp);
    EXPECT_EQ(live.plots[i].header.frame_id, "ssr");
    EXPECT_EQ(live.plots[i].radar, "ssr");
    EXPECT_EQ(live.plots[i].sector, mark.closed_sector);
    EXPECT_EQ(live.plots[i].running_sector + 1, mark.running_sector);
    EXPECT_EQ(live.plots[i].plots.size(), mark.closed_count);
    for (const tws_msgs::SsrPlot& plot : live.plots[i].plots) {
      ++plots;
      EXPECT_EQ(plot.mode_1, 031);
      EXPECT_EQ(plot.mode_2, 017);
      EXPECT_EQ(plot.mode_3a, 07421);
      EXPECT_NEAR(plot.height, 19700 * 0.3048, 1e-6);
      EXPECT_EQ(plot.garbled, 0);
      EXPECT_EQ(plot.aircraft_address, 0u);
      EXPECT_TRUE(std::isnan(plot.amplitude));
    }
  }
  EXPECT_EQ(plots, 3u);
  EXPECT_EQ(live.truths.front().targets[0].mode_3a, 07421);
  EXPECT_EQ(live.truths.front().targets[1].mode_3a, 65535);
  EXPECT_EQ(live.truths.front().radars.size(), 2u);
}

// A wrong parameter must stop the node with a line that names it, not start another scenario than asked for.
TEST_F(RadarSimTest, RefusesWrongParameters) {
  tws_runtime::LocalGraph graph(std::cerr);
  int number = 0;
  const auto refuses = [&](const std::string& parameters) {
    tws_runtime::Bus& bus = graph.addNode("radar_sim" + std::to_string(number++), YAML::Load(parameters));
    EXPECT_THROW(RadarSimNode{bus}, tws_runtime::ParameterError) << parameters;
  };
  refuses("{}");
  refuses("{scenario: /nowhere.yaml}");
  refuses("{scenario: /nowhere.yaml, speed: 3}");
  refuses("{scenario: /nowhere.yaml, seed: -3}");
  refuses("{scenario: /nowhere.yaml, duration: 0}");
}

}  // namespace
}  // namespace radar_sim

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "radar_sim_rostest");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
