// Bags: whatever they hold, each message in them is read, or the complaint says where the file is wrong.
#include <console_bridge/console.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/GraphDescription.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/bag_source.h>
#include <tws_runtime/local_graph.h>

#include <sstream>

#include "bag_check.h"
#include "fuzzing.h"

namespace {

using fuzzing::attempt;
using fuzzing::inputFile;

/// As programs that look into a bag.
template <class... M>
void readAs(const rosbag::MessageInstance& message) try {
  (void)(... || (tws_runtime::messageAs<M>(message) != nullptr));
} catch (const std::runtime_error& error) {
  throw std::runtime_error(inputFile().path() + ": " + error.what());
}

void readAll() {
  rosbag::Bag bag;
  tws_runtime::openBag(bag, inputFile().path());
  for (const rosbag::MessageInstance& message : rosbag::View(bag))
    attempt([&] {
      readAs<tws_msgs::Detections, tws_msgs::SectorMark, tws_msgs::RangeProfile, tws_msgs::Tracks, tf2_msgs::TFMessage,
             tws_msgs::GraphDescription>(message);
    });
}

/// As a graph that is run on a bag.
void replayAll() {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  tws_runtime::Bus& node = graph.addNode("node");
  node.subscribe<tws_msgs::Detections>("/a/detections", [](const tws_msgs::Detections&) {});
  node.subscribe<tws_msgs::SectorMark>("/a/sector_marks", [](const tws_msgs::SectorMark&) {});
  node.subscribe<tws_msgs::Tracks>("/t/tracks", [](const tws_msgs::Tracks&) {});
  tws_runtime::BagSource source(graph, inputFile().path());
  (void)source.endTime();
  while (const auto time = source.nextTime()) {
    attempt([&] {
      graph.advanceTo(*time);
      source.step();
      graph.drain();
    });
  }
}

}  // namespace

void fuzzing::fuzz(std::string_view input) {
  console_bridge::setLogLevel(console_bridge::CONSOLE_BRIDGE_LOG_NONE);
  inputFile().write(input);
  bool is_whole = false;  // A rosbag::Bag, open or not, takes long to be made: it looks for plugins.
  attempt([&] {
    tws_runtime::checkBag(inputFile().path());
    is_whole = true;
  });
  if (!is_whole) return;
  attempt(readAll);
  attempt(replayAll);
}
