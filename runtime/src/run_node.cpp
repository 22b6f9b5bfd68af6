#include <ros/ros.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
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

namespace {

constexpr double kPatience = 3.0;  // [s of wall time]

bool isHelp(int argc, char** argv) {
  return std::any_of(argv + std::min(argc, 1), argv + argc,
                     [](const std::string& word) { return word == "--help" || word == "-h"; });
}

void help(const std::string& program) {
  const std::string file = program.substr(program.rfind('/') + 1);
  std::cout
      << file
      << ": a node of ROS 1. It needs a master (roscore, or roslaunch starts one) and has no options of its own:\n  "
      << file << " [_PARAMETER:=VALUE ...] [TOPIC:=OTHER_TOPIC ...] [__name:=NAME] [__ns:=NAMESPACE]\n"
      << "Parameters, topics and services stand in its package's README.md and config; `rosparam load FILE NODE` sets "
         "all of them.\n";
}

/// A node without a master waits for it; says which one, unless done() comes in time.
class MasterWatch {
 public:
  explicit MasterWatch(const std::string& name) : thread_([this, name] { watch(name); }) {}
  ~MasterWatch() { done(); }
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  void done() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      done_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void watch(const std::string& name) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_for(lock, std::chrono::duration<double>(kPatience), [this] { return done_; })) return;
    std::cerr << name << ": waits for the ROS master at " << ros::master::getURI()
              << " (ROS_MASTER_URI); roscore starts one\n"
              << std::flush;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread thread_;  // The last: it uses the others.
};

void runOn(const std::string& name, const Program& program) {
  MasterWatch watch(name);
  RosBus bus{ros::NodeHandle("~")};
  watch.done();
  program(bus)();
}

}  // namespace

int runProgram(int argc, char** argv, const std::string& name, const Program& program) {
  try {
    if (isHelp(argc, argv)) return help(argv[0]), 0;
    ros::init(argc, argv, name);
    runOn(name, program);
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
