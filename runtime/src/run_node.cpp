#include <ros/ros.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <iostream>
#include <utility>

namespace tws_runtime {

Program nodeProgram(const NodeFactory& makeNode) {
  return [makeNode](RosBus& bus) {
    return [&bus, node = makeNode(bus)] {
      while (bus.ok()) bus.spinInOrder(0.1);
    };
  };
}

Program sourceProgram(const SourceFactory& makeSource) {
  return [makeSource](RosBus& bus) {
    const LiveOptions options = readLiveOptions(bus.liveParameters(), bus.name() + "/live");
    return [&bus, options, source = std::shared_ptr<Source>(makeSource(bus))] { runLive(bus, *source, options); };
  };
}

Program feedProgram(const FeedFactory& makeFeed) {
  return
      [makeFeed](RosBus& bus) { return [&bus, feed = std::shared_ptr<Feed>(makeFeed(bus))] { runFeed(bus, *feed); }; };
}

int runProgram(int argc, char** argv, const std::string& name, const Program& program) {
  try {
    ros::init(argc, argv, name);
    RosBus bus{ros::NodeHandle("~")};
    program(bus)();
    return 0;
  } catch (const ParameterError& error) {
    std::cerr << error.what() << std::endl;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
}

}  // namespace tws_runtime
