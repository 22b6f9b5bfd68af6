#pragma once

#include <string>

namespace tws_runtime {

/// The radar name that the publisher of a topic uses: that of its first message, until three in a row bear another
/// one. So a remapped radar is accepted, one stray message is not, and a stray first one is got over.
class SenderName {
 public:
  /// `expected`: empty when any name will do.
  explicit SenderName(std::string expected) : checked_(!expected.empty()), name_(std::move(expected)) {}

  /// Whether a message of that name comes from the publisher.
  bool accepts(const std::string& name) {
    if (!checked_) return true;
    if (name == name_ || !heard_) {
      heard_ = true;
      name_ = name;
      times_ = 0;
      return true;
    }
    times_ = name == other_ ? times_ + 1 : 1;
    other_ = name;
    if (times_ < kInARow) return false;
    name_ = name;
    times_ = 0;
    return true;
  }

  const std::string& name() const { return name_; }

 private:
  static constexpr int kInARow = 3;

  bool checked_;
  bool heard_ = false;
  std::string name_;
  std::string other_;  // that the latest messages bore,
  int times_ = 0;      // so many in a row
};

}  // namespace tws_runtime
