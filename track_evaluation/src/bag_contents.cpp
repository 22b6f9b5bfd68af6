#include "bag_contents.h"

#include <ros/names.h>
#include <rosbag/view.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/GraphDescription.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/parameters.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace track_evaluation {
namespace {

std::string absolute(const std::string& topic) { return ros::names::clean("/" + topic); }

std::string parentOf(const std::string& name) { return name.substr(0, name.rfind('/')); }

/// Topics of message type M, absolute.
template <class M>
std::set<std::string> topicsOf(const rosbag::Bag& bag) {
  std::set<std::string> topics;
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<M>()));
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) topics.insert(absolute(connection->topic));
  return topics;
}

/// /SPACE/NAME of the topics /SPACE/NAME/<last> of message type M.
template <class M>
std::vector<std::string> publishersOf(const rosbag::Bag& bag, const std::string& last) {
  std::vector<std::string> names;
  for (const std::string& topic : topicsOf<M>(bag))
    if (topic.substr(topic.rfind('/') + 1) == last && topic.rfind('/') > 0) names.push_back(parentOf(topic));
  return names;
}

/// The namespace of all names; "" when they have not the same.
std::string commonSpace(const std::vector<std::vector<std::string>*>& lists) {
  std::set<std::string> spaces;
  for (const auto* names : lists)
    for (const std::string& name : *names) spaces.insert(parentOf(name));
  return spaces.size() == 1 ? *spaces.begin() : "";
}

std::string truthIn(const rosbag::Bag& bag, const std::string& space) {
  const std::set<std::string> topics = topicsOf<tws_msgs::Truth>(bag);
  if (topics.count(space + "/truth") > 0) return space + "/truth";
  return topics.size() == 1 ? *topics.begin() : "";
}

/// As the graph that the run consisted of had it for its nodes.
YAML::Node originIn(const rosbag::Bag& bag) {
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<tws_msgs::GraphDescription>()));
  for (const rosbag::MessageInstance& message : view) {
    const auto graph = tws_runtime::messageAs<tws_msgs::GraphDescription>(message);
    if (!graph) continue;
    for (const YAML::Node& node : tws_runtime::parseParameters(graph->yaml, "its graph description")["nodes"])
      if (node["parameters"] && node["parameters"]["origin"]) return node["parameters"]["origin"];
  }
  return YAML::Node();
}

BagContents inspect(const rosbag::Bag& bag) {
  rosbag::View all(bag);
  if (all.size() == 0) throw std::runtime_error("is empty");
  BagContents contents;
  contents.trackers = publishersOf<tws_msgs::Tracks>(bag, "tracks");
  contents.correlators = publishersOf<tws_msgs::CorrelatedTracks>(bag, "tracks");
  contents.radars = publishersOf<tws_msgs::Detections>(bag, "detections");
  contents.secondary_radars = publishersOf<tws_msgs::SsrPlots>(bag, "plots");
  contents.array_radars = publishersOf<tws_msgs::DwellReports>(bag, "dwell_reports");
  const std::vector<std::vector<std::string>*> lists{&contents.trackers, &contents.correlators, &contents.radars,
                                                     &contents.secondary_radars, &contents.array_radars};
  contents.space = commonSpace(lists);
  for (auto* names : lists)
    for (std::string& name : *names) name.erase(0, contents.space.size() + 1);
  contents.truth = truthIn(bag, contents.space);
  contents.origin.reset(originIn(bag));
  const auto connections = all.getConnections();
  contents.transforms = std::any_of(connections.begin(), connections.end(),
                                    [](const auto* connection) { return absolute(connection->topic) == "/tf_static"; });
  return contents;
}

}  // namespace

std::vector<std::string> BagContents::topics() const {
  std::vector<std::string> topics;
  const auto add = [&](const std::vector<std::string>& names, const std::string& last) {
    for (const std::string& name : names) topics.push_back(std::string(space).append("/").append(name).append(last));
  };
  add(trackers, "/tracks");
  add(correlators, "/tracks");
  add(radars, "/detections");
  add(secondary_radars, "/plots");
  if (!truth.empty()) topics.push_back(truth);
  if (transforms) topics.emplace_back("/tf_static");
  return topics;
}

std::map<std::string, std::string> BagContents::remaps() const {
  return truth.empty() ? std::map<std::string, std::string>()
                       : std::map<std::string, std::string>{{space + "/truth", truth}};
}

BagContents inspectBag(const std::string& path) {
  rosbag::Bag bag;
  tws_runtime::openBag(bag, path);
  BagContents contents;
  try {
    contents = inspect(bag);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(path + ": its graph description cannot be read: " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (contents.trackers.empty()) throw std::runtime_error(path + ": holds no tracks (tws_msgs/Tracks on NAME/tracks)");
  return contents;
}

}  // namespace track_evaluation
