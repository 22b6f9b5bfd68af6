#include "process_subscriptions.h"

#include <map>
#include <mutex>

namespace tws_runtime {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::string, std::uint32_t> counts;
};

/// Never destroyed: nodelets may go later than static objects.
Registry& registry() {
  static auto* const the_one = new Registry;
  return *the_one;
}

void add(const std::string& topic, int n) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  registry().counts[topic] += n;
}

}  // namespace

ProcessSubscription::ProcessSubscription(const std::string& topic) {
  add(topic, 1);
  entry_ = std::shared_ptr<void>(nullptr, [topic](void*) { add(topic, -1); });
}

std::uint32_t ProcessSubscription::count(const std::string& topic) {
  const std::lock_guard<std::mutex> lock(registry().mutex);
  const auto found = registry().counts.find(topic);
  return found == registry().counts.end() ? 0 : found->second;
}

}  // namespace tws_runtime
