#pragma once

#include <string>

namespace tws_launch {

/// With one digit after the point.
std::string oneDecimal(double value);

}  // namespace tws_launch
