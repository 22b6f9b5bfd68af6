#pragma once

#include <string>

namespace tws_runtime {

/// Goes over a whole bag of format 2.0 (wiki.ros.org/Bags/Format/2.0) before rosbag opens it, which believes each
/// length, count and offset in it. Throws std::runtime_error, one line that names the file, the byte, what is wrong
/// there and what to do, unless
/// - all records that rosbag reads are within the file, none of them twice, and the fields it takes have their sizes;
/// - each chunk unpacks to as many bytes as it says, which are a bounded multiple of its own;
/// - each entry of the index is a message of its connection, and each message in a chunk has one.
/// Takes time in proportion to what the bag unpacks to, and the memory of one chunk.
void checkBag(const std::string& path);

}  // namespace tws_runtime
