#pragma once

#include <gtest/gtest.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/Frame.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/local_graph.h>

#include <sstream>
#include <string>
#include <vector>

#include "dwell_messages.h"
#include "dwell_test_helpers.h"

namespace esa_frame_builder {

/// A radar named esa at the map's origin, boresight to the east, that looks at nothing of its own; both nodes; ears on
/// all they say.
class EsaChain : public testing::Test {
 protected:
  EsaChain() {
    tws_runtime::Bus& bus = graph_.addNode("radar");
    reports_ = bus.advertise<tws_msgs::DwellReports>("/esa/dwell_reports");
    bus.subscribe<tws_msgs::Frame>("/esa/frames", [this](const auto& message) { frames_.push_back(message); });
    bus.subscribe<tws_msgs::Tracks>("/esa/tracks", [this](const auto& message) { tracks_.push_back(message); });
    bus.subscribe<tws_msgs::TrackDatabase>("/esa/track_database",
                                           [this](const auto& message) { databases_.push_back(message); });
  }

  void placeArray() {
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "esa";
    site.transform.rotation.w = 1.0;
    graph_.addNode("sites").publishStaticTransform(site);
  }

  /// The report of the period of 0.1 s that ends at `end` [s].
  tws_msgs::DwellReports report(double end, const std::vector<Dwell>& dwells) {
    tws_msgs::DwellReports message;
    message.header.stamp = tws_runtime::toTime(end);
    message.header.frame_id = message.radar = "esa";
    message.resource_period = next_period_++;
    message.duration = 0.1;
    message.expected_next_dwell = tws_runtime::toTime(end);
    for (const Dwell& dwell : dwells) message.dwells.push_back(toMessage(dwell));
    return message;
  }

  void publish(const tws_msgs::DwellReports& message) {
    reports_.publish(message);
    graph_.drain();
  }

  std::uint64_t count(const std::string& name) const {
    for (const auto& reading : graph_.counters())
      if (reading.name == name) return reading.value;
    return 0;
  }

  std::vector<tws_msgs::Frame> framesOf(std::uint8_t status) const {
    std::vector<tws_msgs::Frame> found;
    for (const auto& frame : frames_)
      if (frame.status == status) found.push_back(frame);
    return found;
  }

  std::ostringstream log_;
  tws_runtime::LocalGraph graph_{log_};
  tws_runtime::Publisher<tws_msgs::DwellReports> reports_;
  std::uint32_t next_period_ = 0;
  std::vector<tws_msgs::Frame> frames_;
  std::vector<tws_msgs::Tracks> tracks_;
  std::vector<tws_msgs::TrackDatabase> databases_;
};

}  // namespace esa_frame_builder
