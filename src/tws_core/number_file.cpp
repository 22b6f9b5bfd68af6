#include <tws_core/number_file.h>

#include <numeric>
#include <stdexcept>
#include <string>

namespace tws {

NumberFile::NumberFile(std::uint32_t size) : last_(size - 1), available_(size - 1) {
  if (size < 2 || size >= kEnd) {
    throw std::invalid_argument("NumberFile: a file of " + std::to_string(size) +
                                " numbers cannot be kept; at least 2");
  }
  list_.resize(size);
  std::iota(list_.begin(), list_.end(), 1U);
  list_.back() = kEnd;
}

std::optional<std::uint32_t> NumberFile::take() {
  if (available_ == 0) return std::nullopt;
  const std::uint32_t number = next_;
  next_ = list_[number];
  list_[number] = kUsed;
  --available_;
  return number;
}

void NumberFile::drop(std::uint32_t number) {
  if (!used(number)) {
    throw std::invalid_argument("NumberFile: number " + std::to_string(number) +
                                " is dropped but not in use (file of " + std::to_string(size()) + ")");
  }
  list_[last_] = number;
  list_[number] = kEnd;
  last_ = number;
  ++available_;
}

}  // namespace tws
