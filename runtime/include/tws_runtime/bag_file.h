#pragma once

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <tws_runtime/channel.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tws_runtime {

/// Opens a bag for reading, after a check of all that rosbag believes. Throws std::runtime_error, one line that names
/// the file, what is wrong with it at which byte, and what to do.
void openBag(rosbag::Bag& bag, const std::string& path);

/// The message as `read` (MessageType) makes it. Throws std::runtime_error, which names topic and time, when its bytes
/// are not that. `bytes` is room for them, kept from message to message.
boost::shared_ptr<const void> readMessage(const rosbag::MessageInstance& message, decltype(MessageType::read) read,
                                          std::vector<std::uint8_t>& bytes);

/// The message as an M; null when it is of another type, or of another version of it. Throws as readMessage().
template <class M>
boost::shared_ptr<const M> messageAs(const rosbag::MessageInstance& message) {
  if (!message.isType<M>()) return nullptr;
  std::vector<std::uint8_t> bytes;
  return boost::static_pointer_cast<const M>(readMessage(message, messageType<M>().read, bytes));
}

}  // namespace tws_runtime
