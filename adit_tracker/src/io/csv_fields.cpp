#include "io/csv_fields.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace adit_tracker {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

double numberIn(std::string_view field, const char* column) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) {
    throw std::runtime_error(std::string(column) + " is no number: '" + std::string(field) + "'");
  }
  if (!std::isfinite(value)) throw std::runtime_error(std::string(column) + " is not finite");
  return value;
}

}  // namespace adit_tracker
