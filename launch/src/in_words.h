#pragma once

#include <string>
#include <vector>

namespace tws_launch {

/// With one digit after the point.
std::string oneDecimal(double value);

/// With a space, or something else, between one and the next.
std::string joined(const std::vector<std::string>& words, const std::string& between = " ");

}  // namespace tws_launch
