#pragma once

#include <string>

namespace tws_runtime {

/// Goes over the records of a bag and throws std::runtime_error, which names the file, when one is longer than what is
/// left of the file: rosbag would ask for so much memory before it looks. Reads lengths only; what has not the first
/// line of a bag is left to rosbag, which says so.
void checkBagLengths(const std::string& path);

}  // namespace tws_runtime
