#include <tws_core/number_file.h>

#include <stdexcept>
#include <string>

namespace tws {

NumberFile::NumberFile(std::uint32_t size, std::uint32_t resting)
    : size_(size), resting_(resting), available_(size - 1) {
  if (size < 2 || size >= kEnd) {
    throw std::invalid_argument("NumberFile: a file of " + std::to_string(size) +
                                " numbers cannot be kept; at least 2");
  }
}

std::optional<std::uint32_t> NumberFile::take() {
  if (available_ == 0) return std::nullopt;
  --available_;
  if (!hasRested()) {
    list_.push_back(kUsed);
    return static_cast<std::uint32_t>(list_.size() - 1);
  }
  const std::uint32_t number = next_;
  next_ = list_[number];
  list_[number] = kUsed;
  --dropped_;
  return number;
}

void NumberFile::drop(std::uint32_t number) {
  if (!used(number)) {
    throw std::invalid_argument("NumberFile: number " + std::to_string(number) +
                                " is dropped but not in use (file of " + std::to_string(size()) + ")");
  }
  (dropped_ == 0 ? next_ : list_[last_]) = number;
  list_[number] = kEnd;
  last_ = number;
  ++dropped_;
  ++available_;
}

}  // namespace tws
