#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include "subscriber_wait.h"

/// Stands before a source that cannot wait itself (rosbag play), under the same name: waits by the options under ~live
/// and ends, with a status other than 0 when it was told to stop.
int main(int argc, char** argv) {
  using namespace tws_runtime;
  bool stopped = false;
  const int status = runProgram(argc, argv, "wait_for_subscribers", [&stopped](RosBus& bus) {
    const LiveOptions options = readLiveOptions(bus.liveParameters(), bus.name() + "/live");
    return [&stopped, &bus, options] {
      waitForSubscribers(bus, options);
      stopped = !bus.ok();
    };
  });
  return stopped ? 1 : status;
}
