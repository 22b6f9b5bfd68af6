#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace tws {

/// Hands out numbers 0..size-1, first in, first out: a dropped number is the last to be used again. All operations are
/// O(1). NRL Report 7952, "Track-Number and Clutter-Number Files", which counts from 1. As there, one number always
/// stays in the file, so that at most size-1 are in use at once.
class NumberFile {
 public:
  /// Throws std::invalid_argument unless 2 ≤ size < 2³² - 2.
  explicit NumberFile(std::uint32_t size);

  /// The number that has been unused longest; nothing when all size-1 are in use.
  std::optional<std::uint32_t> take();
  /// Throws std::invalid_argument that names the number when it is not in use.
  void drop(std::uint32_t number);

  /// How many can still be taken (FULLT).
  std::uint32_t available() const { return available_; }
  /// False also for a number outside the file.
  bool used(std::uint32_t number) const { return number < size() && list_[number] == kUsed; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(list_.size()); }

 private:
  static constexpr std::uint32_t kUsed = 0xffffffff;  // the report's 512: larger than any number
  static constexpr std::uint32_t kEnd = 0xfffffffe;

  std::vector<std::uint32_t> list_;  // LISTT: the unused number that follows
  std::uint32_t next_ = 0;           // NEXTT: the next to be handed out
  std::uint32_t last_;               // LASTT: the last to be handed out
  std::uint32_t available_;          // FULLT
};

}  // namespace tws
