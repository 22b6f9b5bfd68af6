#include <ros/ros.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <iostream>

namespace tws_runtime {
namespace {

int runGuarded(int argc, char** argv, const std::string& name, const std::function<void(RosBus&)>& run) {
  try {
    ros::init(argc, argv, name);
    RosBus bus{ros::NodeHandle("~")};
    run(bus);
    return 0;
  } catch (const ParameterError& error) {
    std::cerr << error.what() << std::endl;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
}

}  // namespace

int runNode(int argc, char** argv, const std::string& name, const NodeFactory& makeNode) {
  return runGuarded(argc, argv, name, [&](RosBus& bus) {
    const std::shared_ptr<void> node = makeNode(bus);
    ros::spin();
  });
}

int runSourceNode(int argc, char** argv, const std::string& name, const SourceFactory& makeSource) {
  return runGuarded(argc, argv, name, [&](RosBus& bus) {
    const LiveOptions options = readLiveOptions(bus.liveParameters(), bus.name() + "/live");
    const std::unique_ptr<Source> source = makeSource(bus);
    runLive(bus, *source, options);
  });
}

int runFeedNode(int argc, char** argv, const std::string& name, const FeedFactory& makeFeed) {
  return runGuarded(argc, argv, name, [&](RosBus& bus) {
    const std::unique_ptr<Feed> feed = makeFeed(bus);
    runFeed(bus, *feed);
  });
}

}  // namespace tws_runtime
