#include "bag_recorder.h"

#include <algorithm>
#include <stdexcept>

#include "any_message.h"

namespace tws_runtime {

BagRecorder::BagRecorder(const std::string& path, const std::vector<std::string>& topics)
    : path_(path), topics_(topics.begin(), topics.end()) {
  try {
    bag_.open(path, rosbag::bagmode::Write);
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
}

void BagRecorder::write(const std::string& topic, ros::Time time, const MessageType& type,
                        const boost::shared_ptr<const void>& message, const boost::shared_ptr<ros::M_string>& header) {
  if (!topics_.empty() && topics_.count(topic) == 0) return;
  try {
    bag_.write(topic, std::max(time, ros::TIME_MIN), AnyMessage{&type, message}, header);
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
}

void BagRecorder::close() {
  try {
    bag_.close();
  } catch (const rosbag::BagException& error) {
    fail(error);
  }
}

void BagRecorder::fail(const std::exception& error) const {
  throw std::runtime_error(path_ + ": cannot be written: " + error.what());
}

boost::shared_ptr<ros::M_string> connectionHeader(const std::string& node, const std::string& topic, bool latched,
                                                  const MessageType& type) {
  auto header = boost::make_shared<ros::M_string>();
  (*header)["callerid"] = node;
  (*header)["latching"] = latched ? "1" : "0";
  (*header)["md5sum"] = type.md5sum;
  (*header)["message_definition"] = type.definition;
  (*header)["topic"] = topic;
  (*header)["type"] = type.datatype;
  return header;
}

}  // namespace tws_runtime
