#include <esa_frame_builder/frame_builder_node.h>

#include <tws_runtime/defaults.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <iterator>
#include <limits>

#include "esa_chain_test_helpers.h"

namespace esa_frame_builder {
namespace {

class FrameBuilderNodeTest : public EsaChain {
 protected:
  void start(const std::string& parameters = "{}") {
    node_ = std::make_unique<FrameBuilderNode>(graph_.addNode("frame_builder", YAML::Load(parameters)));
  }

  // Dwells at five places far apart, one after the other.
  static std::vector<Dwell> sweep(double start, int dwells = 5) {
    std::vector<Dwell> sweep;
    for (int k = 0; k < dwells; ++k)
      sweep.push_back(dwellAt(start + 0.01 * (k + 1), 0.1 * k, 0.0, {measurementAt(50e3, 0.1 * k, 0.0)}));
    return sweep;
  }

  std::unique_ptr<FrameBuilderNode> node_;
};

TEST_F(FrameBuilderNodeTest, SendsWhatClosedThenWhatIsOpenThenAHeartbeat) {
  start();
  publish(report(0.1, sweep(0.0)));
  publish(report(0.2, sweep(0.1)));
  ASSERT_EQ(frames_.size(), 5U);
  using tws_msgs::Frame;
  const std::vector<std::uint8_t> statuses{Frame::PARTIAL, Frame::HEARTBEAT, Frame::CLOSED, Frame::PARTIAL,
                                           Frame::HEARTBEAT};
  const std::vector<std::uint32_t> numbers{0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(frames_[i].status, statuses[i]);
    EXPECT_EQ(frames_[i].frame, numbers[i]);
    EXPECT_EQ(frames_[i].radar, "esa");
    EXPECT_EQ(frames_[i].header.frame_id, "esa");
    EXPECT_EQ(frames_[i].through, ros::Time(i < 2 ? 0.1 : 0.2));
  }
  EXPECT_EQ(frames_[2].header.stamp, ros::Time(0.01)) << "its first dwell";
  EXPECT_EQ(frames_[2].dwells.size(), 5U);
  EXPECT_EQ(frames_[4].header.stamp, ros::Time(0.2));
  EXPECT_TRUE(frames_[4].dwells.empty());
}

TEST_F(FrameBuilderNodeTest, SendsNoPartialFramesWhenToldSo) {
  start("{partial_frames: false}");
  publish(report(0.1, sweep(0.0)));
  EXPECT_TRUE(framesOf(tws_msgs::Frame::PARTIAL).empty());
  EXPECT_EQ(framesOf(tws_msgs::Frame::HEARTBEAT).size(), 1U);
}

// If this fails, one bad dwell spoils the frame it would have been in, or nobody is told of it.
TEST_F(FrameBuilderNodeTest, CountsEachKindOfBadDwellAndKeepsTheFrameIntact) {
  start();
  tws_msgs::DwellReports bad = report(0.1, sweep(0.0, 10));
  bad.dwells[1].v = std::numeric_limits<double>::quiet_NaN();
  bad.dwells[2].u = 1.01;
  bad.dwells[4].beamwidth_u = 0.0;
  bad.dwells[5].stamp = ros::Time(0.0001);
  bad.dwells[6].stamp = ros::Time(0.5);
  bad.dwells[7].measurements[0].range = -1.0;
  bad.dwells[8].measurements.clear();
  publish(bad);
  for (const char* name : {"dwells with NaN", "dwells outside the visible region", "dwells without a beamwidth",
                           "dwells back in time", "dwells after their period", "bad measurements"})
    EXPECT_EQ(count(name), 1U) << name;
  EXPECT_NE(log_.str().find("dwell 0: v is nan in esa/dwell_reports at 0.1"), std::string::npos) << log_.str();
  const auto open = framesOf(tws_msgs::Frame::PARTIAL);
  ASSERT_EQ(open.size(), 1U);
  ASSERT_EQ(open[0].dwells.size(), 5U);
  EXPECT_EQ(open[0].dwells[4].u, 0.1 * 9);
  EXPECT_TRUE(open[0].dwells[3].measurements.empty());
}

TEST_F(FrameBuilderNodeTest, CountsBadMessagesAndLosses) {
  start();
  publish(report(0.1, sweep(0.0)));
  tws_msgs::DwellReports other = report(0.2, sweep(0.1));
  other.radar = "other";
  publish(other);  // and so a period is missing
  tws_msgs::DwellReports timeless = report(0.3, sweep(0.2));
  timeless.duration = 0.0;
  publish(timeless);
  publish(report(0.4, sweep(0.3)));
  next_period_ = 2;
  publish(report(0.2, sweep(0.1)));
  EXPECT_EQ(count("bad messages"), 2U);
  EXPECT_EQ(count("lost resource periods"), 1U);
  EXPECT_EQ(count("late messages"), 1U);
  EXPECT_EQ(count("resource periods"), 2U);
}

// If this fails, a bag played twice is one run of nonsense.
TEST_F(FrameBuilderNodeTest, BeginsAnewWhenTimeGoesFarBack) {
  start();
  publish(report(100.1, sweep(100.0)));
  publish(report(100.2, sweep(100.1)));
  next_period_ = 0;
  frames_.clear();
  for (int n = 0; n < 15; ++n) publish(report(0.1 * (n + 1), sweep(0.1 * n)));
  EXPECT_EQ(count("new runs"), 1U);
  EXPECT_EQ(count("lost resource periods"), 0U);
  const auto open = framesOf(tws_msgs::Frame::PARTIAL);
  EXPECT_EQ(open.front().frame, 0U);
  EXPECT_EQ(open.front().dwells[0].stamp, ros::Time(0.01)) << "nothing of the new run is lost";
}

// If this fails, one stamp that was damaged on its way ends the frames.
TEST_F(FrameBuilderNodeTest, OneStrayStampEndsNoRun) {
  start();
  int period = 0;
  const auto run = [&](int periods) {
    for (int n = 0; n < periods; ++n, ++period) publish(report(1000.1 + 0.1 * period, sweep(1000.0 + 0.1 * period)));
  };
  for (const double off : tws_runtime::kStrays) {
    run(20);
    publish(tws_runtime::withStrayStamp(report(1000.1 + 0.1 * period, {}), off));
    ++period;
  }
  run(20);
  EXPECT_EQ(count("stray messages"), std::size(tws_runtime::kStrays));
  EXPECT_EQ(count("new runs"), 0U);
  EXPECT_EQ(count("resource periods"), 100U);
  EXPECT_EQ(count("late messages"), 0U);
}

TEST_F(FrameBuilderNodeTest, OnALiveRadarTheTimerClosesAFrameThatGrowsStale) {
  start("{time_test: timer, max_frame_time_s: 0.3}");
  graph_.advanceTo(ros::Time(0.1));
  publish(report(0.1, sweep(0.0)));
  graph_.advanceTo(ros::Time(0.3));
  EXPECT_TRUE(framesOf(tws_msgs::Frame::CLOSED).empty());
  graph_.advanceTo(ros::Time(0.4));
  ASSERT_EQ(framesOf(tws_msgs::Frame::CLOSED).size(), 1U);
  EXPECT_EQ(frames_.back().status, tws_msgs::Frame::HEARTBEAT);
  EXPECT_EQ(count("frames closed by the timer"), 1U);
}

TEST_F(FrameBuilderNodeTest, ClosesAtThePeriodsEndWhenNoDwellIsExpected) {
  start();
  tws_msgs::DwellReports last = report(0.1, sweep(0.0));
  last.expected_next_dwell = ros::Time();
  publish(last);
  EXPECT_EQ(framesOf(tws_msgs::Frame::CLOSED).size(), 1U);
}

TEST_F(FrameBuilderNodeTest, SaysTheSameInEveryRun) {
  start("{algorithm: 4}");
  for (int run = 0; run < 2; ++run) {
    next_period_ = 0;
    for (int n = 0; n < 100; ++n) publish(report(0.1 * (n + 1), sweep(0.1 * n, n % 7)));
  }
  ASSERT_EQ(frames_.size() % 2, 0U);
  const std::size_t half = frames_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) ASSERT_EQ(frames_[i], frames_[half + i]) << "message " << i;
}

TEST_F(FrameBuilderNodeTest, HasTheDefaultsOfTheShippedFile) {
  const YAML::Node shipped = tws_runtime::loadParameterFile(ESA_CONFIG "/frame_builder.yaml");
  const auto departures =
      tws_runtime::departuresFromDefaults([&] { FrameBuilderNode(graph_.addNode("shipped", shipped)); });
  EXPECT_EQ(departures, std::vector<std::string>{});
}

TEST_F(FrameBuilderNodeTest, RefusesWrongParametersInOneLineThatNamesThem) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"{algorithm: 5}", "algorithm"},     {"{gamma_theta: 1.5}", "gamma_theta"},
      {"{time_test: never}", "time_test"}, {"{least_allowance_periods: 20}", "least_allowance_periods"},
      {"{algoritm: 3}", "algorithm"},      {"{radar: ''}", "radar"},
      {"{alpha_0: .nan}", "alpha_0"}};
  int n = 0;
  for (const auto& [parameters, name] : wrong) {
    try {
      FrameBuilderNode node(graph_.addNode("wrong" + std::to_string(n++), YAML::Load(parameters)));
      ADD_FAILURE() << parameters;
    } catch (const tws_runtime::ParameterError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace esa_frame_builder
