#include "graph_resolver.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "choice_checks.h"
#include "condition.h"
#include "graph_lists.h"
#include "node_parameters.h"
#include "package_folder.h"
#include "template.h"
#include "topic_name.h"

namespace tws_launch {
namespace {

YAML::Node listOf(const std::vector<std::string>& words) {
  YAML::Node list(YAML::NodeType::Sequence);
  for (const std::string& word : words) list.push_back(word);
  return list;
}

class Resolver {
 public:
  Resolver(const GraphFile& file, const RunInput& input, const RunOptions& options, bool live)
      : file_(file), input_(input), options_(options), live_(live), chosen_(merged(input.trackers, options.choices())) {
    graph_.space = options.has("namespace") ? resolvedName("", options["namespace"]) : input.space;
    if (graph_.space == "/") graph_.space.clear();
    graph_.sensors = input.sensors;
    graph_.remaps = input.remaps;
    graph_.nodelets = options.flag("nodelets");
  }

  GraphDescription graph() {
    refuseUnknownChoices(file_, chosen_);
    for (const NodeRow& row : file_.nodes) {
      addIfItBelongs(row, row.name);
      for (const auto& [name, choice] : chosen_)
        if (choice.like == row.name) addIfItBelongs(row, name);
    }
    refuseIdleChoices(file_, graph_, chosen_);
    refuseUnknownRadars(file_, input_, graph_, chosen_);
    refuseTwoOnOneTopic(graph_);
    for (NodeDescription& node : graph_.nodes) setListsOfTopics(node);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) setWhatFollowsFromOthers(i);
    describeItself();
    return std::move(graph_);
  }

 private:
  // ---- which nodes ----

  void addIfItBelongs(const NodeRow& row, const std::string& name) {
    if (!holds(row.when, [&](const std::string& word) { return is(word, name); })) return;
    const auto choice = chosen_.find(name);
    if (choice != chosen_.end() && !choice->second.on.value_or(true)) return;
    if (row.role == "tracker" && input_.recorded && choice == chosen_.end() && !input_.recorded->find(name)) return;
    addNode(row, name);
  }

  /// What a condition's word means, to the node of that name.
  bool is(const std::string& word, const std::string& name) const {
    if (word == "live") return live_;
    if (word == "scenario") return input_.kind == InputKind::kScenario;
    if (word == "bag") return input_.kind == InputKind::kBag;
    if (word == "recording") return input_.kind == InputKind::kRecording;
    if (word == "feed") return input_.kind == InputKind::kFeed;
    if (word == "real_time") return live_ && input_.kind != InputKind::kBag && std::stod(options_["rate"]) == 1.0;
    if (word == "record") return options_.has("record");
    if (word == "rviz" || word == "show_windows") return options_.flag(word);
    if (word == "chosen") return isChosen(name);
    const auto dot = word.find('.');
    const std::vector<std::string> names = input_.names(file_.kind(word.substr(0, dot)).name);
    return dot == std::string::npos ? !names.empty() : std::count(names.begin(), names.end(), word.substr(dot + 1)) > 0;
  }

  bool isChosen(const std::string& name) const {
    const auto choice = chosen_.find(name);
    if (choice != chosen_.end() && choice->second.on) return *choice->second.on;
    return input_.recorded && input_.recorded->find(name);
  }

  // ---- one node ----

  void addNode(const NodeRow& row, const std::string& name) {
    NodeDescription node;
    node.package = row.package();
    node.type = row.type();
    node.name = name;
    node.role = row.role;
    node.quiet = row["quiet"].as<bool>(false);
    node.prefix = row["prefix"].as<std::string>("");
    node.parameters = nodeParameters(row, name, {input_, options_, chosen_}, wordsFor(nameOnly(name)));
    const TemplateWords words = wordsFor(node);
    if (row["respawn"]) node.respawn = filledIn(row["respawn"], words).as<std::string>("") == "true";
    for (const auto& topic : filledIn(row["says"] ? row["says"] : YAML::Node(YAML::NodeType::Map), words))
      node.says[resolve(topic.first.Scalar())] = topic.second.Scalar();
    if (row.role == "source")
      for (const auto& topic : sensorTopics()) node.says.insert(topic);
    graph_.nodes.push_back(node);
    rows_.push_back(&row);
  }

  std::map<std::string, std::string> sensorTopics() const {
    std::map<std::string, std::string> topics;
    for (const SensorKind& kind : file_.sensors)
      for (const std::string& sensor : input_.names(kind.name))
        for (const auto& [part, type] : kind.topics) topics[resolve(sensor + "/" + part)] = type;
    return topics;
  }

  // ---- words ----

  std::string resolve(const std::string& name) const { return resolvedName(graph_.space, name); }

  TemplateWords wordsFor(const NodeDescription& node) const {
    TemplateWords words;
    words.namesOf = [this](const std::string& kind) { return input_.names(file_.kind(kind).name); };
    words.holds = [this, name = node.name](const std::string& word) { return is(word, name); };
    words.valueOf = [this, name = node.name, parameters = node.parameters](const std::string& word) {
      if (word == "name") return YAML::Node(name);
      if (word == "origin") return input_.origin;
      const auto dot = word.find('.');
      const std::string rest = dot == std::string::npos ? "" : word.substr(dot + 1);
      const std::string group = word.substr(0, dot);
      if (group == "parameter") return parameters[rest] ? YAML::Node(parameters[rest].as<std::string>()) : YAML::Node();
      if (group == "all") return listOf(input_.names(file_.kind(rest).name));
      if (group == "first") return firstOf(input_.names(file_.kind(rest).name));
      if (group == "option") return optionValue(rest);
      return valueFromGraph(word, rest);
    };
    return words;
  }

  static NodeDescription nameOnly(const std::string& name) {
    NodeDescription node;
    node.name = name;
    return node;
  }

  static YAML::Node firstOf(const std::vector<std::string>& names) {
    return names.empty() ? YAML::Node() : YAML::Node(names.front());
  }

  YAML::Node optionValue(const std::string& name) const {
    std::string value = options_[name];
    if (name == "input") value = input_.path;
    if (name == "length") value = numberText(input_.length);
    if (name == "settings" && value.empty()) value = "asterix_bridge/config/asterix.yaml";
    if (name == "rviz_config" && value.empty()) value = packageFolder("tws_rviz") + "/config/ppi.rviz";
    if (name == "main_radar") value = options_.has("radars") ? "" : "radar";
    return value.empty() && name != "main_radar" ? YAML::Node() : YAML::Node(value);
  }

  static std::string numberText(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
  }

  /// Words whose meaning is known only when all nodes are.
  YAML::Node valueFromGraph(const std::string& word, const std::string& rest) const {
    if (!complete_ || word == "description") return later(word);
    const GraphLists lists(graph_, input_, sensorTopics());
    if (word == "trackers") return listOf(lists.namesOfType("tws_msgs/Tracks"));
    if (word == "correlators") return listOf(lists.namesOfType("tws_msgs/CorrelatedTracks"));
    if (word == "wait_for") return listOf(lists.waitedFor());
    if (word == "wait_for.trackers") return listOf(lists.waitedFor("source"));
    if (word == "played") return listOf(lists.played());
    if (word == "recorded") return listOf(lists.recorded());
    if (word.rfind("topics.", 0) == 0) return listOf(lists.topicsOfType(rest));
    if (word == "requests") return listOf(lists.requests());
    if (word == "request_remaps") return YAML::Node(lists.requestRemaps());
    if (word == "drawn.radars") return drawnRadars();
    if (word == "drawn.topics") return drawnTopics();
    if (word == "drawn.trackers") return drawn("tws_msgs/Tracks");
    if (word == "drawn.correlators") return drawn("tws_msgs/CorrelatedTracks");
    throw std::runtime_error("graph.yaml: $" + word + " is not known");
  }

  // ---- what follows from all nodes ----

  void setListsOfTopics(NodeDescription& node) {
    complete_ = true;
    const NodeRow& row = *rows_[static_cast<std::size_t>(&node - graph_.nodes.data())];
    if (row["hears"])
      for (const YAML::Node& topic : filledIn(row["hears"], wordsFor(node)))
        node.hears.push_back(resolve(topic.Scalar()));
    std::sort(node.hears.begin(), node.hears.end());
    node.hears.erase(std::unique(node.hears.begin(), node.hears.end()), node.hears.end());
    if (row.role == "recorder") node.hears = GraphLists(graph_, input_, sensorTopics()).recorded();
  }

  void setWhatFollowsFromOthers(std::size_t i) {
    NodeDescription& node = graph_.nodes[i];
    const NodeRow& row = *rows_[i];
    const TemplateWords words = wordsFor(node);
    node.parameters = completed(node.parameters, words);
    if (row["args"]) node.arguments = filledInArguments(row["args"].as<std::string>(), words);
    if (node.program() == "rviz/rviz" && node.arguments.size() > 1) node.arguments[1] = filePath(node.arguments[1]);
    if (row["remaps"])
      for (const auto& remap : filledIn(row["remaps"], words))
        node.remaps[resolve(remap.first.Scalar())] = resolve(remap.second.Scalar());
  }

  void describeItself() {
    for (NodeDescription& node : graph_.nodes) {
      if (!node.parameters["graph"] || laterWord(node.parameters["graph"]).empty()) continue;
      node.parameters.remove("graph");
      node.parameters["graph"] = toYaml(graph_);
    }
  }

  // ---- the picture ----

  YAML::Node drawnRadars() const {
    YAML::Node radars(YAML::NodeType::Sequence);
    std::set<std::string> known;
    for (const char* kind : {"rotating", "secondary"})
      for (const std::string& name : input_.names(kind)) {
        YAML::Node radar;
        radar["name"] = name;
        if (known.insert(name).second) radars.push_back(radar);
      }
    return radars;
  }

  /// The topics of a type of all nodes that are drawn, with what their rows say of it.
  YAML::Node drawn(const std::string& type) const {
    YAML::Node list(YAML::NodeType::Sequence);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const NodeDescription& node = graph_.nodes[i];
      const YAML::Node row = (*rows_[i])["draw"];
      if (!row || !holds(row["when"].as<std::string>(""), wordsFor(node).holds)) continue;
      for (const auto& [topic, its_type] : node.says) {
        if (its_type != type) continue;
        YAML::Node entry = filledIn(row, wordsFor(node));
        entry.remove("when");
        entry["topic"] = relativeName(graph_.space, topic);
        if (!entry["name"]) entry["name"] = node.name;
        list.push_back(entry);
      }
    }
    return list;
  }

  YAML::Node drawnTopics() const {
    YAML::Node topics(YAML::NodeType::Sequence);
    for (const char* type : {"tws_msgs/Tracks", "tws_msgs/CorrelatedTracks"})
      for (const YAML::Node& entry : drawn(type)) topics.push_back(entry["topic"]);
    return topics;
  }

  const GraphFile& file_;
  const RunInput& input_;
  const RunOptions& options_;
  const bool live_;
  const TrackerChoices chosen_;
  bool complete_ = false;  ///< All nodes are there.
  GraphDescription graph_;
  std::vector<const NodeRow*> rows_;  ///< Of graph_.nodes.
};

}  // namespace

GraphDescription resolveGraph(const GraphFile& file, const RunInput& input, const RunOptions& options, bool live) {
  return Resolver(file, input, options, live).graph();
}

}  // namespace tws_launch
