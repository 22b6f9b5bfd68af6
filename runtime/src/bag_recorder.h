#pragma once

#include <rosbag/bag.h>
#include <tws_runtime/channel.h>

#include <set>
#include <string>
#include <vector>

namespace tws_runtime {

/// Writes messages into a bag file.
class BagRecorder {
 public:
  /// Records `topics`, or all when there are none. Throws std::runtime_error that names the file when it cannot be
  /// written.
  BagRecorder(const std::string& path, const std::vector<std::string>& topics);

  /// The header is kept by address: one for each channel. Times before ros::TIME_MIN become that.
  void write(const std::string& topic, ros::Time time, const MessageType& type,
             const boost::shared_ptr<const void>& message, const boost::shared_ptr<ros::M_string>& header);
  /// Writes the index. Throws as the constructor.
  void close();

 private:
  [[noreturn]] void fail(const std::exception& error) const;

  std::string path_;
  std::set<std::string> topics_;
  rosbag::Bag bag_;
};

/// What rosbag keeps of the connection from `node` ("/adit").
boost::shared_ptr<ros::M_string> connectionHeader(const std::string& node, const std::string& topic, bool latched,
                                                  const MessageType& type);

}  // namespace tws_runtime
