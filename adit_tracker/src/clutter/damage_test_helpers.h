#pragma once

#include <cstddef>
#include <string>

#include <tws_core/random_test_helpers.h>

namespace adit_tracker {

/// The text with one to three damages: some characters lost, or one that is another.
inline std::string damaged(std::string text, std::mt19937_64& generator) {
  for (int damage = tws::uniformInt(generator, 1, 3); damage > 0; --damage) {
    const auto where = static_cast<std::size_t>(tws::uniformInt(generator, 0, static_cast<int>(text.size()) - 1));
    if (tws::uniformInt(generator, 0, 1) == 0)
      text.erase(where, static_cast<std::size_t>(tws::uniformInt(generator, 1, 5)));
    else
      text[where] = static_cast<char>(tws::uniformInt(generator, 0, 255));
    if (text.empty()) text = "\n";
  }
  return text;
}

}  // namespace adit_tracker
