// A live node that gets more than it can process: it passes sectors over, says so, turns operators away, and goes on.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/OperatorCommand.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/TrackerStatus.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/live_test_helpers.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "rostest_helpers.h"

namespace {

using tws_runtime::kUnbounded, tws_runtime::waitFor;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kStart = 1000.0;
constexpr double kPeriod = 6.0;
constexpr std::uint32_t kSectors = 64;
constexpr std::uint32_t kOverflow = 20;  // overflow_sectors: more behind the radars are passed over

double timeOf(std::uint32_t sector) { return kStart + kPeriod / kSectors * sector; }

tws_msgs::Detection detection(double time, double range, double sector) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  tws_msgs::Detection d;
  d.stamp = ros::Time(time);
  d.range = range;
  d.azimuth = std::fmod(sector, kSectors) * kTwoPi / kSectors;
  d.elevation = d.range_rate = d.range_sigma = d.azimuth_sigma = kNaN;
  d.snr = std::numeric_limits<float>::quiet_NaN();
  return d;
}

/// Stands in for a radar that sees two aircraft, due outwards at 200 m/s in sectors 20 and 50, and for an operator.
class Overload : public testing::Test {
 protected:
  void SetUp() override {
    detections_ = node_.advertise<tws_msgs::Detections>("/sps12/detections", kUnbounded);
    marks_ = node_.advertise<tws_msgs::SectorMark>("/sps12/sector_marks", kUnbounded);
    sites_ = node_.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
    operators_ = node_.serviceClient<tws_msgs::OperatorCommand>("/adit/operator_command");
    tracks_ = node_.subscribe<tws_msgs::Tracks>("/adit/tracks", kUnbounded, [this](const auto& m) { hear(m); });
    status_ = node_.subscribe<tws_msgs::TrackerStatus>("/adit/status", kUnbounded, [this](const auto& m) {
      skipped_ += m->skipped_sectors;
      ++statuses_;
    });
    diagnostics_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", kUnbounded,
                                                                     [this](const auto& m) { diagnose(*m); });
    tf2_msgs::TFMessage site;
    site.transforms.resize(1);
    site.transforms[0].header.frame_id = "map";
    site.transforms[0].child_frame_id = "sps12";
    site.transforms[0].transform.rotation.w = 1.0;
    sites_.publish(site);
    ASSERT_TRUE(waitFor([this] {
      return detections_.getNumSubscribers() > 0 && marks_.getNumSubscribers() > 0 && sites_.getNumSubscribers() > 0 &&
             sendsToUs("/adit", "/adit/tracks") && sendsToUs("/adit", "/adit/status");
    })) << "the node is not there";
    publishMark(0);
  }

  void hear(const tws_msgs::Tracks::ConstPtr& message) {
    EXPECT_EQ(message->running_sector, heard_++) << "a heartbeat is missing";
    for (const tws_msgs::Track& track : message->tracks) {
      if (track.range < kClutterBegins && track.state == tws_msgs::Track::FIRM) firm_[track.uid] = track.last_update;
    }
  }

  void diagnose(const diagnostic_msgs::DiagnosticArray& message) {
    for (const auto& status : message.status) {
      for (const auto& value : status.values) {
        if (value.key == "skipped sectors") said_skipped_ = value.value;
      }
    }
  }

  /// Sectors with the two aircraft alone, no faster than they are answered.
  void flyTo(std::uint32_t sector) {
    while (running_ < sector) {
      const tws_msgs::Detections sector = sectorOf(0);
      detections_.publish(sector);
      pass(sector);
      ASSERT_TRUE(waitFor([this] { return heard_ + 8 >= running_; })) << "no answer after " << heard_ << " sectors";
    }
  }

  /// Sectors full of clutter, all at once: the antenna has passed them before the first one's detections come. Returns
  /// when the tracker is at work on them: a request could overtake them.
  void flood(std::uint32_t sectors) {
    constexpr std::size_t kPlots = 8000;
    const std::uint32_t first = running_;
    std::vector<tws_msgs::Detections> flooded;
    while (running_ < first + sectors) {
      flooded.push_back(sectorOf(kPlots));
      pass(flooded.back());
    }
    ros::WallDuration(0.2).sleep();
    for (const tws_msgs::Detections& sector : flooded) detections_.publish(sector);
    ASSERT_TRUE(waitFor([&] { return heard_ >= first; })) << "no answer after " << heard_ << " sectors";
  }

  /// The beam leaves the sector `running_`.
  void pass(const tws_msgs::Detections& sector) {
    ++running_;
    publishMark(sector.detections.size());
  }

  /// The sector `running_`.
  tws_msgs::Detections sectorOf(std::size_t clutter) {
    tws_msgs::Detections sector;
    sector.header.frame_id = sector.radar = "sps12";
    sector.header.stamp = ros::Time(timeOf(running_ + 1));
    sector.running_sector = running_;
    sector.sector = static_cast<std::uint8_t>(running_ % kSectors);
    const double time = timeOf(running_) + 0.01;
    if (sector.sector == 20 || sector.sector == 50)
      sector.detections.push_back(detection(time, 30e3 + 200.0 * (time - kStart), running_ + 0.1));
    std::uniform_real_distribution<double> range(kClutterBegins, 180e3), place(0.11, 0.99);
    for (std::size_t i = 0; i < clutter; ++i)
      sector.detections.push_back(detection(time, range(random_), running_ + place(random_)));
    return sector;
  }

  /// The beam enters the sector `running_`.
  void publishMark(std::size_t closed_count) {
    tws_msgs::SectorMark mark;
    mark.header.frame_id = mark.radar = "sps12";
    mark.header.stamp = ros::Time(timeOf(running_));
    mark.running_sector = running_;
    mark.sector = static_cast<std::uint8_t>(running_ % kSectors);
    mark.closed_sector = static_cast<std::uint8_t>((running_ + kSectors - 1) % kSectors);
    mark.closed_count = static_cast<std::uint32_t>(closed_count);
    mark.running_count = count_ += mark.closed_count;
    mark.rotation_period = kPeriod;
    marks_.publish(mark);
  }

  /// What the tracker answers to a request for all targets.
  std::uint8_t ask() {
    tws_msgs::OperatorCommand command;
    command.request.request = tws_msgs::OperatorRequest::LIST_ALL;
    command.request.lower = command.request.upper = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(operators_.call(command));
    return command.response.result;
  }

  static constexpr double kClutterBegins = 100e3;  // [m]

  ros::NodeHandle node_;
  ros::Publisher detections_, marks_, sites_;
  ros::Subscriber tracks_, status_, diagnostics_;
  ros::ServiceClient operators_;
  std::mt19937 random_{20};
  std::uint32_t running_ = 0, count_ = 0, heard_ = 0, skipped_ = 0, statuses_ = 0;
  std::map<std::uint32_t, ros::Time> firm_;  // by uid: the latest update of the two aircraft
  std::string said_skipped_;
};

// If this fails, a tracker on a machine that is too slow falls behind for ever, in silence, or loses its tracks.
TEST_F(Overload, SectorsArePassedOverItIsSaidOperatorsAreToldToAskAgainAndTracksLiveOn) {
  constexpr std::uint32_t kFirst = 8 * kSectors;
  flyTo(kFirst);
  ASSERT_EQ(firm_.size(), 2U);
  ASSERT_EQ(ask(), tws_msgs::OperatorCommand::Response::OK);

  // As many sectors at once as the tracker lets stand, with the four that it needs ahead: operators have to wait.
  bool busy = false;
  for (std::uint32_t turn = 0; turn < 10 && !busy; ++turn) {
    flood(kOverflow - 4);
    busy = ask() == tws_msgs::OperatorCommand::Response::BUSY;
    flyTo(kFirst + (turn + 1) * kSectors);
  }
  EXPECT_TRUE(busy);

  // Each flood spans sector 20, and not sector 50, of one turn.
  const std::uint32_t second = running_;
  for (std::uint32_t turn = 0; turn < 10 && skipped_ == 0; ++turn) {
    flood(2 * kOverflow);
    flyTo(second + (turn + 1) * kSectors);
  }
  EXPECT_GT(skipped_, 0U);
  EXPECT_TRUE(waitFor([this] { return !said_skipped_.empty() && said_skipped_ != "0"; })) << said_skipped_;

  EXPECT_GE(statuses_ + 1, running_ / kSectors) << "no status of turns in which sectors are skipped";

  const std::map<std::uint32_t, ros::Time> before = firm_;
  flyTo(running_ + 3 * kSectors);
  ASSERT_EQ(firm_.size(), 2U) << "an aircraft got another track";
  for (const auto& [uid, updated] : firm_) EXPECT_GT(updated, before.at(uid)) << "track " << uid;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "overload_rostest");
  return RUN_ALL_TESTS();
}
