#include <tws_rviz/ppi_node.h>

#include <tf2/exceptions.h>
#include <tws_core/angles.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/parameters.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "background.h"
#include "marker_layer.h"
#include "ppi_input.h"
#include "ppi_params.h"
#include "status_board.h"

namespace tws_rviz {
namespace {

// A layer of the picture and the topic on which it goes out.
class Screen {
 public:
  Screen(tws_runtime::Bus& bus, const std::string& frame, const std::string& name, double height, bool latched = false)
      : layer_(frame, name, height),
        publisher_(bus.advertise<visualization_msgs::MarkerArray>("/ppi/" + name, latched)) {}
  void show(const Drawing& drawing, ros::Time time) { publisher_.publish(layer_.show(drawing, time)); }

 private:
  MarkerLayer layer_;
  tws_runtime::Publisher<visualization_msgs::MarkerArray> publisher_;
};

struct Radar {
  RadarParams params;
  PlanarFrame site;
  Sweep sweep;
  FadingDetections detections;
  bool heard = false;
};

struct ClutterMark {
  Eigen::Vector2d position;
  bool absorbing;
};

// A whole picture that one message brings, shown until the next one or until it is too old.
template <class T>
struct Snapshot {
  double time = 0.0;
  std::vector<T> items;
};

// Until a radar's rotation period is known [s].
constexpr double kAssumedPeriod = 10.0;
// Data time that goes back by more than this begins a new run [s].
constexpr double kNewRun = 1.0;
// Stamps further ahead of data time than this are refused [s].
constexpr double kFuture = 10.0;

}  // namespace

class PpiNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : bus_(bus),
        params_(loadPpiParams(tws_runtime::ParameterReader(bus.parameters(), bus.name()))),
        style_(params_.picture_range, params_.text_scale),
        spacing_(params_.ring_spacing > 0.0 ? params_.ring_spacing : ringSpacing(params_.picture_range)),
        tracks_(params_.tracks),
        trackers_heard_(params_.trackers.size(), false) {
    for (const RadarParams& radar : params_.radars) radars_.push_back({radar, {}, {}, {}, false});
    subscribeAll();
    background_screen_.show(drawBackground(style_, spacing_), ros::Time());
    bus.everyWall(1.0 / params_.redraw_rate, [this] { whenRunning([this](ros::Time now) { drawFast(now); }); });
    bus.everyWall(1.0 / params_.track_rate, [this] { whenRunning([this](ros::Time now) { drawSlow(now); }); });
  }

 private:
  void subscribeAll() {
    for (std::size_t i = 0; i < radars_.size(); ++i) {
      bus_.subscribe<tws_msgs::SectorMark>(radars_[i].params.sector_marks,
                                           [this, i](const auto& mark) { hearMark(radars_[i], mark); });
      bus_.subscribe<tws_msgs::Detections>(radars_[i].params.detections,
                                           [this, i](const auto& sector) { hearDetections(radars_[i], sector); });
    }
    for (std::size_t i = 0; i < params_.trackers.size(); ++i)
      bus_.subscribe<tws_msgs::Tracks>(params_.trackers[i].topic,
                                       [this, i](const auto& tracks) { hearTracks(i, tracks); });
    if (!params_.clutter_topic.empty())
      bus_.subscribe<tws_msgs::ClutterMap>(params_.clutter_topic, [this](const auto& map) { hearClutter(map); });
    if (params_.truth)
      bus_.subscribe<tws_msgs::Truth>(params_.truth_topic, [this](const auto& truth) { hearTruth(truth); });
  }

  void hearMark(Radar& radar, const tws_msgs::SectorMark& mark) {
    heed("refused sector marks", radar.params.sector_marks, mark.header, [&](const PlanarFrame& site) {
      radar.sweep.mark(beamMark(mark));
      radar.site = site;
      radar.heard = true;
    });
  }

  void hearDetections(Radar& radar, const tws_msgs::Detections& sector) {
    heed("refused detections", radar.params.detections, sector.header, [&](const PlanarFrame& site) {
      for (const tws_msgs::Detection& detection : sector.detections)
        orCount("refused detections", radar.params.detections, sector.header.stamp,
                [&] { radar.detections.add(blip(detection, site), persistence(radar)); });
    });
  }

  void hearTracks(std::size_t source, const tws_msgs::Tracks& tracks) {
    const TrackerParams& tracker = params_.trackers[source];
    heed("refused tracks", tracker.topic, tracks.header, [&](const PlanarFrame& frame) {
      trackers_heard_[source] = true;
      const double heard = tracks.header.stamp.toSec();
      for (const tws_msgs::Track& track : tracks.tracks)
        orCount("refused tracks", tracker.topic, tracks.header.stamp,
                [&] { tracks_.hear(trackReport(track, source, tracker.prefix, heard, frame)); });
    });
  }

  void hearClutter(const tws_msgs::ClutterMap& map) {
    heed("refused clutter points", params_.clutter_topic, map.header, [&](const PlanarFrame& site) {
      clutter_ = {map.header.stamp.toSec(), {}};
      for (const tws_msgs::ClutterPoint& point : map.points)
        orCount("refused clutter points", params_.clutter_topic, map.header.stamp, [&] {
          clutter_.items.push_back({clutterPosition(point, site), point.absorbing != 0});
        });
    });
  }

  void hearTruth(const tws_msgs::Truth& truth) {
    heed("refused truth", params_.truth_topic, truth.header, [&](const PlanarFrame& frame) {
      truth_ = {truth.header.stamp.toSec(), {}};
      for (const tws_msgs::TruthTarget& target : truth.targets)
        orCount("refused truth", params_.truth_topic, truth.header.stamp,
                [&] { truth_.items.push_back(truthPosition(target, frame)); });
    });
  }

  // Calls `use` with the place of the message's frame in the picture; a message that makes no sense is counted.
  template <class Use>
  void heed(const std::string& counter, const std::string& topic, const std_msgs::Header& header, const Use& use) {
    watchTime(bus_.now());
    orCount(counter, topic, header.stamp, [&] {
      if (header.stamp > bus_.now() + ros::Duration(kFuture))
        throw std::invalid_argument("the stamp lies more than 10 s ahead of data time");
      use(frameOf(header.frame_id));
    });
  }

  template <class Action>
  void orCount(const std::string& counter, const std::string& topic, ros::Time stamp, const Action& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      bus_.counter(counter).add(std::string(error.what()) + " in " + topic + " at " + std::to_string(stamp.toSec()));
    }
  }

  PlanarFrame frameOf(const std::string& frame) const {
    if (frame == params_.frame) return {};
    try {
      return planarFrame(bus_.transforms().lookupTransform(params_.frame, frame, ros::Time()).transform);
    } catch (const tf2::TransformException&) {
      throw std::invalid_argument("the frame '" + frame + "' has no transform to '" + params_.frame + "'");
    }
  }

  double persistence(const Radar& radar) const {
    const double period = radar.sweep.rotationPeriod();
    return params_.persistence_scans * (period > 0.0 ? period : kAssumedPeriod);
  }

  // When data time has gone back, another run has begun: what was drawn of the old one goes.
  void watchTime(ros::Time now) {
    if (now + ros::Duration(kNewRun) < latest_) {
      bus_.counter("new runs")
          .add("data time went back from " + std::to_string(latest_.toSec()) + " to " + std::to_string(now.toSec()) +
               ": the picture is cleared");
      for (Radar& radar : radars_) radar = {radar.params, {}, {}, {}, false};
      tracks_ = TrackPicture(params_.tracks);
      clutter_ = {};
      truth_ = {};
    }
    latest_ = now;
  }

  template <class Draw>
  void whenRunning(const Draw& draw) {
    const ros::Time now = bus_.now();
    if (now.isZero()) return;  // No /clock yet.
    watchTime(now);
    draw(now);
  }

  void drawFast(ros::Time now) {
    Drawing sweeps;
    Drawing detections;
    for (const Radar& radar : radars_) {
      if (const auto azimuth = radar.sweep.azimuthAt(now.toSec()))
        addSweep(sweeps, radar.site.origin, *azimuth + radar.site.turn,
                 {radar.params.color, params_.afterglow, style_.range, style_.line});
      radar.detections.draw(detections, now.toSec(), persistence(radar), style_.blip, radar.params.color);
    }
    sweep_screen_.show(sweeps, now);
    detection_screen_.show(detections, now);
  }

  void drawSlow(ros::Time now) {
    tracks_.expire(now.toSec());
    Drawing tracks;
    tracks_.draw(tracks, now.toSec(), style_);
    track_screen_.show(tracks, now);
    clutter_screen_.show(drawClutter(now), now);
    truth_screen_.show(drawTruth(now), now);
    status_screen_.show(drawStatus(style_, status(now)), now);
  }

  template <class T>
  bool isOld(const Snapshot<T>& snapshot, ros::Time now) const {
    return now.toSec() - snapshot.time > params_.tracks.timeout;
  }

  Drawing drawClutter(ros::Time now) const {
    Drawing drawing;
    if (isOld(clutter_, now)) return drawing;
    for (const ClutterMark& mark : clutter_.items)
      addCross(drawing, mark.position, style_.clutter_mark, tws::kPi / 4.0, style_.line,
               faded(style_.clutter, mark.absorbing ? 1.0 : 0.4));
    return drawing;
  }

  Drawing drawTruth(ros::Time now) const {
    Drawing drawing;
    if (isOld(truth_, now)) return drawing;
    for (const Eigen::Vector2d& position : truth_.items)
      addCross(drawing, position, style_.symbol, 0.0, style_.line, style_.truth);
    return drawing;
  }

  PpiStatus status(ros::Time now) const {
    PpiStatus status{now.toSec(), spacing_, {}, {}};
    for (const Radar& radar : radars_)
      if (radar.heard)
        status.radars.push_back({radar.params.name, radar.params.color, radar.sweep.rotationPeriod(),
                                 radar.sweep.azimuthAt(now.toSec()).has_value()});
    for (std::size_t i = 0; i < params_.trackers.size(); ++i)
      if (trackers_heard_[i]) status.trackers.push_back({params_.trackers[i].name, tracks_.counts(i)});
    return status;
  }

  tws_runtime::Bus& bus_;
  const PpiParams params_;
  const PpiStyle style_;
  const double spacing_;  // of the range rings [m]
  std::vector<Radar> radars_;
  TrackPicture tracks_;
  std::vector<bool> trackers_heard_;
  Snapshot<ClutterMark> clutter_;
  Snapshot<Eigen::Vector2d> truth_;
  ros::Time latest_;

  // From the bottom to the top.
  Screen background_screen_{bus_, params_.frame, "background", 0.0, true};
  Screen sweep_screen_{bus_, params_.frame, "sweep", 1.0};
  Screen detection_screen_{bus_, params_.frame, "detections", 2.0};
  Screen clutter_screen_{bus_, params_.frame, "clutter", 3.0};
  Screen truth_screen_{bus_, params_.frame, "truth", 4.0};
  Screen track_screen_{bus_, params_.frame, "tracks", 5.0};
  Screen status_screen_{bus_, params_.frame, "status", 6.0};
};

PpiNode::PpiNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
PpiNode::~PpiNode() = default;

}  // namespace tws_rviz
