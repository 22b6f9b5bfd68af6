#include <asterix_bridge/asterix_node.h>

#include <tws_runtime/conversions.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <tws_core/beam_sense.h>

#include "asterix_params.h"
#include "radar_outlet.h"
#include "report_csv.h"

namespace asterix_bridge {

namespace {

std::vector<SourceId> busiestFirst(const Contents& contents) {
  std::vector<SourceId> radars;
  for (const auto& [radar, its] : contents.radars) radars.push_back(radar);
  const auto busier = [&](SourceId a, SourceId b) {
    return contents.radars.at(a).reports > contents.radars.at(b).reports;
  };
  std::stable_sort(radars.begin(), radars.end(), busier);
  return radars;
}

// Those of the list, and the busiest of the others up to a bound, the busiest first; of those that scan to and fro the
// first sweep would look like any other antenna's.
std::vector<SourceId> chosenRadars(const Contents& contents, const RadarFeed::Options& options) {
  std::vector<SourceId> chosen;
  std::size_t others = 0;
  for (const SourceId radar : busiestFirst(contents))
    if (!tws::scansToAndFro(contents.radars.at(radar).first) &&
        (options.listed.count(radar) > 0 || (!options.only_listed && others++ < options.most_radars)))
      chosen.push_back(radar);
  return chosen;
}

}  // namespace

class AsterixFileNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : bus_(bus),
        params_(readFileParams(tws_runtime::ParameterReader(bus.parameters(), bus.name()))),
        recording_(params_.file),
        clock_(clockFor(recording_, params_.date)),
        contents_(contentsOf(recording_, clock_)),
        outlet_(bus, params_),
        radars_(chosenRadars(contents_, params_.feed)),
        feed_(clock_, feedOptions(), events()),
        blocks_(recording_.blocks()) {
    if (contents_.radars.empty()) throw std::runtime_error(params_.file + ": " + whyEmpty(contents_));
    sayWhatScansToAndFro();
    if (radars_.empty() && !problems_.empty())
      throw std::runtime_error(params_.file + ": nothing is left: " + problems());
    if (radars_.empty()) throw std::runtime_error(params_.file + ": none of the parameter's radars is in it");
    openRadars();
    fill();
    if (sectors_.empty()) throw std::runtime_error(params_.file + ": no sector came out: " + problems());
    end_ = std::min(contents_.end, params_.duration > 0.0 ? contents_.start + params_.duration : contents_.end);
  }

  std::optional<ros::Time> nextTime() const {
    const Sectors& sectors = last_of_run_.empty() ? sectors_ : last_of_run_;
    if (sectors.empty() || sectors.begin()->first.first > end_ + kTail) return std::nullopt;
    return tws_runtime::toTime(std::max(sectors.begin()->first.first, clock_time_));
  }

  void step() {
    const bool ends_run = last_of_run_.size() == 1;
    Sectors& sectors = last_of_run_.empty() ? sectors_ : last_of_run_;
    const auto first = sectors.begin();
    const auto [time, radar] = first->first;
    if (time < published_)
      bus_.counter("late sectors")
          .add(outlet_.nameOf(radar) + ": its data come more than lookahead_s later than other radars'");
    published_ = std::max(published_, time);
    clock_time_ = std::max(clock_time_, time);
    outlet_.publish(radar, first->second);
    sectors.erase(first);
    if (ends_run) published_ = 0.0;
    fill();
  }

  ros::Time endTime() const { return tws_runtime::toTime(end_); }

 private:
  using Sectors = std::multimap<std::pair<double, SourceId>, CutSector>;  // by the time at which they close
  static constexpr std::size_t kMostProblems = 8;
  static constexpr double kTail = 1.0;  // the sector of the last report closes after it [s]

  RadarFeed::Options feedOptions() const {
    RadarFeed::Options options = params_.feed;
    options.listed = {radars_.begin(), radars_.end()};
    options.only_listed = true;
    return options;
  }

  void sayWhatScansToAndFro() {
    for (const auto& [radar, its] : contents_.radars)
      if (tws::scansToAndFro(its.first))
        fault("radars that scan to and fro", radarName(radar) + ": " + tws::otherScanOf(its.first));
  }

  /// The busiest first, for it is the main one; then those whose place is known.
  void openRadars() {
    for (const SourceId radar : radars_) outlet_.open(radar);
    const std::set<SourceId> in_order(radars_.begin(), radars_.end());
    for (const SourceId radar : in_order)
      if (const auto& position = contents_.radars.at(radar).position) outlet_.place(radar, *position);
    for (const SourceId radar : in_order) outlet_.placeAtOrigin(radar);
  }

  RadarFeed::Events events() {
    RadarFeed::Events events;
    events.sector = [this](SourceId radar, CutSector&& sector) {
      const double time = sector.leave_time;
      const auto [latest, is_new] = latest_.try_emplace(radar, time);
      if (!is_new && time < latest->second) endRun(radar, time);
      latest->second = time;
      sectors_.emplace(std::pair(time, radar), std::move(sector));
    };
    events.position = [](SourceId, const tws::Geodetic&) {};
    events.fault = [this](const std::string& counter, const std::string& reason) { fault(counter, reason); };
    events.left_out = [this](const std::string& counter) { bus_.counter(counter).add(); };
    return events;
  }

  void fault(const std::string& counter, const std::string& reason) {
    bus_.counter(counter).add(reason);
    if (problems_.size() < kMostProblems) problems_.try_emplace(counter, reason);
  }

  /// The radar begins anew at an earlier time, as of a file that repeats itself: what waits of its old run, and of the
  /// others', goes out before.
  void endRun(SourceId radar, double begins) {
    constexpr double kSurely = 10.0;  // [s]
    for (auto sector = sectors_.begin(); sector != sectors_.end();) {
      const auto next = std::next(sector);
      const auto [time, of] = sector->first;
      const bool is_own = !(of < radar || radar < of);
      if (is_own || time > begins + kSurely) last_of_run_.insert(sectors_.extract(sector));
      sector = next;
    }
  }

  /// The first of each kind, for a file of which nothing comes out.
  std::string problems() const {
    std::string all;
    for (const auto& [counter, reason] : problems_) all += (all.empty() ? "" : "; ") + counter + ": " + reason;
    return all.empty() ? "no report of a target is in it" : all;
  }

  /// Reads on until it is sure that no radar has an earlier sector to come.
  void fill() {
    while (blocks_ && last_of_run_.empty() &&
           (sectors_.empty() || feed_.now() < sectors_.begin()->first.first + params_.lookahead)) {
      if (const auto step = blocks_->next()) {
        feed_.add(*step, params_.file);
      } else {
        feed_.finish();
        blocks_.reset();
      }
    }
  }

  tws_runtime::Bus& bus_;
  const AsterixParams params_;
  const Recording recording_;
  const DataClock clock_;
  const Contents contents_;
  RadarOutlet outlet_;
  const std::vector<SourceId> radars_;
  Sectors sectors_;                    // that wait
  Sectors last_of_run_;                // those before them
  std::map<SourceId, double> latest_;  // of the sectors that were cut [s]
  RadarFeed feed_;
  std::unique_ptr<BlockFinder> blocks_;
  std::map<std::string, std::string> problems_;  // counter, first reason
  double published_ = 0.0;                       // the time of the latest sector of this run that went out,
  double clock_time_ = 0.0;                      // of all
  double end_ = 0.0;
};

AsterixFileNode::AsterixFileNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
AsterixFileNode::~AsterixFileNode() = default;
std::optional<ros::Time> AsterixFileNode::nextTime() const { return impl_->nextTime(); }
void AsterixFileNode::step() { impl_->step(); }
std::optional<ros::Time> AsterixFileNode::endTime() const { return impl_->endTime(); }

RecordingSummary inspectRecording(const std::string& path) {
  const Recording recording(path);
  const Contents contents = contentsOf(recording, clockFor(recording, std::nullopt));
  if (contents.radars.empty()) throw std::runtime_error(path + ": " + whyEmpty(contents));
  RecordingSummary summary;
  summary.framing = toText(recording.framing());
  for (const SourceId radar : busiestFirst(contents)) summary.radars.push_back(radarName(radar));
  if (std::isfinite(contents.start)) summary.length = contents.end - contents.start;
  return summary;
}

}  // namespace asterix_bridge
