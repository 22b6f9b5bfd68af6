#include "progress_node.h"

#include <tws_runtime/parameters.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "in_words.h"

namespace tws_launch {

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
  for (const std::string& radar : radars) listen<tws_msgs::Detections>(bus, radar + "/detections", radar);
  for (const std::string& radar : array_radars) listen<tws_msgs::DwellReports>(bus, radar + "/dwell_reports", radar);
  for (const std::string& radar : range_radars) listen<tws_msgs::RangeProfile>(bus, radar + "/range_profile", radar);
  for (const std::string& tracker : trackers) {
    listen<tws_msgs::Tracks>(bus, tracker + "/tracks", "tracker " + tracker);
    bus.subscribe<tws_msgs::ClutterMap>(tracker + "/clutter_map", [this](const auto& map) { summary_.add(map); });
  }
  for (const std::string& correlator : correlators)
    listen<tws_msgs::CorrelatedTracks>(bus, correlator + "/tracks", "correlator " + correlator);
  constexpr double kPeriod = 5.0;
  bus.everyWall(kPeriod, [this] { say(0.0); });
}

void ProgressNode::say(double period) {
  const double now = elapsed(), since = now - last_said_;
  const std::uint64_t plots = summary_.plots();
  const std::string silent = beats_.silent(now);
  if (plots == 0) start_ = now;
  if ((plots == 0 && silent.empty()) || since < period) return;
  last_said_ = now;
  if (plots > 0)
    out_ << progressLine(summary_, length_, now - start_, static_cast<double>(plots - said_plots_) / since);
  else
    out_ << "no plot yet";
  out_ << (silent.empty() ? "" : "; silent: " + silent) << std::endl;
  said_plots_ = plots;
}

std::string progressLine(const RunSummary& summary, double length, double wall_time, double rate) {
  constexpr double kUsualLag = 5.0;  // [s of data time]
  const double done = summary.simulatedTime();
  std::string line = oneDecimal(done);
  if (length > 0.0) line += " of " + oneDecimal(length);
  line += " s simulated";
  if (length > 0.0) line += " (" + std::to_string(std::lround(100.0 * done / length)) + " %)";
  line += ", " + std::to_string(summary.livingTracks()) + " tracks";
  if (summary.livingTracks() > 0 && summary.trackedTime() < done - kUsualLag)
    line += " as of " + oneDecimal(summary.trackedTime()) + " s";
  line += ", " + std::to_string(std::lround(rate)) + " plots/s";
  if (length > done && done > 0.0)
    line += ", " + std::to_string(std::lround(wall_time * (length - done) / done)) + " s left";
  return line;
}

}  // namespace tws_launch
