#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tws {

/// Hands out numbers 0..size-1, first in, first out: a dropped number is the last to be used again. All operations are
/// O(1). NRL Report 7952, "Track-Number and Clutter-Number Files", which counts from 1. As there, one number always
/// stays in the file, so that at most size-1 are in use at once. Where memory counts, a dropped number rests only until
/// `resting` others have been dropped after it: then numbers stay below the most in use at once and `resting` + 2.
class NumberFile {
 public:
  /// Throws std::invalid_argument unless 2 ≤ size < 2³² - 2.
  explicit NumberFile(std::uint32_t size, std::uint32_t resting = 0xffffffff);

  /// The number that has been unused longest, or rested enough; nothing when all size-1 are in use.
  std::optional<std::uint32_t> take();
  /// Throws std::invalid_argument that names the number when it is not in use.
  void drop(std::uint32_t number);

  /// How many can still be taken (FULLT).
  std::uint32_t available() const { return available_; }
  /// False also for a number outside the file.
  bool used(std::uint32_t number) const { return number < list_.size() && list_[number] == kUsed; }
  std::uint32_t size() const { return size_; }

 private:
  static constexpr std::uint32_t kUsed = 0xffffffff;  // the report's 512: larger than any number
  static constexpr std::uint32_t kEnd = 0xfffffffe;

  bool hasRested() const { return dropped_ > resting_ || (dropped_ > 0 && list_.size() == size_); }

  std::uint32_t size_;
  std::uint32_t resting_;
  std::vector<std::uint32_t> list_;  // LISTT: the unused number that follows; of those that have been handed out once
  std::uint32_t next_ = kEnd;        // NEXTT: the next of the dropped ones
  std::uint32_t last_ = kEnd;        // LASTT: the last of them
  std::uint32_t dropped_ = 0;        // how many they are
  std::uint32_t available_;          // FULLT
};

}  // namespace tws
