#include "bag_input.h"

#include <rosbag/view.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/GraphDescription.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "in_words.h"
#include "topic_name.h"

namespace tws_launch {
namespace {

/// A topic of the bag.
struct Topic {
  std::string recorded;  ///< As it stands there, maybe without a leading slash.
  std::string name;      ///< Absolute.
  std::string type;
};

/// One topic of one sensor.
struct SensorTopic {
  std::string kind, sensor, part;
  std::string name;  ///< Absolute.
  std::string usual() const { return sensor + "/" + part; }
};

template <class M>
std::string radarAs(const rosbag::MessageInstance& message) {
  const auto read = tws_runtime::messageAs<M>(message);
  return read ? read->radar : "";
}

/// The radar that a message names; empty: it names none.
std::string radarOf(const rosbag::MessageInstance& message) {
  for (const auto& read : {&radarAs<tws_msgs::Detections>, &radarAs<tws_msgs::SectorMark>, &radarAs<tws_msgs::SsrPlots>,
                           &radarAs<tws_msgs::DwellReports>, &radarAs<tws_msgs::RangeProfile>})
    if (std::string radar = read(message); !radar.empty()) return radar;
  return "";
}

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

class BagReader {
 public:
  BagReader(RunInput& input, const GraphFile& file, const rosbag::Bag& bag) : input_(input), file_(file), bag_(bag) {
    std::set<std::string> known;
    rosbag::View all(bag_);
    for (const rosbag::ConnectionInfo* connection : all.getConnections())
      if (known.insert(connection->topic).second)
        topics_.push_back({connection->topic, resolvedName("", connection->topic), connection->datatype});
    for (const Topic& topic : topics_) input_.topics[topic.name] = topic.recorded;
  }

  void read(const std::string& space) {
    findSensors();
    keepTheseOf(space);
    refuseTwins();
    findFurtherTopics();
    input_.space = space.empty() ? commonSpace() : resolvedName("", space);
    for (const SensorTopic& topic : found_) remap(topic.usual(), topic.name);
    remapTruth();
    for (const SensorKind& kind : file_.sensors) input_.sensors[kind.name] = namesOf(kind);
    readDescription();
    if (!input_.recorded) readSigns();
    readLength();
  }

 private:
  /// Each kind by its first topic.
  void findSensors() {
    for (const SensorKind& kind : file_.sensors)
      for (const Topic& topic : topics_)
        if (topic.type == kind.topics.front().second) addSensor(kind, topic);
  }

  void addSensor(const SensorKind& kind, const Topic& topic) {
    const std::string name = nameOf(kind, topic);
    if (kind.takes(name)) found_.push_back({kind.name, name, kind.topics.front().first, topic.name});
  }

  /// A sensor's name stands in its messages, else in the topic: /NAME/detections.
  std::string nameOf(const SensorKind& kind, const Topic& topic) {
    std::string name = kind.only.empty() ? radarOf(first(topic)) : "";
    const std::string part = "/" + kind.topics.front().first;
    if (name.empty() && endsWith(topic.name, part)) name = lastPart(spaceOf(topic.name));
    if (name.empty() && kind.only.empty())
      throw std::runtime_error("topic " + topic.recorded + " holds " + topic.type +
                               ", but neither its messages nor its name say of which radar");
    return name;
  }

  rosbag::MessageInstance first(const Topic& topic) {
    views_.push_back(std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic.recorded)));
    return *views_.back()->begin();
  }

  void keepTheseOf(const std::string& space) {
    if (space.empty()) return;
    const std::string prefix = resolvedName("", space) + "/";
    const auto elsewhere = [&](const SensorTopic& topic) { return topic.name.compare(0, prefix.size(), prefix) != 0; };
    if (!std::all_of(found_.begin(), found_.end(), elsewhere))
      found_.erase(std::remove_if(found_.begin(), found_.end(), elsewhere), found_.end());
  }

  void refuseTwins() const {
    std::map<std::pair<std::string, std::string>, std::string> known;
    for (const SensorTopic& topic : found_) {
      const auto [twin, is_new] = known.emplace(std::pair{topic.usual(), topic.kind}, topic.name);
      if (!is_new)
        throw std::runtime_error("two radars are named " + topic.sensor + ": " + twin->second + " and " + topic.name +
                                 "; choose those of one namespace by --namespace");
    }
  }

  /// The other topics of each sensor: of several that name it, the one beside its first topic.
  void findFurtherTopics() {
    const std::vector<SensorTopic> sensors = found_;
    for (const SensorTopic& sensor : sensors) {
      const auto& parts = file_.kind(sensor.kind).topics;
      for (std::size_t i = 1; i < parts.size(); ++i) {
        const std::string name = topicOf(sensor, parts[i].first, parts[i].second);
        if (!name.empty()) found_.push_back({sensor.kind, sensor.sensor, parts[i].first, name});
      }
    }
  }

  std::string topicOf(const SensorTopic& sensor, const std::string& part, const std::string& type) {
    const std::string beside = spaceOf(sensor.name) + "/" + part;
    std::vector<std::string> candidates;
    for (const Topic& topic : topics_) {
      if (topic.type != type) continue;
      if (topic.name == beside) return topic.name;
      if (radarOf(first(topic)) == sensor.sensor) candidates.push_back(topic.name);
    }
    if (candidates.size() > 1)
      throw std::runtime_error("which one belongs to " + sensor.name + ": " + joined(candidates) + "?");
    return candidates.empty() ? "" : candidates.front();
  }

  /// The namespace in which all sensors have their usual names; "": there is none.
  std::string commonSpace() const {
    std::set<std::string> spaces;
    for (const SensorTopic& topic : found_)
      spaces.insert(endsWith(topic.name, "/" + topic.usual())
                        ? topic.name.substr(0, topic.name.size() - topic.usual().size() - 1)
                        : "");
    return spaces.size() == 1 ? *spaces.begin() : "";
  }

  void remap(const std::string& usual, const std::string& name) {
    const std::string expected = resolvedName(input_.space, usual);
    if (expected != name) input_.remaps[expected] = name;
  }

  void remapTruth() {
    std::vector<std::string> names;
    for (const Topic& topic : topics_)
      if (topic.type == "tws_msgs/Truth") names.push_back(topic.name);
    const auto usual = std::find(names.begin(), names.end(), resolvedName(input_.space, "truth"));
    if (usual == names.end() && names.size() == 1) remap("truth", names.front());
  }

  std::vector<std::string> namesOf(const SensorKind& kind) const {
    std::set<std::string> names;
    for (const SensorTopic& topic : found_)
      if (topic.kind == kind.name) names.insert(topic.sensor);
    return kind.ordered({names.begin(), names.end()});
  }

  void readDescription() {
    for (const Topic& topic : topics_) {
      if (topic.type != ros::message_traits::datatype<tws_msgs::GraphDescription>()) continue;
      const auto message = tws_runtime::messageAs<tws_msgs::GraphDescription>(first(topic));
      if (message && (!input_.recorded || spaceOf(topic.name) == input_.space))
        input_.recorded = graphFromYaml(message->yaml);
    }
    if (!input_.recorded) return;
    for (const NodeDescription& node : input_.recorded->nodes) {
      const YAML::Node& parameters = node.parameters;
      if (parameters.IsMap() && parameters["origin"]) input_.origin.reset(parameters["origin"]);
    }
  }

  /// Nodes that a bag without a description was recorded with.
  void readSigns() {
    for (const NodeRow& row : file_.nodes) {
      if (!row["sign"]) continue;
      const std::string name = resolvedName(input_.space, row["sign"]["topic"].as<std::string>());
      const auto topic = std::find_if(topics_.begin(), topics_.end(), [&](const Topic& t) { return t.name == name; });
      if (topic == topics_.end()) continue;
      TrackerChoice& choice = input_.trackers[row.name];
      choice.on = true;
      const auto tracks = tws_runtime::messageAs<tws_msgs::Tracks>(first(*topic));
      if (tracks) choice.parameters[row["sign"]["parameter"].as<std::string>()] = tracks->radar;
    }
  }

  void readLength() {
    std::vector<std::string> names;
    for (const SensorTopic& topic : found_)
      if (file_.kind(topic.kind).primary && topic.part == file_.kind(topic.kind).topics.front().first)
        names.push_back(input_.topics.at(topic.name));
    if (names.empty()) return;
    rosbag::View view(bag_, rosbag::TopicQuery(names));
    input_.length = tws_runtime::secondsBetween(view.getBeginTime(), view.getEndTime());
  }

  RunInput& input_;
  const GraphFile& file_;
  const rosbag::Bag& bag_;
  std::vector<Topic> topics_;
  std::vector<SensorTopic> found_;
  std::vector<std::unique_ptr<rosbag::View>> views_;  ///< Messages live as long as the view that they come from.
};

}  // namespace

void readBag(RunInput& input, const GraphFile& file, const std::string& space) {
  rosbag::Bag bag;
  tws_runtime::openBag(bag, input.path);
  try {
    BagReader(input, file, bag).read(space);
  } catch (const std::exception& error) {
    throw std::runtime_error(input.path + ": " + error.what());
  }
}

}  // namespace tws_launch
