#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace tws_runtime {

/// One more subscriber in this process, as long as the object lives. roscpp makes one link to a publisher of all
/// subscribers that a process has on a topic: of nodelets nobody else can say how many listen.
class ProcessSubscription {
 public:
  /// `topic` is absolute.
  explicit ProcessSubscription(const std::string& topic);

  /// How many there are now. May be called from any thread.
  static std::uint32_t count(const std::string& topic);

 private:
  std::shared_ptr<void> entry_;
};

}  // namespace tws_runtime
