#include <tws_rviz/sine_space_node.h>

#include <tws_core/sine_space.h>
#include <tws_msgs/DwellReports.h>
#include <tws_msgs/Frame.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/sites.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <optional>

#include "screen.h"
#include "sine_space_picture.h"

namespace tws_rviz {
namespace {

using tws_runtime::secondsBetween;
using tws_runtime::toSeconds;

// The frame of the markers: the plane of sine space is nowhere in the world.
constexpr const char* kFrame = "sine_space";
// Data time that goes back by more than this begins a new run [s].
constexpr double kNewRun = 1.0;
// And so do stamps. A tracker that is overloaded lags behind by less.
constexpr double kRestartLimit = 30.0;
constexpr double kBackgroundPeriod = 2.0;  // RViz forgets all markers when it is reset [s of wall time].

struct Params {
  std::string radar = "esa";
  double half_width = 0.55, low = -0.27, high = 0.03;  // of the picture, in u and v
  double persistence = 3.0;                            // [s]
  double redraw_rate = 10.0;                           // [Hz of wall time]
};

Params readParams(tws_runtime::Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  Params params;
  reader.text("radar", params.radar);
  reader.number("half_width", params.half_width, 0.05, 1.0);
  reader.number("low", params.low, -1.0, 1.0);
  reader.number("high", params.high, -1.0, 1.0);
  if (params.high <= params.low) reader.fail("high", "is not greater than low");
  reader.number("persistence", params.persistence, 0.1, 60.0);
  reader.number("redraw_rate", params.redraw_rate, 1.0, 60.0);
  reader.done();
  return params;
}

bool isGood(double value) { return std::isfinite(value); }

DwellMark dwellMark(const tws_msgs::DwellReport& dwell) {
  DwellMark mark;
  mark.time = toSeconds(dwell.stamp);
  mark.number = dwell.dwell;
  mark.on_track = dwell.is_track_dwell != 0;
  mark.u = dwell.u;
  mark.v = dwell.v;
  mark.beamwidth_u = dwell.beamwidth_u;
  mark.beamwidth_v = dwell.beamwidth_v;
  mark.group = dwell.group;
  mark.group_dwells = dwell.expected_group_dwells;
  for (const tws_msgs::RuvMeasurement& m : dwell.measurements)
    if (isGood(m.u) && isGood(m.v)) mark.measurements.push_back({m.range, m.u, m.v});
  return mark;
}

bool isGood(const tws_msgs::DwellReport& dwell) {
  return isGood(dwell.u) && isGood(dwell.v) && isGood(dwell.beamwidth_u) && isGood(dwell.beamwidth_v);
}

}  // namespace

class SineSpaceNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus) : bus_(bus), params_(readParams(bus)), picture_(makePicture()) {
    const std::string& topic = params_.radar;
    intake_.subscribe<tws_msgs::DwellReports>({topic + "/dwell_reports", params_.radar},
                                              [this](const auto& message) { onDwells(message); });
    tws_runtime::IntakeTopic<tws_msgs::Frame> frames{topic + "/frames", params_.radar};
    frames.stamp = [](const tws_msgs::Frame& message) { return message.through; };
    intake_.subscribe<tws_msgs::Frame>(frames, [this](const auto& message) { onFrame(message); });
    intake_.subscribe<tws_msgs::Tracks>({topic + "/tracks"}, [this](const auto& message) { onTracks(message); });
    drawBackground();
    bus.everyWall(kBackgroundPeriod, [this] { drawBackground(); });
    bus.everyWall(1.0 / params_.redraw_rate, [this] { draw(); });
  }

 private:
  SineSpacePicture makePicture() const { return {params_.half_width, params_.low, params_.high, params_.persistence}; }

  void onDwells(const tws_msgs::DwellReports& message) {
    watchTime();
    array_frame_ = message.header.frame_id;
    for (const tws_msgs::DwellReport& dwell : message.dwells) {
      if (isGood(dwell))
        picture_.add(dwellMark(dwell));
      else
        bus_.counter("refused dwells").add("dwell " + std::to_string(dwell.dwell) + ": beam is no number");
    }
  }

  void onFrame(const tws_msgs::Frame& message) {
    if (message.status != tws_msgs::Frame::CLOSED) return;
    FrameMark frame{toSeconds(message.through), message.frame, {}};
    for (const tws_msgs::DwellReport& dwell : message.dwells)
      if (isGood(dwell)) frame.dwells.push_back(dwellMark(dwell));
    picture_.add(frame);
  }

  void onTracks(const tws_msgs::Tracks& message) {
    for (const tws_msgs::Track& track : message.tracks) {
      if (track.state == tws_msgs::Track::DROPPED)
        tracks_.erase(track.uid);
      else
        tracks_[track.uid] = track;
    }
    const auto from_map = arrayFrom(message.header.frame_id);
    if (!from_map) return;
    std::vector<SineSpaceTrack> shown;
    for (const auto& [uid, track] : tracks_) {
      const double age = secondsBetween(track.stamp, message.header.stamp);
      const Eigen::Vector3d place(track.position.x + age * track.velocity.x, track.position.y + age * track.velocity.y,
                                  track.position.z + age * track.velocity.z);
      const tws::Ruv ruv = tws::ruvFromArray(*from_map * place);
      if (isGood(ruv.u) && isGood(ruv.v))
        shown.push_back({track.number, track.state != tws_msgs::Track::TENTATIVE, ruv.u, ruv.v});
    }
    picture_.setTracks(std::move(shown));
  }

  std::optional<Eigen::Isometry3d> arrayFrom(const std::string& frame) const {
    std::string why;  // The transform comes with the radar's first messages.
    return tws_runtime::findPose(bus_.transforms(), array_frame_, frame, why);
  }

  void watchTime() {
    const ros::Time now = bus_.now();
    if (secondsBetween(now, latest_) > kNewRun) {
      bus_.counter("new runs").add("data time went back: the picture is cleared");
      clear();
    }
    latest_ = now;
  }

  void drawBackground() { background_screen_.show(picture_.background(), ros::Time()); }

  void clear() {
    picture_ = makePicture();
    tracks_.clear();
  }

  void draw() {
    watchTime();
    const double time = latest_.toSec();
    beam_screen_.show(picture_.beams(time), latest_);
    measurement_screen_.show(picture_.measurements(time), latest_);
    track_screen_.show(picture_.tracks(), latest_);
    status_screen_.show(picture_.status(), latest_);
  }

  tws_runtime::Bus& bus_;
  const Params params_;
  SineSpacePicture picture_;
  std::map<std::uint32_t, tws_msgs::Track> tracks_;  // the latest update of each, by uid
  std::string array_frame_ = params_.radar;
  ros::Time latest_;
  tws_runtime::Intake intake_{bus_, kRestartLimit, [this](double) { clear(); }};

  // From the bottom to the top.
  Screen background_screen_{bus_, kFrame, "sine_space", "background", 0.0, true};
  Screen beam_screen_{bus_, kFrame, "sine_space", "beams", 1.0};
  Screen measurement_screen_{bus_, kFrame, "sine_space", "blips", 2.0};
  Screen track_screen_{bus_, kFrame, "sine_space", "tracks", 3.0};
  Screen status_screen_{bus_, kFrame, "sine_space", "status", 4.0};
};

SineSpaceNode::SineSpaceNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
SineSpaceNode::~SineSpaceNode() = default;

}  // namespace tws_rviz
