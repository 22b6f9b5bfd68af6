#include "run_input.h"

#include <asterix_bridge/asterix_node.h>
#include <radar_sim/radar_sim_node.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/local_graph.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tws_launch {
namespace {

/// "sps12" of "/sps12/detections".
std::string firstPart(const std::string& topic) { return topic.substr(1, topic.find('/', 1) - 1); }

/// Of all topics in the view, in order.
std::vector<std::string> firstParts(rosbag::View& view) {
  std::set<std::string> names;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) names.insert(firstPart(connection->topic));
  return {names.begin(), names.end()};
}

/// By the simulator itself, so that what it would refuse is refused here, before anything is started.
void readScenario(RunInput& input, std::optional<double> duration) {
  YAML::Node parameters;
  parameters["scenario"] = input.path;
  if (duration) parameters["duration"] = *duration;
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  const radar_sim::RadarSimNode simulator(graph.addNode("radar_sim", parameters));
  input.radars = simulator.radars();
  // As of a bag, whose topics have no order: the trackers' numbering of radars must be the same for both.
  std::sort(input.radars.begin(), input.radars.end());
  input.secondary_radars = simulator.secondaryRadars();
  std::sort(input.secondary_radars.begin(), input.secondary_radars.end());
  input.array_radars = simulator.arrayRadars();
  std::sort(input.array_radars.begin(), input.array_radars.end());
  input.range_radars = simulator.rangeRadars();
  std::sort(input.range_radars.begin(), input.range_radars.end());
  input.feeds_tracks = simulator.feedsTracks();
  input.length = simulator.duration();
}

void readBag(RunInput& input, std::optional<double> duration) try {
  const rosbag::Bag bag(input.path);
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::Detections>()));
  input.radars = firstParts(view);
  rosbag::View plots(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::SsrPlots>()));
  input.secondary_radars = firstParts(plots);
  rosbag::View dwells(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::DwellReports>()));
  input.array_radars = firstParts(dwells);
  view.addQuery(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::DwellReports>()));
  rosbag::View profiles(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::RangeProfile>()));
  input.range_radars = firstParts(profiles);
  view.addQuery(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::RangeProfile>()));
  input.feeds_tracks = rosbag::View(bag, rosbag::TopicQuery("/primary/tracks")).size() > 0;
  rosbag::View windows(bag, rosbag::TopicQuery("/tws/tracks"));
  if (windows.size() > 0) input.windows = windows.begin()->instantiate<tws_msgs::Tracks>()->radar;
  if (view.size() > 0) input.length = (view.getEndTime() - view.getBeginTime()).toSec();
  input.length = std::min(input.length, duration.value_or(input.length));
} catch (const std::exception& error) {
  throw std::runtime_error(input.path + ": " + error.what());
}

// Radars of one recording seldom stand at one site, and only such may feed one tracker.
void readRecording(RunInput& input, std::optional<double> duration) {
  const asterix_bridge::RecordingSummary summary = asterix_bridge::inspectRecording(input.path);
  if (!summary.radars.empty()) input.radars = {summary.radars.front()};
  input.length = std::min(summary.length, duration.value_or(summary.length));
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

bool isBag(const std::string& path) { return endsWith(path, ".bag"); }

bool isRecording(const std::string& path) {
  return !isBag(path) && !endsWith(path, ".yaml") && !endsWith(path, ".yml");
}

RunInput inspectInput(const std::string& path, std::optional<double> duration) {
  RunInput input;
  input.path = path;
  input.is_bag = isBag(path);
  input.is_recording = isRecording(path);
  if (input.is_bag)
    readBag(input, duration);
  else
    input.is_recording ? readRecording(input, duration) : readScenario(input, duration);
  if (input.radars.empty() && input.array_radars.empty() && input.range_radars.empty())
    throw std::runtime_error(path + ": no primary radar in it");
  return input;
}

}  // namespace tws_launch
