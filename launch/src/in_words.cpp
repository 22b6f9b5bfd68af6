#include "in_words.h"

#include <iomanip>
#include <sstream>

namespace tws_launch {

std::string oneDecimal(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << value;
  return text.str();
}

}  // namespace tws_launch
