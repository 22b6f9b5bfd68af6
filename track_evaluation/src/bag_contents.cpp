#include "bag_contents.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>

#include <set>
#include <stdexcept>

namespace track_evaluation {
namespace {

/// Names N of topics /N/<last> of message type M.
template <class M>
std::vector<std::string> namesOf(const rosbag::Bag& bag, const std::string& last) {
  std::set<std::string> names;
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<M>()));
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    const std::string& topic = connection->topic;
    const auto slash = topic.rfind('/');
    if (topic.size() > last.size() + 1 && slash > 0 && topic.substr(slash + 1) == last)
      names.insert(topic.substr(1, slash - 1));
  }
  return {names.begin(), names.end()};
}

bool holds(const rosbag::Bag& bag, const std::string& topic) {
  rosbag::View view(bag, rosbag::TopicQuery(topic));
  return view.size() > 0;
}

BagContents inspect(const std::string& path) {
  const rosbag::Bag bag(path);
  if (rosbag::View(bag).size() == 0) throw std::runtime_error(path + ": is empty");
  BagContents contents;
  contents.trackers = namesOf<tws_msgs::Tracks>(bag, "tracks");
  contents.correlators = namesOf<tws_msgs::CorrelatedTracks>(bag, "tracks");
  contents.radars = namesOf<tws_msgs::Detections>(bag, "detections");
  contents.secondary_radars = namesOf<tws_msgs::SsrPlots>(bag, "plots");
  contents.array_radars = namesOf<tws_msgs::DwellReports>(bag, "dwell_reports");
  contents.truth = holds(bag, "/truth");
  contents.transforms = holds(bag, "/tf_static");
  return contents;
}

}  // namespace

std::vector<std::string> BagContents::topics() const {
  std::vector<std::string> topics;
  for (const std::string& name : trackers) topics.push_back("/" + name + "/tracks");
  for (const std::string& name : correlators) topics.push_back("/" + name + "/tracks");
  for (const std::string& name : radars) topics.push_back("/" + name + "/detections");
  for (const std::string& name : secondary_radars) topics.push_back("/" + name + "/plots");
  if (truth) topics.emplace_back("/truth");
  if (transforms) topics.emplace_back("/tf_static");
  return topics;
}

BagContents inspectBag(const std::string& path) {
  BagContents contents;
  try {
    contents = inspect(path);
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + ": is missing, truncated or no bag: " + error.what());
  }
  if (contents.trackers.empty()) throw std::runtime_error(path + ": holds no tracks (tws_msgs/Tracks on /NAME/tracks)");
  return contents;
}

}  // namespace track_evaluation
