#include <tws_runtime/bag_file.h>

#include <algorithm>
#include <stdexcept>

#include "bag_check.h"

namespace tws_runtime {

void openBag(rosbag::Bag& bag, const std::string& path) {
  checkBag(path);
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const std::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw std::runtime_error(path + ": cannot be read as a bag: " + reason);
  }
}

boost::shared_ptr<const void> readMessage(const rosbag::MessageInstance& message, decltype(MessageType::read) read,
                                          std::vector<std::uint8_t>& bytes) try {
  bytes.resize(message.size());
  const auto size = static_cast<std::uint32_t>(bytes.size());
  ros::serialization::OStream to(bytes.data(), size);
  message.write(to);
  ros::serialization::IStream from(bytes.data(), size);
  return read(from);
} catch (const ros::Exception& error) {  // Of rosbag or of deserialisation.
  throw std::runtime_error("topic " + message.getTopic() + " at " + std::to_string(message.getTime().toSec()) +
                           " s cannot be read: " + error.what());
}

}  // namespace tws_runtime
