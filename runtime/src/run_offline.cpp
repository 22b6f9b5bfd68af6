#include <tws_runtime/local_graph.h>
#include <tws_runtime/run.h>

#include <cstdint>
#include <optional>

namespace tws_runtime {
namespace {

/// Whether a source has gone on for longer than `duration`. One bad stamp may lie further off than a ros::Duration can
/// say; the longest of them means all.
bool isBeyond(ros::Time time, ros::Time start, ros::Duration duration) {
  return duration < ros::DURATION_MAX && time > start &&
         time.toNSec() - start.toNSec() > static_cast<std::uint64_t>(duration.toNSec());
}

/// The source to step next and when; null: all have ended.
struct Next {
  Source* source = nullptr;
  ros::Time time;
};

Next earliest(const std::vector<Source*>& sources) {
  Next next;
  for (Source* source : sources) {
    const std::optional<ros::Time> time = source->nextTime();
    if (time && (!next.source || *time < next.time)) next = {source, *time};
  }
  return next;
}

}  // namespace

void runOffline(LocalGraph& graph, const std::vector<Source*>& sources, ros::Duration duration,
                const std::function<bool()>& continues) {
  const ros::Time start = earliest(sources).time;
  for (Next next = earliest(sources); next.source; next = earliest(sources)) {
    if (isBeyond(next.time, start, duration)) break;
    if (continues && !continues()) break;
    graph.advanceTo(next.time);
    next.source->step();
    graph.drain();
  }
}

}  // namespace tws_runtime
