#pragma once

#include <string>
#include <vector>

namespace tws_launch {

/// With one digit after the point.
std::string oneDecimal(double value);

/// With a space between one and the next.
std::string joined(const std::vector<std::string>& words);

}  // namespace tws_launch
