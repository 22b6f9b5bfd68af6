#pragma once

#include <algorithm>
#include <string_view>

namespace adit_tracker {

/// Without blanks, tabs and the carriage return around it.
std::string_view trimmed(std::string_view text);

/// The first N fields of a line of a CSV file, trimmed; false: there are fewer.
template <std::size_t N>
bool splitFields(std::string_view line, std::string_view (&fields)[N]) {
  for (std::string_view& field : fields) {
    if (line.data() == nullptr) return false;
    const auto comma = line.find(',');
    field = trimmed(line.substr(0, comma));
    line = comma == std::string_view::npos ? std::string_view{} : line.substr(comma + 1);
  }
  return true;
}

/// The finite number that a field holds. Throws std::runtime_error with the reason, which names the column.
double numberIn(std::string_view field, const char* column);

}  // namespace adit_tracker
