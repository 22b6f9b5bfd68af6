#include "progress_node.h"

#include <tws_runtime/parameters.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "in_words.h"

namespace tws_launch {
namespace {

constexpr double kSilent = 15.0;  // [s of data time]: longer than any tracker lags behind its radars
constexpr double kStands = 4.0;   // [s of wall time]

}  // namespace

ProgressNode::ProgressNode(tws_runtime::Bus& bus, std::ostream& out) : out_(out) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  tws_msgs::GraphDescription description;
  std::vector<std::string> radars, array_radars, range_radars, trackers, correlators;
  reader.texts("radars", radars);
  reader.texts("array_radars", array_radars);
  reader.texts("range_radars", range_radars);
  reader.texts("trackers", trackers);
  reader.texts("correlators", correlators);
  reader.number("length", length_, 0.0, std::numeric_limits<double>::max());
  reader.text("graph", description.yaml);
  reader.done();
  if (!description.yaml.empty()) {
    graph_ = bus.advertise<tws_msgs::GraphDescription>("graph", true);
    graph_.publish(description);
  }
  for (const std::string& radar : radars) listen<tws_msgs::Detections>(bus, radar + "/detections");
  for (const std::string& radar : array_radars) listen<tws_msgs::DwellReports>(bus, radar + "/dwell_reports");
  for (const std::string& radar : range_radars) listen<tws_msgs::RangeProfile>(bus, radar + "/range_profile");
  for (const std::string& tracker : trackers) {
    listen<tws_msgs::Tracks>(bus, tracker + "/tracks");
    listen<tws_msgs::ClutterMap>(bus, tracker + "/clutter_map");
  }
  for (const std::string& correlator : correlators) listen<tws_msgs::CorrelatedTracks>(bus, correlator + "/tracks");
  constexpr double kPeriod = 5.0;
  bus.everyWall(kPeriod, [this] { say(0.0); });
}

void ProgressNode::say(double period) {
  const Clock::time_point now = Clock::now();
  if (summary_.plots() == 0) start_ = now;
  if (summary_.plots() != plots_) last_grown_ = now;
  plots_ = summary_.plots();
  if (summary_.plots() == 0 || now - last_said_ < std::chrono::duration<double>(period)) return;
  last_said_ = now;
  const double stands = std::chrono::duration<double>(now - last_grown_).count();
  out_ << progressLine(summary_, length_, std::chrono::duration<double>(now - start_).count())
       << (stands > kStands ? ", no plot for " + oneDecimal(stands) + " s of wall time" : "") << std::endl;
}

std::string progressLine(const RunSummary& summary, double length, double wall_time) {
  const double done = summary.simulatedTime();
  std::string line = oneDecimal(done);
  if (length > 0.0) line += " of " + oneDecimal(length);
  line += " s simulated";
  if (length > 0.0) line += " (" + std::to_string(std::lround(100.0 * done / length)) + " %)";
  line += ", " + std::to_string(summary.livingTracks()) + " tracks, " +
          std::to_string(std::lround(static_cast<double>(summary.plots()) / wall_time)) + " plots/s";
  if (length > done && done > 0.0)
    line += ", " + std::to_string(std::lround(wall_time * (length - done) / done)) + " s left";
  for (const auto& [name, silence] : summary.silent(kSilent))
    line += ", " + name + " silent for " + oneDecimal(silence) + " s";
  return line;
}

}  // namespace tws_launch
