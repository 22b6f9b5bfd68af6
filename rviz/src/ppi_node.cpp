#include <tws_rviz/ppi_node.h>

#include <tf2/exceptions.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/RadarMap.h>
#include <tws_msgs/Registration.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>
#include <tws_runtime/moving_frames.h>
#include <tws_runtime/parameters.h>

#include <map>
#include <optional>
#include <stdexcept>

#include "ppi_input.h"
#include "ppi_params.h"
#include "ppi_picture.h"
#include "screen.h"

namespace tws_rviz {
namespace {

using tws_runtime::secondsBetween;

// Data time that goes back by more than this begins a new run [s].
constexpr double kNewRun = 1.0;
// And so do stamps. A tracker that is overloaded lags behind by less.
constexpr double kRestartLimit = 30.0;
// Stamps further ahead of data time than this are refused [s].
constexpr double kFuture = 10.0;

// How long a site's transform may be awaited [s] of data time.
constexpr double kFrameWait = 5.0;
// RViz forgets all markers when it is reset, by hand or by a time that goes back; so the background is sent again [s].
constexpr double kBackgroundPeriod = 2.0;

}  // namespace

class PpiNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : bus_(bus),
        params_(loadPpiParams(tws_runtime::ParameterReader(bus.parameters(), bus.name()))),
        picture_(params_) {
    for (std::size_t i = 0; i < params_.radars.size(); ++i) subscribeRadar(i);
    for (std::size_t i = 0; i < params_.trackers.size(); ++i) subscribeTracker(i);
    for (std::size_t i = 0; i < params_.correlators.size(); ++i)
      intake_.subscribe<tws_msgs::CorrelatedTracks>({params_.correlators[i].topic},
                                                    [this, i](const auto& tracks) { onCorrelator(i, tracks); });
    if (!params_.clutter_topic.empty())
      intake_.subscribe<tws_msgs::ClutterMap>({params_.clutter_topic}, [this](const auto& map) { onClutter(map); });
    if (!params_.maps_topic.empty())
      intake_.subscribe<tws_msgs::RadarMap>({params_.maps_topic}, [this](const auto& map) { onMap(map); });
    if (!params_.registration_topic.empty())
      intake_.subscribe<tws_msgs::Registration>({params_.registration_topic},
                                                [this](const auto& m) { onAlignment(m); });
    if (params_.truth)
      intake_.subscribe<tws_msgs::Truth>({params_.truth_topic}, [this](const auto& truth) { onTruth(truth); });
    drawBackground();
    bus.everyWall(kBackgroundPeriod, [this] { drawBackground(); });
    bus.everyWall(1.0 / params_.redraw_rate, [this] { drawFast(); });
    bus.everyWall(1.0 / params_.track_rate, [this] { drawSlow(); });
  }

 private:
  void subscribeRadar(std::size_t radar) {
    const RadarParams& params = params_.radars[radar];
    intake_.subscribe<tws_msgs::SectorMark>({params.sector_marks}, [this, radar](const auto& m) { onMark(radar, m); });
    intake_.subscribe<tws_msgs::Detections>({params.detections},
                                            [this, radar](const auto& d) { onDetections(radar, d); });
    intake_.subscribe<tws_msgs::SsrPlots>({params.plots}, [this, radar](const auto& p) { onPlots(radar, p); });
  }

  void subscribeTracker(std::size_t tracker) {
    intake_.subscribe<tws_msgs::Tracks>({params_.trackers[tracker].topic},
                                        [this, tracker](const auto& tracks) { onTracks(tracker, tracks); });
  }

  void onMark(std::size_t radar, const tws_msgs::SectorMark& mark) {
    applyInFrame({"sector marks", params_.radars[radar].sector_marks, mark.header},
                 [&](const Origin&, const PlanarFrame& site) { picture_.add(radar, beamMark(mark), site); });
  }

  void onDetections(std::size_t radar, const tws_msgs::Detections& sector) {
    applyInFrame({"detections", params_.radars[radar].detections, sector.header},
                 [&](const Origin& origin, const PlanarFrame& site) {
                   for (const tws_msgs::Detection& detection : sector.detections)
                     applyOrReject(origin, [&] { picture_.add(radar, plotMark(detection, site)); });
                 });
  }

  void onPlots(std::size_t radar, const tws_msgs::SsrPlots& sector) {
    applyInFrame({"plots", params_.radars[radar].plots, sector.header},
                 [&](const Origin& origin, const PlanarFrame& site) {
                   for (const tws_msgs::SsrPlot& plot : sector.plots)
                     applyOrReject(origin, [&] { picture_.add(identityPlot(plot, site)); });
                 });
  }

  void onTracks(std::size_t source, const tws_msgs::Tracks& tracks) {
    const TrackerParams& tracker = params_.trackers[source];
    applyInFrame({"tracks", tracker.topic, tracks.header}, [&](const Origin& origin, const PlanarFrame& frame) {
      const double published = tracks.header.stamp.toSec();
      picture_.setLatest(source, published);
      for (const tws_msgs::Track& track : tracks.tracks)
        applyOrReject(origin, [&] {
          TrackReport report = trackReport(track, source, tracker.prefix, published, frame);
          report.symbol_only = tracker.symbols_only;
          picture_.add(report);
        });
    });
  }

  void onCorrelator(std::size_t correlator, const tws_msgs::CorrelatedTracks& tracks) {
    const std::size_t source = params_.trackers.size() + correlator;
    applyInFrame({"correlated tracks", params_.correlators[correlator].topic, tracks.header},
                 [&](const Origin& origin, const PlanarFrame& frame) {
                   const double published = tracks.header.stamp.toSec();
                   picture_.setLatest(source, published);
                   for (const tws_msgs::CorrelatedTrack& track : tracks.tracks)
                     applyOrReject(origin, [&] { picture_.add(trackReport(track, source, published, frame)); });
                 });
  }

  void onClutter(const tws_msgs::ClutterMap& map) {
    applyInFrame({"clutter points", params_.clutter_topic, map.header},
                 [&](const Origin& origin, const PlanarFrame& site) {
                   std::vector<ClutterMark> marks;
                   for (const tws_msgs::ClutterPoint& point : map.points)
                     applyOrReject(origin, [&] {
                       const PlanarFrame own = picture_.siteOf(point.radar).value_or(site);
                       marks.push_back({clutterPosition(point, own), point.absorbing != 0});
                     });
                   picture_.setClutter(map.header.stamp.toSec(), std::move(marks));
                 });
  }

  void onMap(const tws_msgs::RadarMap& map) {
    applyInFrame({"radar maps", params_.maps_topic, map.header},
                 [&](const Origin&, const PlanarFrame& site) { picture_.setCells(map.radar, radarCells(map, site)); });
  }

  void onAlignment(const tws_msgs::Registration& message) {
    const Origin origin{"registrations", params_.registration_topic, message.header};
    for (const tws_msgs::RadarRegistration& radar : message.radars)
      applyOrReject(origin, [&] { picture_.setAlignment(radar.radar, alignmentText(radar)); });
  }

  void onTruth(const tws_msgs::Truth& truth) {
    applyInFrame({"truth", params_.truth_topic, truth.header}, [&](const Origin& origin, const PlanarFrame& frame) {
      std::vector<Eigen::Vector2d> positions;
      for (const tws_msgs::TruthTarget& target : truth.targets)
        applyOrReject(origin, [&] { positions.push_back(truthPosition(target, frame)); });
      picture_.setTruth(truth.header.stamp.toSec(), std::move(positions));
    });
  }

  // What a message is, for the counters and the log.
  struct Origin {
    std::string kind;
    const std::string& topic;
    const std_msgs::Header& header;
  };

  // Calls `use` with the place of the message's frame in the picture; a message that makes no sense is counted.
  template <class Use>
  void applyInFrame(const Origin& origin, const Use& use) {
    watchTime(bus_.now());
    applyOrReject(origin, [&] {
      // Before the first /clock nothing is known.
      if (!latest_.isZero() && secondsBetween(latest_, origin.header.stamp) > kFuture)
        throw std::invalid_argument("the stamp lies more than 10 s ahead of data time");
      if (const auto place = placeOf(origin.header))
        use(origin, *place);
      else
        missFrame(origin.header);
    });
  }

  template <class Action>
  void applyOrReject(const Origin& origin, const Action& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      bus_.counter("refused " + origin.kind)
          .add(std::string(error.what()) + " in " + origin.topic + " at " +
               std::to_string(origin.header.stamp.toSec()));
    }
  }

  // Nothing: the transform is not there yet.
  std::optional<PlanarFrame> placeOf(const std_msgs::Header& header) const {
    if (header.frame_id == params_.frame) return PlanarFrame();
    try {
      const ros::Time time = frames_.timeFor(params_.frame, header.frame_id, header.stamp);
      return planarFrame(frames_.transforms().lookupTransform(params_.frame, header.frame_id, time).transform);
    } catch (const tf2::TransformException&) {
      return std::nullopt;
    }
  }

  // A site's transform may come a moment after its first messages. Only when it stays away is that a fault.
  void missFrame(const std_msgs::Header& header) {
    const ros::Time since = missing_frames_.try_emplace(header.frame_id, header.stamp).first->second;
    if (secondsBetween(since, header.stamp) > kFrameWait)
      throw std::invalid_argument("the frame '" + header.frame_id + "' has no transform to '" + params_.frame + "'");
    bus_.counter("messages before their site's transform").add();
  }

  // When data time has gone back, another run has begun: what was drawn of the old one goes.
  void watchTime(ros::Time now) {
    if (secondsBetween(now, latest_) > kNewRun) {
      bus_.counter("new runs")
          .add("data time went back from " + std::to_string(latest_.toSec()) + " to " + std::to_string(now.toSec()) +
               ": the picture is cleared");
      clear();
    }
    latest_ = now;
  }

  void clear() {
    picture_ = PpiPicture(params_);
    missing_frames_.clear();
  }

  void drawBackground() {
    background_screen_.show(picture_.background(), ros::Time());
    maps_screen_.show(picture_.maps(), ros::Time());
  }

  void drawFast() {
    watchTime(bus_.now());
    sweep_screen_.show(picture_.sweeps(latest_.toSec()), latest_);
    detection_screen_.show(picture_.detections(latest_.toSec()), latest_);
  }

  void drawSlow() {
    watchTime(bus_.now());
    clutter_screen_.show(picture_.clutter(latest_.toSec()), latest_);
    truth_screen_.show(picture_.truth(latest_.toSec()), latest_);
    const TrackLayers tracks = picture_.tracks(latest_.toSec());
    tentative_screen_.show(tracks.tentative, latest_);
    track_screen_.show(tracks.others, latest_);
    status_screen_.show(picture_.status(latest_.toSec()), latest_);
  }

  tws_runtime::Bus& bus_;
  const PpiParams params_;
  tws_runtime::MovingFrames frames_{bus_};
  PpiPicture picture_;
  tws_runtime::Intake intake_{bus_, kRestartLimit, [this](double) { clear(); }};
  ros::Time latest_;
  std::map<std::string, ros::Time> missing_frames_;  // and when they were first missed

  // From the bottom to the top.
  Screen background_screen_{bus_, params_.frame, "ppi", "background", 0.0, true};
  Screen maps_screen_{bus_, params_.frame, "ppi", "maps", 0.5};
  Screen sweep_screen_{bus_, params_.frame, "ppi", "sweep", 1.0};
  Screen detection_screen_{bus_, params_.frame, "ppi", "detections", 2.0};
  Screen clutter_screen_{bus_, params_.frame, "ppi", "clutter", 3.0};
  Screen truth_screen_{bus_, params_.frame, "ppi", "truth", 4.0};
  Screen tentative_screen_{bus_, params_.frame, "ppi", "tentative", 4.5};
  Screen track_screen_{bus_, params_.frame, "ppi", "tracks", 5.0};
  Screen status_screen_{bus_, params_.frame, "ppi", "status", 6.0};
};

PpiNode::PpiNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
PpiNode::~PpiNode() = default;

}  // namespace tws_rviz
