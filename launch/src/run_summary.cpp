#include "run_summary.h"

#include <rosbag/view.h>
#include <tws_runtime/bag_file.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "in_words.h"

namespace tws_launch {
namespace {

using tws_runtime::secondsBetween;

using tws_msgs::Track;

constexpr int kColumn = 12;

/// The first word at the left, the others to the right of their columns.
template <class... Words>
void printRow(std::ostream& out, const std::string& first, const Words&... others) {
  out << std::left << std::setw(kColumn) << first << std::right;
  ((out << std::setw(kColumn) << others), ...);
  out << '\n';
}

/// Adds the message to the summary when it is an M; says whether it was.
template <class M>
bool addAs(RunSummary& summary, const rosbag::MessageInstance& instance) {
  const auto message = tws_runtime::messageAs<M>(instance);
  if (message) summary.add(*message);
  return message != nullptr;
}

}  // namespace

RunSummary RunSummary::ofBag(const std::string& path) {
  RunSummary summary;
  rosbag::Bag bag;
  tws_runtime::openBag(bag, path);
  try {
    for (const rosbag::MessageInstance& instance : rosbag::View(bag))
      addAs<tws_msgs::Detections>(summary, instance) || addAs<tws_msgs::DwellReports>(summary, instance) ||
          addAs<tws_msgs::RangeProfile>(summary, instance) || addAs<tws_msgs::Tracks>(summary, instance) ||
          addAs<tws_msgs::CorrelatedTracks>(summary, instance) || addAs<tws_msgs::ClutterMap>(summary, instance) ||
          addAs<diagnostic_msgs::DiagnosticArray>(summary, instance);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  return summary;
}

void RunSummary::add(const tws_msgs::Detections& message) {
  beAlive(message.radar, message.header.stamp);
  Radar& radar = radars_[message.radar];
  ++radar.sectors;
  radar.plots += message.detections.size();
}

void RunSummary::add(const tws_msgs::DwellReports& message) {
  beAlive(message.radar, message.header.stamp);
  Array& array = arrays_[message.radar];
  ++array.periods;
  array.dwells += message.dwells.size();
  for (const tws_msgs::DwellReport& dwell : message.dwells) {
    array.track_dwells += dwell.is_track_dwell ? 1 : 0;
    array.measurements += dwell.measurements.size();
  }
}

void RunSummary::add(const tws_msgs::RangeProfile& message) {
  beAlive(message.radar, message.header.stamp);
  Staring& radar = staring_[message.radar];
  ++radar.profiles;
  radar.bins += message.amplitude.size();
}

void RunSummary::beAlive(const std::string& radar, ros::Time stamp) {
  spoken_[radar] = stamp;
  if (first_.isZero()) first_ = stamp;
  last_ = std::max(last_, stamp);
}

void RunSummary::add(const tws_msgs::Tracks& message) {
  last_tracked_ = std::max(last_tracked_, message.header.stamp);
  Tracker& tracker = trackers_[message.tracker];
  constexpr double kFarBack = 10.0;  // [s]
  const bool new_run = secondsBetween(message.header.stamp, tracker.newest) > kFarBack;
  if (new_run) tracker.census.beginNewRun();
  tracker.newest = new_run ? message.header.stamp : std::max(tracker.newest, message.header.stamp);
  tracker.processed[message.radar] = message.header.stamp;
  for (const Track& track : message.tracks) tracker.census.add(track.uid, track.state);
}

void RunSummary::add(const tws_msgs::CorrelatedTracks& message) {
  if (!correlator_) correlator_ = Correlator{};
  for (const tws_msgs::CorrelatedTrack& track : message.tracks) {
    correlator_->census.add(track.identity, track.track.state);
    correlator_->kind[track.identity] = track.kind;
    if (track.track.state == Track::DROPPED) correlator_->kind.erase(track.identity);
  }
}

void RunSummary::add(const tws_msgs::ClutterMap& message) {
  trackers_[message.tracker].clutter_points = message.points.size();
}

void RunSummary::add(const diagnostic_msgs::DiagnosticArray& message) {
  for (const auto& status : message.status) {
    for (const auto& value : status.values) {
      std::uint64_t count = 0;
      if (std::istringstream(value.value) >> count) counters_[status.hardware_id][value.key] = count;
    }
  }
}

double RunSummary::simulatedTime() const { return secondsBetween(first_, last_); }

double RunSummary::trackedTime() const { return std::max(0.0, secondsBetween(first_, last_tracked_)); }

std::string RunSummary::sensorNames() const {
  std::vector<std::string> names;
  const auto add = [&](const auto& sensors) {
    for (const auto& sensor : sensors) names.push_back(sensor.first);
  };
  add(radars_);
  add(arrays_);
  add(staring_);
  return joined(names, ", ");
}

std::size_t RunSummary::begunTracks() const {
  std::size_t begun = 0;
  for (const auto& [name, tracker] : trackers_) begun += tracker.census.begun();
  return begun;
}

bool RunSummary::hasConfirmed() const {
  return (correlator_ && correlator_->census.begun() > 0) ||
         std::any_of(trackers_.begin(), trackers_.end(), [](const auto& t) { return t.second.census.everFirm() > 0; });
}

std::string RunSummary::silence() const {
  constexpr double kSilent = 60.0;  // [s of data time] More than a tracker lags behind, also one that is overloaded.
  for (const auto& [name, tracker] : trackers_) {
    for (const auto& [radar, stamp] : tracker.processed) {
      const auto spoken = spoken_.find(radar);
      if (spoken == spoken_.end() || secondsBetween(stamp, spoken->second) < kSilent) continue;
      return "tracker " + name + " fell silent at " + oneDecimal(secondsBetween(first_, stamp)) + " s, while " + radar +
             " spoke until " + oneDecimal(secondsBetween(first_, spoken->second)) +
             " s: its tracks end there; its log says why, if it says anything";
    }
  }
  return "";
}

std::string RunSummary::failure() const {
  constexpr double kLongEnough = 60.0;  // [s] In less, tracks may have begun and not be confirmed yet.
  const std::size_t begun = begunTracks();
  if (hasConfirmed() || (begun > 0 && simulatedTime() < kLongEnough)) return silence();
  const std::string sensors = sensorNames();
  if (sensors.empty())
    return "nothing was tracked: no radar's plots came out of the input; `tws_inspect FILE` says what is understood of "
           "it";
  std::string text = "nothing was tracked: " + std::to_string(plots()) + " plots of " + sensors + " in " +
                     oneDecimal(simulatedTime()) + " s";
  if (plots() == 0) return text + "; are the radars' messages empty, or their names others than the graph's?";
  text += begun == 0 ? ", of which no track began"
                     : ", of which " + std::to_string(begun) + " tracks began, none confirmed";
  return text + "; a track needs an aircraft in some scans: run longer, or check the radars' rotation, times and sites";
}

std::uint64_t RunSummary::plots() const {
  std::uint64_t plots = 0;
  for (const auto& [name, radar] : radars_) plots += radar.plots;
  for (const auto& [name, array] : arrays_) plots += array.measurements;
  for (const auto& [name, radar] : staring_) plots += radar.profiles;
  return plots;
}

std::size_t RunSummary::livingTracks() const {
  if (correlator_) return correlator_->census.living();
  std::size_t living = 0;
  for (const auto& [name, tracker] : trackers_) living += tracker.census.living();
  return living;
}

void RunSummary::print(std::ostream& out, const std::vector<tws_runtime::CounterReading>& counters,
                       std::optional<double> wall_time) const {
  out << "simulated time " << oneDecimal(simulatedTime()) << " s";
  if (wall_time) out << ", wall time " << oneDecimal(*wall_time) << " s";
  out << '\n';
  if (!radars_.empty() || (arrays_.empty() && staring_.empty())) printRadars(out);
  if (!arrays_.empty()) printArrays(out);
  if (!staring_.empty()) printStaring(out);
  printTrackers(out);
  printCorrelator(out);
  std::vector<tws_runtime::CounterReading> counted;
  std::copy_if(counters.begin(), counters.end(), std::back_inserter(counted),
               [](const auto& c) { return c.value > 0; });
  if (!counted.empty()) tws_runtime::printCounters(out, counted);
}

void RunSummary::printRadars(std::ostream& out) const {
  printRow(out, "radar", "sectors", "plots", "plots/s");
  for (const auto& [name, radar] : radars_) {
    const double time = simulatedTime();
    printRow(out, name, radar.sectors, radar.plots,
             time > 0.0 ? oneDecimal(static_cast<double>(radar.plots) / time) : "-");
  }
}

void RunSummary::printArrays(std::ostream& out) const {
  printRow(out, "array", "periods", "dwells", "on tracks", "measured", "measured/s");
  for (const auto& [name, array] : arrays_) {
    const double time = simulatedTime();
    printRow(out, name, array.periods, array.dwells, array.track_dwells, array.measurements,
             time > 0.0 ? oneDecimal(static_cast<double>(array.measurements) / time) : "-");
  }
}

void RunSummary::printStaring(std::ostream& out) const {
  printRow(out, "range radar", "profiles", "bins");
  for (const auto& [name, radar] : staring_) printRow(out, name, radar.profiles, radar.bins);
}

void RunSummary::printTrackers(std::ostream& out) const {
  printRow(out, "tracker", "started", "firmed", "dropped", "at the end:", "firm", "coasting", "tentative", "clutter");
  for (const auto& [name, tracker] : trackers_)
    printRow(out, name, tracker.census.begun(), tracker.census.everFirm(), tracker.census.ended(), "",
             tracker.census.count(Track::FIRM), tracker.census.count(Track::COASTING),
             tracker.census.count(Track::TENTATIVE), tracker.clutter_points);
}

void RunSummary::printCorrelator(std::ostream& out) const {
  if (!correlator_) return;
  const auto of = [&](std::uint8_t kind) {
    return std::count_if(correlator_->kind.begin(), correlator_->kind.end(),
                         [&](const auto& entry) { return entry.second == kind; });
  };
  using tws_msgs::CorrelatedTrack;
  printRow(out, "correlator", "identities", "ended", "at the end:", "correlated", "primary", "secondary");
  printRow(out, "correlated", correlator_->census.begun(), correlator_->census.ended(), "",
           of(CorrelatedTrack::CORRELATED), of(CorrelatedTrack::PRIMARY_ONLY), of(CorrelatedTrack::SECONDARY_ONLY));
}

std::vector<tws_runtime::CounterReading> RunSummary::counters() const {
  std::vector<tws_runtime::CounterReading> readings;
  for (const auto& [node, counters] : counters_)
    for (const auto& [name, value] : counters) readings.push_back({node, name, value, false});
  return readings;
}

}  // namespace tws_launch
