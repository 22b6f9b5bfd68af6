#pragma once

#include <ros/master.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <string>

/// Does the node `publisher` already send that topic to this process? A subscriber counts a publisher from when it
/// begins to connect, a little before the other side knows of it: what is sent in between is lost.
inline bool sendsToUs(const std::string& publisher, const std::string& topic) {
  XmlRpc::XmlRpcValue question, answer, uri;
  question[0] = ros::this_node::getName();
  question[1] = publisher;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", question, answer, uri, false)) return false;
  if (!ros::network::splitURI(uri, host, port)) return false;
  XmlRpc::XmlRpcClient node(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue who;
  who[0] = ros::this_node::getName();
  if (!node.execute("getBusInfo", who, answer) || answer.size() != 3) return false;
  XmlRpc::XmlRpcValue& connections = answer[2];  // each: number, the other side, direction, transport, topic, …
  for (int i = 0; i < connections.size(); ++i) {
    XmlRpc::XmlRpcValue& connection = connections[i];
    if (static_cast<std::string>(connection[1]) == ros::this_node::getName() &&
        static_cast<std::string>(connection[2]) == "o" && static_cast<std::string>(connection[4]) == topic)
      return true;
  }
  return false;
}
