#pragma once

#include <functional>
#include <string>

namespace tws_launch {

/// Whether a condition like "secondary and not fed or rotating" holds, of which `is` knows the words. "not" binds more
/// than "and", "and" more than "or"; the empty condition holds. Throws std::invalid_argument that quotes it when it
/// is none.
bool holds(const std::string& condition, const std::function<bool(const std::string&)>& is);

}  // namespace tws_launch
