#pragma once

#include <ros/duration.h>
#include <ros/time.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/source.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace tws_runtime {

class LocalGraph;
class RosBus;

/// How runLive paces a source. A source node reads it from its private parameters under `live`, e.g. ~live/rate; of
/// other nodes only `required` means something.
struct LiveOptions {
  double rate = 1.0;  ///< Data time over wall time, >= 0; 0: as fast as possible.
  double duration = std::numeric_limits<double>::infinity();  ///< At most so much data time [s], > 0.
  /// Topics that must have a subscriber before the first step, whichever nodes publish them; named twice: two of them.
  std::vector<std::string> wait_for;
  double wait_timeout = 10.0;    ///< Go on after so much wall time [s], >= 0, with a warning that names the topics.
  double command_timeout = 1.0;  ///< How long a step may wait for the commands by which it goes [s of wall time], >= 0.
  double linger = 2.0;           ///< Wall time after the end [s], >= 0, so that the last messages reach everybody.
  bool required = false;         ///< Of a nodelet: its manager ends with it, as roslaunch does with a required node.
};

/// Reads and checks the keys, which are the members' names. Throws ParameterError.
LiveOptions readLiveOptions(const YAML::Node& tree, const std::string& where);

/// Steps `source` in time with the wall clock and publishes /clock at each step and at least 50 times a second of wall
/// time. Handlers, timers and services of the Bus are called in between. Returns when the source or the duration has
/// ended, or bus.ok() says false.
void runLive(RosBus& bus, Source& source, const LiveOptions& options);

/// Polls `feed` every few milliseconds of wall time and publishes its data time on /clock. Handlers, timers and
/// services of the Bus are called in between. Returns when bus.ok() says false.
void runFeed(RosBus& bus, Feed& feed);

/// Steps the sources of a graph as fast as possible, the one with the earliest next time first (of equal ones the first
/// in the list), and drains the queue after each step. Ends when all have ended, when the next step lies more than
/// `duration` after the first one, or when `continues` (asked before each step) says false.
void runOffline(LocalGraph& graph, const std::vector<Source*>& sources, ros::Duration duration = ros::DURATION_MAX,
                const std::function<bool()>& continues = {});

/// Makes a node on its Bus. The pointer only keeps it alive.
using NodeFactory = std::function<std::shared_ptr<void>(Bus& bus)>;
using SourceFactory = std::function<std::unique_ptr<Source>(Bus& bus)>;
using FeedFactory = std::function<std::unique_ptr<Feed>(Bus& bus)>;

/// Makes a node and returns what runs it: the call serves the Bus and comes back when the node has ended or bus.ok()
/// says false. Throws what the node's constructor throws, e.g. ParameterError.
using Program = std::function<std::function<void()>(RosBus& bus)>;

/// A node that reacts to its input and never ends by itself.
Program nodeProgram(const NodeFactory& makeNode);
/// A source, run by runLive with the options under ~live.
Program sourceProgram(const SourceFactory& makeSource);
/// A feed, run by runFeed.
Program feedProgram(const FeedFactory& makeFeed);

/// The same for a class that is made of its Bus alone.
template <class Node>
Program nodeProgram() {
  return nodeProgram([](Bus& bus) -> std::shared_ptr<void> { return std::make_shared<Node>(bus); });
}
template <class Node>
Program sourceProgram() {
  return sourceProgram([](Bus& bus) { return std::make_unique<Node>(bus); });
}
template <class Node>
Program feedProgram() {
  return feedProgram([](Bus& bus) { return std::make_unique<Node>(bus); });
}

/// The whole of a node's main() (node_main.h writes it): runs the program over roscpp. Returns the exit status: 0, 2
/// after a ParameterError, 1 after any other exception; the reason has gone to the standard error in one line.
int runProgram(int argc, char** argv, const std::string& name, const Program& program);

}  // namespace tws_runtime
