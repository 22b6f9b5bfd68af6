#pragma once

#include <rosbag/bag.h>
#include <tws_runtime/channel.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace tws_runtime {

/// Writes messages into a bag file. It ends while there is still room for the index, so that what was recorded can be
/// read.
class BagRecorder {
 public:
  /// Records `topics`, or all when there are none. Throws std::runtime_error that names the file when it cannot be
  /// written, or when little more fits on the disk than the index.
  BagRecorder(const std::string& path, const std::vector<std::string>& topics);
  /// Writes the index of what was not closed, if it can.
  ~BagRecorder();
  BagRecorder(const BagRecorder&) = delete;
  BagRecorder& operator=(const BagRecorder&) = delete;

  /// The header is kept by address: one for each channel. Times before ros::TIME_MIN become that. Throws as the
  /// constructor, and closes the bag before it does.
  void write(const std::string& topic, ros::Time time, const MessageType& type,
             const boost::shared_ptr<const void>& message, const boost::shared_ptr<ros::M_string>& header);
  /// Writes the index. Throws as the constructor.
  void close();

 private:
  void checkSpace();
  [[noreturn]] void fail(const std::exception& error);

  std::string path_;
  std::set<std::string> topics_;
  std::unique_ptr<rosbag::Bag> bag_ = std::make_unique<rosbag::Bag>();
  std::uint64_t checked_at_ = 0;  ///< Size of the bag when the disk was last looked at [bytes].
};

/// What rosbag keeps of the connection from `node` ("/adit").
boost::shared_ptr<ros::M_string> connectionHeader(const std::string& node, const std::string& topic, bool latched,
                                                  const MessageType& type);

}  // namespace tws_runtime
