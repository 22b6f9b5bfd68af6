#pragma once

#include <string>

namespace tws_launch {

/// The absolute form of a topic's or node's name that is said in the namespace `space` ("" or "/": the root), as ROS
/// resolves it: "sps12/detections" in "/ship" is "/ship/sps12/detections". Throws std::runtime_error when it is none.
std::string resolvedName(const std::string& space, const std::string& name);

/// "/ship/sps12" of "/ship/sps12/detections", "" of "/truth"; `name` is absolute.
std::string spaceOf(const std::string& name);

/// "detections" of "/ship/sps12/detections".
std::string lastPart(const std::string& name);

/// "sps12/detections" of "/ship/sps12/detections" in "/ship"; the name itself when it stands elsewhere.
std::string relativeName(const std::string& space, const std::string& name);

}  // namespace tws_launch
