#include <range_gate_tracker/range_gate_tracker_node.h>

#include <gtest/gtest.h>
#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/defaults.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <cmath>
#include <iterator>
#include <sstream>

namespace range_gate_tracker {
namespace {

/// The node in one process, a radar 5 km east of the map's origin that points north-east, and a listener.
class RangeGateTrackerNodeTest : public testing::Test {
 protected:
  RangeGateTrackerNodeTest() {
    tws_runtime::Bus& bus = graph_.addNode("radar");
    profiles_ = bus.advertise<tws_msgs::RangeProfile>("/mrs/range_profile");
    bus.subscribe<tws_msgs::RangeGate>("/mrs/range_gate", [this](const auto& message) { gates_.push_back(message); });
    bus.subscribe<tws_msgs::Tracks>("/mrs/tracks", [this](const auto& message) { updates_.push_back(message); });
  }

  void start(const std::string& parameters = "{}") {
    node_ = std::make_unique<RangeGateTrackerNode>(graph_.addNode("range_gate_tracker", YAML::Load(parameters)));
  }

  void placeRadar() {
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "mrs";
    site.transform.translation.x = 5000.0;
    site.transform.rotation.w = 1.0;
    graph_.addNode("sites").publishStaticTransform(site);
  }

  /// An echo of 4 m² at 8500 m in a gate of 8 to 9 km.
  tws_msgs::RangeProfile profile(double time, float amplitude = 2.0F) {
    tws_msgs::RangeProfile message;
    message.header.stamp = tws_runtime::toTime(time);
    message.header.frame_id = message.radar = "mrs";
    message.profile = number_++;
    message.range_min = 8000.0;
    message.bin_size = 1.0;
    message.azimuth = M_PI / 4.0;
    message.bins = 1000;
    message.amplitude.assign(1000, 0.0F);
    message.amplitude[500] = amplitude;
    return message;
  }

  void send(const tws_msgs::RangeProfile& message) {
    profiles_.publish(message);
    graph_.drain();
  }
  void sendMany(double from, double to, float amplitude = 2.0F) {
    for (int i = 0; from + 0.02 * i < to; ++i) send(profile(from + 0.02 * i, amplitude));
  }

  std::uint64_t count(const std::string& name) const {
    for (const auto& reading : graph_.counters())
      if (reading.node == "range_gate_tracker" && reading.name == name) return reading.value;
    return 0;
  }

  std::ostringstream log_;
  tws_runtime::LocalGraph graph_{log_};
  tws_runtime::Publisher<tws_msgs::RangeProfile> profiles_;
  std::uint32_t number_ = 0;
  std::vector<tws_msgs::RangeGate> gates_;
  std::vector<tws_msgs::Tracks> updates_;
  std::unique_ptr<RangeGateTrackerNode> node_;
};

TEST_F(RangeGateTrackerNodeTest, AnswersEveryProfileWithAGateAboutTheTarget) {
  start();
  placeRadar();
  sendMany(100.0, 101.0);
  ASSERT_EQ(gates_.size(), 50U);
  EXPECT_EQ(gates_.front().header.stamp, ros::Time(100.0));
  const tws_msgs::RangeGate& last = gates_.back();
  EXPECT_EQ(last.radar, "mrs");
  EXPECT_EQ(last.lock, tws_msgs::RangeGate::LOCKED);
  EXPECT_NEAR(last.measured_range, 8500.5, 1e-6);
  EXPECT_NEAR(last.range_min, 8500.5 - 600.0, 1e-6);
  EXPECT_NEAR(last.range_max, 8500.5 + 600.0, 1e-6);
  EXPECT_NEAR(last.power, 4.0, 1e-6);
  EXPECT_EQ(last.prediction_time, 0.1);
  EXPECT_EQ(last.window, 24.0);
  EXPECT_EQ(last.threshold, 0.1);
}

// 8500 m to the north-east of a radar at (5000, 0).
TEST_F(RangeGateTrackerNodeTest, SaysTheTargetAsATrackAtItsPlaceInTheMap) {
  start();
  placeRadar();
  sendMany(100.0, 102.0);
  ASSERT_GE(updates_.size(), 9U);
  EXPECT_LE(updates_.size(), 11U);  // every 0.2 s
  const tws_msgs::Tracks& last = updates_.back();
  EXPECT_EQ(last.tracker, "range_gate_tracker");
  EXPECT_EQ(last.sequence, updates_.size() - 1);
  ASSERT_EQ(last.tracks.size(), 1U);
  const tws_msgs::Track& track = last.tracks[0];
  EXPECT_EQ(track.state, tws_msgs::Track::FIRM);
  EXPECT_NEAR(track.position.x, 5000.0 + 8500.5 / std::sqrt(2.0), 1e-6);
  EXPECT_NEAR(track.position.y, 8500.5 / std::sqrt(2.0), 1e-6);
  EXPECT_EQ(track.uid, 1U);
  EXPECT_EQ(track.first_detection, ros::Time(100.04));  // the third profile
}

TEST_F(RangeGateTrackerNodeTest, EndsALostTrackWithOneFinalUpdateAndGivesTheNextOneANewIdentity) {
  start();
  placeRadar();
  sendMany(100.0, 101.0);
  sendMany(101.0, 103.0, 0.0F);
  sendMany(103.0, 104.0);
  int dropped = 0;
  for (const tws_msgs::Tracks& message : updates_)
    for (const tws_msgs::Track& track : message.tracks) dropped += track.state == tws_msgs::Track::DROPPED;
  EXPECT_EQ(dropped, 1);
  EXPECT_EQ(count("lost targets"), 1U);
  ASSERT_FALSE(updates_.back().tracks.empty());
  EXPECT_EQ(updates_.back().tracks[0].uid, 2U);
}

TEST_F(RangeGateTrackerNodeTest, HoldsTracksBackUntilTheSiteIsKnown) {
  start();
  sendMany(100.0, 101.0);
  EXPECT_TRUE(updates_.empty());
  EXPECT_EQ(gates_.size(), 50U);  // the radar cannot wait
  placeRadar();
  sendMany(101.0, 102.0);
  EXPECT_GE(updates_.size(), 9U);
  EXPECT_EQ(updates_.front().sequence, 0U);
  for (const tws_msgs::Track& track : updates_[1].tracks) EXPECT_FALSE(std::isnan(track.position.x));
}

// The radar waits for its answer and must not be moved by a bad profile.
TEST_F(RangeGateTrackerNodeTest, CountsABadProfileAndLeavesTheGateAsItWas) {
  start();
  placeRadar();
  sendMany(100.0, 101.0);
  const tws_msgs::RangeGate before = gates_.back();
  double time = 101.0;
  std::uint64_t bad = 0;
  const auto refuse = [&](const std::string& reason, const auto& spoil) {
    tws_msgs::RangeProfile message = profile(time += 0.02);
    spoil(message);
    log_.str("");
    send(message);
    EXPECT_EQ(count("bad profiles"), ++bad) << reason;
    EXPECT_EQ(gates_.back().header.stamp, message.header.stamp) << reason;
    EXPECT_EQ(gates_.back().range_min, before.range_min) << reason;
    EXPECT_EQ(gates_.back().range_max, before.range_max) << reason;
    EXPECT_TRUE(std::isnan(gates_.back().measured_range)) << reason;
  };
  refuse("another length than announced", [](auto& m) { m.amplitude.pop_back(); });
  EXPECT_NE(log_.str().find("999 amplitudes, announced: 1000 in mrs/range_profile at 101.02"), std::string::npos)
      << log_.str();
  refuse("s larger than the gate", [](auto& m) { m.amplitude.resize(m.bins = 23); });
  refuse("NaN", [](auto& m) { m.amplitude[3] = std::nanf(""); });
  refuse("bin size", [](auto& m) { m.bin_size = -1.0; });
  refuse("azimuth", [](auto& m) { m.azimuth = INFINITY; });
  send(profile(time += 0.02));
  EXPECT_EQ(gates_.back().lock, tws_msgs::RangeGate::LOCKED);
  EXPECT_NEAR(gates_.back().range_min, before.range_min, 1e-6);
}

TEST_F(RangeGateTrackerNodeTest, IgnoresAProfileFromThePastAndBeginsAnewWhenARunDoes) {
  start();
  placeRadar();
  sendMany(100.0, 101.0);
  const std::size_t answers = gates_.size();
  send(profile(100.5));
  EXPECT_EQ(count("late messages"), 1U);
  EXPECT_EQ(gates_.size(), answers);
  sendMany(10.0, 11.5);
  EXPECT_EQ(count("new runs"), 1U);
  EXPECT_EQ(gates_.size(), answers + 75U) << "none of the new run is lost";
  EXPECT_EQ(gates_[answers].lock, tws_msgs::RangeGate::SEARCHING);
  EXPECT_EQ(gates_[answers].header.stamp, ros::Time(10.0));
}

// If this fails, one stamp that was damaged on its way costs the target.
TEST_F(RangeGateTrackerNodeTest, OneStrayStampDoesNotLoseTheTarget) {
  start();
  placeRadar();
  double time = 100.0;
  for (const double off : tws_runtime::kStrays) {
    sendMany(time, time + 1.0);
    time += 1.0;
    send(tws_runtime::withStrayStamp(profile(time), off));
  }
  sendMany(time, time + 1.0);
  EXPECT_EQ(count("stray messages"), std::size(tws_runtime::kStrays));
  EXPECT_EQ(count("new runs"), 0U);
  EXPECT_EQ(count("lost targets"), 0U);
  EXPECT_EQ(gates_.size(), 250U);
  EXPECT_EQ(updates_.back().tracks.back().uid, 1U);
}

TEST_F(RangeGateTrackerNodeTest, AnAllZeroProfileReusesThePreviousRange) {
  start();
  placeRadar();
  sendMany(100.0, 101.0);
  const double before = gates_.back().smoothed_range;
  send(profile(101.0, 0.0F));
  EXPECT_EQ(gates_.back().lock, tws_msgs::RangeGate::COASTING);
  EXPECT_EQ(gates_.back().smoothed_range, before);
  EXPECT_EQ(count("bad profiles"), 0U);
}

TEST_F(RangeGateTrackerNodeTest, CountsProfilesThatAreMissing) {
  start();
  sendMany(100.0, 100.1);
  number_ += 4;
  sendMany(100.2, 100.3);
  EXPECT_EQ(count("lost profiles"), 4U);
}

TEST_F(RangeGateTrackerNodeTest, IgnoresAnotherRadar) {
  start();
  send(profile(100.0));
  tws_msgs::RangeProfile message = profile(100.02);
  message.radar = "other";
  send(message);
  EXPECT_EQ(count("bad messages"), 1U);
  EXPECT_EQ(gates_.size(), 1U);
}

// The command goes to the radar by the name that it uses.
TEST_F(RangeGateTrackerNodeTest, AnswersARadarUnderARemappedTopicByItsOwnName) {
  start();
  placeRadar();
  for (int i = 0; i < 50; ++i) {
    tws_msgs::RangeProfile message = profile(100.0 + 0.02 * i);
    message.radar = "myradar";
    send(message);
  }
  ASSERT_EQ(gates_.size(), 50U);
  EXPECT_EQ(gates_.back().radar, "myradar");
  EXPECT_EQ(updates_.back().tracks.back().radars, std::vector<std::string>{"mrs"});
}

TEST_F(RangeGateTrackerNodeTest, HasTheDefaultsOfTheFileForAircraft) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  const YAML::Node aircraft = tws_runtime::loadParameterFile(RANGE_GATE_TRACKER_CONFIG "/aircraft.yaml");
  const auto departures =
      tws_runtime::departuresFromDefaults([&] { RangeGateTrackerNode(graph.addNode("tracker", aircraft)); });
  EXPECT_EQ(departures, std::vector<std::string>{});
}

TEST_F(RangeGateTrackerNodeTest, TakesTheShippedParametersAndRefusesWrongOnes) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  int number = 0;
  const auto node = [&](const YAML::Node& tree) {
    return RangeGateTrackerNode(graph.addNode("tracker" + std::to_string(++number), tree));
  };
  for (const char* shipped : {"aircraft", "aircraft_no_background", "ship"})
    EXPECT_NO_THROW(
        node(tws_runtime::loadParameterFile(std::string(RANGE_GATE_TRACKER_CONFIG "/") + shipped + ".yaml")));
  for (const char* wrong :
       {"{window_m: 2000}", "{window_m: 0}", "{background: sky}", "{gate_lenght_m: 500}", "{threshold_m2: -1}",
        "{widest_gate_m: 100}", "{min_range_m: 39500}", "{coast_time_s: 9}", "{predictor: alpha}", "{radar: ''}"})
    EXPECT_THROW(node(YAML::Load(wrong)), tws_runtime::ParameterError) << wrong;
}

}  // namespace
}  // namespace range_gate_tracker
