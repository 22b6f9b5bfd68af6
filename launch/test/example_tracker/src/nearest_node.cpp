#include <nearest_tracker/nearest_node.h>

#include <tws_core/geometry.h>
#include <tws_core/time_order.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/radar_inputs.h>
#include <tws_runtime/site_gate.h>
#include <tws_runtime/track_writer.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "nearest_tracker.h"

namespace nearest_tracker {
namespace {

constexpr std::size_t kMostWaiting = 1024;                     // sectors that wait for a site
constexpr double kRangeSigma = 100.0, kAzimuthSigma = 0.0052;  // of a plot that does not say it [m], [rad]

struct NodeParams {
  std::vector<std::string> radars{"sps12", "sps39"};
  NearestParams tracker;
};

NodeParams readParams(tws_runtime::Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  reader.texts("radars", params.radars);
  reader.number("gate_sigmas", params.tracker.gate_sigmas, 1.0, 10.0);
  reader.integer("confirm_plots", params.tracker.confirm_plots, 1, 100);
  reader.number("drop_s", params.tracker.drop, 1.0, 1000.0);
  reader.done();
  if (params.radars.empty()) reader.fail("radars", "must not be empty");
  return params;
}

std::vector<tws_runtime::RadarTopics> topicsOf(const std::vector<std::string>& radars) {
  std::vector<tws_runtime::RadarTopics> topics;
  for (const std::string& radar : radars) topics.push_back(tws_runtime::usualTopics(radar));
  return topics;
}

/// Slant ranges are laid on the ground, in the frame of positions.
PlanarPlot planarPlot(const tws::Plot& plot, const tws_runtime::Site& site) {
  const auto known = [](double value, double otherwise) { return value > 0.0 ? value : otherwise; };
  const tws::PlanarMeasurement local = tws::convertedMeasurement(
      plot.range, plot.azimuth, known(plot.range_sigma, kRangeSigma), known(plot.azimuth_sigma, kAzimuthSigma));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(site.turn).toRotationMatrix();
  return {plot.time,
          {turn * local.position + Eigen::Vector2d(site.x, site.y), turn * local.covariance * turn.transpose()}};
}

}  // namespace

class NearestNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : params_(readParams(bus)),
        tracker_(params_.tracker),
        order_(params_.radars.size()),
        gate_(bus, "map", kMostWaiting, params_.radars.size()),
        tracks_(bus, "~tracks", "map"),
        inputs_(
            bus, topicsOf(params_.radars), {},
            [this](std::size_t radar, tws::RadarSector sector) { onSector(radar, std::move(sector)); },
            [this](double) { begin(); }) {}

 private:
  void begin() {
    tracker_ = NearestTracker(params_.tracker);
    order_.reset();
    gate_.clear();
  }

  void onSector(std::size_t radar, tws::RadarSector sector) {
    const auto order = [this, radar](const tws::RadarSector& ready) {
      order_.push(radar, ready.leave_time, ready);
      while (const auto next = order_.pop()) process(next->stream, next->value);
    };
    gate_.add(inputs_.frame(radar), std::move(sector), order, radar);
  }

  void process(std::size_t radar, const tws::RadarSector& sector) {
    const tws_runtime::Site site = gate_.site(radar).value_or(tws_runtime::Site{});
    std::vector<PlanarPlot> plots;
    for (const tws::Plot& plot : sector.plots) plots.push_back(planarPlot(plot, site));
    tws_msgs::Tracks message = tracks_.message(sector.enter_time, params_.radars[radar], sector.running);
    for (const NearestTrack& track : tracker_.process(plots, sector.leave_time))
      message.tracks.push_back(trackMessage(track, params_.radars[radar]));
    tracks_.publish(message);
  }

  tws_msgs::Track trackMessage(const NearestTrack& track, const std::string& radar) const {
    tws_msgs::Track message = tws_runtime::blankTrack(track.number, track.number);
    message.state = track.deleted                 ? tws_msgs::Track::DROPPED
                    : tracker_.isConfirmed(track) ? tws_msgs::Track::FIRM
                                                  : tws_msgs::Track::TENTATIVE;
    message.stamp = tws_runtime::toTime(track.time);
    message.last_update = tws_runtime::toTime(track.last_time);
    message.first_detection = tws_runtime::toTime(track.first_time);
    const Eigen::Vector2d place = track.state.mean.head<2>(), velocity = track.state.mean.tail<2>();
    const tws_runtime::Site first = gate_.site(0).value_or(tws_runtime::Site{});
    const Eigen::Rotation2Dd turn(-first.turn);
    const Eigen::Vector2d local = turn * (place - Eigen::Vector2d(first.x, first.y));
    const Eigen::Vector3d enu(local.x(), local.y(), 0.0);
    const Eigen::Vector2d local_velocity = turn * velocity;
    const tws::PolarRates rates = tws::polarRates(enu, {local_velocity.x(), local_velocity.y(), 0.0});
    tws_runtime::setPolar(message, {local.norm(), tws::azimuthOf(local), rates.range, rates.azimuth});
    tws_runtime::setPlanar(message, place, velocity, tws_runtime::Site{});
    tws_runtime::setPlanarCovariance(message, track.state.covariance, tws_runtime::Site{});
    message.radars.push_back(radar);
    message.radar_updates.push_back(message.last_update);
    return message;
  }

  NodeParams params_;
  NearestTracker tracker_;
  tws::TimeOrder<tws::RadarSector> order_;
  tws_runtime::SiteGate gate_;
  tws_runtime::TrackWriter tracks_;
  tws_runtime::RadarInputs inputs_;
};

NearestNode::NearestNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
NearestNode::~NearestNode() = default;

}  // namespace nearest_tracker
