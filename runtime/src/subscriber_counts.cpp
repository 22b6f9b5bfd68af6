#include "subscriber_counts.h"

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/time.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "process_subscriptions.h"

namespace tws_runtime {
namespace {

using XmlRpc::XmlRpcValue;
using Topics = std::set<std::string>;

constexpr double kTurn = 0.01;  // [s of wall time] at one node, before the next one's turn

bool isText(const XmlRpcValue& value) { return value.getType() == XmlRpcValue::TypeString; }
bool isList(const XmlRpcValue& value, int least) {
  return value.getType() == XmlRpcValue::TypeArray && value.size() >= least;
}

XmlRpcValue ask(const std::string& method, const std::string& about = "") {
  XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  if (!about.empty()) request[1] = about;
  return ros::master::execute(method, request, response, payload, false) ? payload : XmlRpcValue();
}

/// The nodes that publish one of the topics, and which.
std::map<std::string, Topics> publishersOf(const Topics& topics) {
  std::map<std::string, Topics> found;
  XmlRpcValue state = ask("getSystemState");
  if (!isList(state, 1) || !isList(state[0], 0)) return found;
  XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {
    XmlRpcValue& row = published[i];  // topic, nodes
    if (!isList(row, 2) || !isText(row[0]) || !isList(row[1], 0)) continue;
    const std::string topic = row[0];
    if (topics.count(topic) == 0) continue;
    for (int k = 0; k < row[1].size(); ++k)
      if (isText(row[1][k])) found[static_cast<std::string>(row[1][k])].insert(topic);
  }
  return found;
}

/// Asks one node for its connections, without waiting for it.
class Question {
 public:
  Question(const std::string& uri, const Topics& topics)
      : is_of_this_process_(uri == ros::XMLRPCManager::instance()->getServerURI()) {
    for (const std::string& topic : topics) counts_[topic] = 0;
    std::string host;
    std::uint32_t port = 0;
    if (!ros::network::splitURI(uri, host, port)) return;
    client_ = std::make_unique<XmlRpc::XmlRpcClient>(host.c_str(), static_cast<int>(port), "/");
    XmlRpcValue request;
    request[0] = ros::this_node::getName();
    if (!client_->executeNonBlock("getBusInfo", request)) client_.reset();
  }

  bool isOpen() const { return client_ != nullptr; }

  void work() {
    client_->_disp.work(kTurn);
    XmlRpcValue answer;
    const bool answered = client_->executeCheckDone(answer);
    if (answered || client_->_disp._sources.empty()) client_.reset();  // or the connection failed
    if (answered && isList(answer, 3) && isList(answer[2], 0)) count(answer[2]);
  }

  const SubscriberCounts& counts() const { return counts_; }

 private:
  /// A connection: number, the other node, direction ("o": out), transport, topic, and more.
  void count(XmlRpcValue& connections) {
    for (int i = 0; i < connections.size(); ++i) {
      XmlRpcValue& row = connections[i];
      if (!isList(row, 5) || !isText(row[2]) || !isText(row[3]) || !isText(row[4])) continue;
      const std::string direction = row[2], transport = row[3], topic = row[4];
      const auto found = counts_.find(topic);
      if (direction != "o" || found == counts_.end()) continue;
      // roscpp makes one connection of all subscribers of a process.
      const bool is_own = is_of_this_process_ && transport == "INTRAPROCESS";
      found->second += is_own ? std::max(1U, ProcessSubscription::count(topic)) : 1;
    }
  }

  bool is_of_this_process_;
  SubscriberCounts counts_;
  std::unique_ptr<XmlRpc::XmlRpcClient> client_;
};

void workUntilAnswered(std::vector<Question>& questions, ros::WallTime end) {
  for (bool waiting = true; waiting && ros::WallTime::now() < end;) {
    waiting = false;
    for (Question& question : questions) {
      if (question.isOpen()) question.work();
      waiting = waiting || question.isOpen();
    }
  }
}

}  // namespace

SubscriberCounts subscriberCounts(const std::set<std::string>& topics, double timeout) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(timeout);
  std::vector<Question> questions;
  for (const auto& [node, its_topics] : publishersOf(topics)) {
    XmlRpcValue uri = ask("lookupNode", node);
    questions.emplace_back(isText(uri) ? static_cast<std::string>(uri) : "", its_topics);
  }
  workUntilAnswered(questions, end);
  SubscriberCounts least;
  for (const Question& question : questions)
    for (const auto& [topic, count] : question.counts()) {
      const auto [entry, is_first] = least.emplace(topic, count);
      if (!is_first) entry->second = std::min(entry->second, count);
    }
  for (const std::string& topic : topics) least.emplace(topic, 0);
  return least;
}

}  // namespace tws_runtime
