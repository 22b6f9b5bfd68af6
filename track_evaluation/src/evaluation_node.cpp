#include <track_evaluation/evaluation_node.h>

#include <tws_core/geometry.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/EvaluationSummary.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>

#include <cmath>
#include <map>
#include <ostream>

#include "evaluation_params.h"
#include "metrics_file.h"
#include "series_file.h"
#include "tracker_evaluation.h"

namespace track_evaluation {

using tws_runtime::toSeconds;

class EvaluationNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : bus_(bus),
        params_(readEvaluationParams(bus)),
        summary_(bus.advertise<tws_msgs::EvaluationSummary>("~summary", true)),
        timing_(bus.advertise<tws_msgs::EvaluationSummary>("~timing", true)),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    begin();
    listen<tws_msgs::Truth>({"truth", ""});
    for (const std::string& tracker : params_.trackers) listen<tws_msgs::Tracks>({tracker + "/tracks", tracker});
    for (const std::string& correlator : params_.correlators)
      listen<tws_msgs::CorrelatedTracks>({correlator + "/tracks", correlator});
    for (const std::string& radar : params_.radars) listen<tws_msgs::Detections>({radar + "/detections", radar}, radar);
    for (const std::string& radar : params_.secondary_radars)
      listen<tws_msgs::SsrPlots>({radar + "/plots", radar}, radar);
    bus.everyData(params_.period, [this](ros::Time now) { publish(now); });
  }

  void finish() {
    for (auto& [name, tracker] : trackers_) tracker.finish();
  }

  std::size_t epochs() const {
    std::size_t epochs = 0;
    for (const auto& [name, tracker] : trackers_) epochs = std::max(epochs, tracker.epochs());
    return epochs;
  }

  RunScore score() const {
    RunScore score;
    score.settings = settingsOf(params_);
    for (const auto& [name, tracker] : trackers_) {
      TrackerScore its;
      its.tracker = name;
      if (const Evaluator* evaluator = tracker.evaluator()) {
        its.metrics = evaluator->metrics();
        its.requirements = evaluator->requirements();
      }
      if (!tracker.identity.empty()) its.identity = tracker.identity.report();
      if (!tracker.correlation.empty()) its.correlation = tracker.correlation.report();
      its.timing = tracker.timing.report();
      score.trackers.push_back(std::move(its));
    }
    return score;
  }

  std::size_t identified_plots = 0;
  SeriesFile files;

 private:
  struct Input {
    std::string topic;
    std::string name;  // of the tracker, correlator or radar; empty: of the truth
  };

  /// `radar`: the name that the messages should bear; empty: it does not matter.
  template <class M>
  void listen(const Input& input, const std::string& radar = "") {
    intake_.subscribe<M>({input.topic, radar}, [this, input](const M& message) { take(input, message); });
  }

  void begin() {
    trackers_.clear();
    std::vector<std::string> names = params_.trackers;
    names.insert(names.end(), params_.correlators.begin(), params_.correlators.end());
    for (const std::string& name : names) {
      trackers_.try_emplace(
          name, params_, [this](const std::string& radar, const std::string& frame) { return site(radar, frame); },
          [this, name = name](const Epoch& epoch, const Evaluator& evaluator) { files.add(name, epoch, evaluator); },
          [this, name = name](const tws_msgs::Track& track) {
            files.addTrack(name, toSeconds(track.stamp), track.uid, {track.position.x, track.position.y});
          });
    }
    identified_plots = 0;
    newest_ = 0.0;
  }

  void take(const Input& input, const tws_msgs::Truth& message) {
    for (const tws_msgs::TruthTarget& target : message.targets) {
      const std::string fault = faultOf(target);
      if (!fault.empty())
        bus_.counter("bad truth")
            .add("target " + std::to_string(target.id) + " in " + input.topic + " at " +
                 std::to_string(toSeconds(message.header.stamp)) + " s: " + fault);
    }
    for (auto& [name, tracker] : trackers_)
      if (!tracker.add(message)) bus_.counter("late truth").add(input.topic + " came after tracks of later times");
  }

  void take(const Input& input, const tws_msgs::CorrelatedTracks& message) {
    takeTracks(input, message, tracksOf(message));
  }

  void take(const Input& input, const tws_msgs::Tracks& message) { takeTracks(input, message, message); }

  /// `tracks`: those of the message.
  template <class M>
  void takeTracks(const Input& input, const M& published, const tws_msgs::Tracks& message) {
    for (const tws_msgs::Track& track : message.tracks) {
      const std::string fault = faultOf(track);
      if (!fault.empty())
        bus_.counter("bad tracks")
            .add("track " + std::to_string(track.uid) + " in " + input.topic + " at " +
                 std::to_string(toSeconds(message.header.stamp)) + " s: " + fault);
    }
    newest_ = std::max(newest_, toSeconds(message.header.stamp));
    TrackerEvaluation& tracker = trackers_.at(input.name);
    tracker.timing.addTracks(message.radar, toSeconds(bus_.now()), toSeconds(message.header.stamp),
                             message.tracks.size());
    if (!tracker.add(published))
      bus_.counter("late tracks")
          .add(input.topic + " came more than " + std::to_string(params_.skew_limit) + " s after the truth");
  }

  void take(const Input& input, const tws_msgs::Detections& message) {
    for (auto& [name, tracker] : trackers_)
      tracker.timing.addPlots(input.name, toSeconds(bus_.now()), toSeconds(message.header.stamp),
                              message.detections.size());
  }

  void take(const Input& input, const tws_msgs::SsrPlots& message) {
    newest_ = std::max(newest_, toSeconds(message.header.stamp));
    for (const tws_msgs::SsrPlot& plot : message.plots) {
      if (!std::isfinite(plot.range) || !std::isfinite(plot.azimuth)) {
        bus_.counter("bad plots").add(input.topic + ": range or azimuth is no number");
        continue;
      }
      // A code has 12 bits, an address 24: no value of the one is a value of the other in use.
      const std::uint32_t identity = plot.aircraft_address != 0 ? plot.aircraft_address : plot.mode_3a;
      if (identity == tws_msgs::SsrPlot::CODE_UNKNOWN) continue;
      ++identified_plots;
      for (auto& [name, tracker] : trackers_)
        tracker.identity.addPlot(toSeconds(plot.stamp), identity, tws::planarFromPolar(plot.range, plot.azimuth));
    }
  }

  Eigen::Vector3d site(const std::string& radar, const std::string& frame) {
    std::string why;
    if (radar.empty()) return Eigen::Vector3d::Zero();  // No track yet.
    const auto found = tws_runtime::findSite(bus_.transforms(), frame, radar, why);
    if (!found) bus_.counter("unknown sites").add("no transform from " + radar + " to " + frame + ": " + why);
    const tws_runtime::Site at = found.value_or(tws_runtime::Site{});
    return {at.x, at.y, at.z};
  }

  void publish(ros::Time now) {
    constexpr double kLatest = 60.0;  // tracks behind the plots of their time [s]
    for (auto& [name, tracker] : trackers_) tracker.identity.settle(newest_ - kLatest);
    for (const TrackerScore& score : score().trackers) {
      MetricList metrics = score.metrics;
      metrics.insert(metrics.end(), score.identity.begin(), score.identity.end());
      metrics.insert(metrics.end(), score.correlation.begin(), score.correlation.end());
      if (!metrics.empty()) summary_.publish(message(score.tracker, now, metrics));
      timing_.publish(message(score.tracker, now, score.timing));
    }
  }

  tws_msgs::EvaluationSummary message(const std::string& tracker, ros::Time now, const MetricList& metrics) const {
    tws_msgs::EvaluationSummary message;
    message.header.stamp = now;
    message.tracker = tracker;
    for (const auto& [name, value] : metrics) {
      message.names.push_back(name);
      message.values.push_back(value);
    }
    return message;
  }

  tws_runtime::Bus& bus_;
  EvaluationParams params_;
  tws_runtime::Publisher<tws_msgs::EvaluationSummary> summary_, timing_;
  std::map<std::string, TrackerEvaluation> trackers_;
  double newest_ = 0.0;  // stamp of tracks and of plots with identities [s]
  tws_runtime::Intake intake_;
};

EvaluationNode::EvaluationNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
EvaluationNode::~EvaluationNode() = default;

void EvaluationNode::finish() { impl_->finish(); }
std::size_t EvaluationNode::epochs() const { return impl_->epochs(); }
std::size_t EvaluationNode::identifiedPlots() const { return impl_->identified_plots; }

void EvaluationNode::writeJson(std::ostream& out, const std::string& input) const {
  RunScore score = impl_->score();
  score.input = input;
  track_evaluation::writeJson(out, score);
}

void EvaluationNode::writeTable(std::ostream& out) const { track_evaluation::writeTable(out, impl_->score()); }

void EvaluationNode::writeSeries(std::ostream& out) { impl_->files.openSeries(out); }
void EvaluationNode::writePicture(std::ostream& out, double period) { impl_->files.openPicture(out, period); }

}  // namespace track_evaluation
