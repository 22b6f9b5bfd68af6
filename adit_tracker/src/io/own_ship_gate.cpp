#include "io/own_ship_gate.h"

#include <tws_runtime/sites.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace adit_tracker {
namespace {

constexpr double kKept = 60.0;  // of own ship's track [s]

/// Anticlockwise from the parent's x axis [rad]. The ship's roll and pitch do not count.
double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

std::string timeText(double time) { return std::to_string(time) + " s"; }

Pose poseOf(const tws_runtime::Site& site) { return {site.x, site.y, -site.turn}; }

}  // namespace

OwnShipGate::OwnShipGate(tws_runtime::Bus& bus, const std::string& frame, const OwnShipParams& params,
                         const std::vector<std::string>& radars, Use use)
    : bus_(bus),
      frame_(frame),
      params_(params),
      radars_(radars),
      use_(std::move(use)),
      mounts_(radars.size()),
      north_(radars.size()) {
  if (isOn()) bus.subscribe<tf2_msgs::TFMessage>("/tf", [this](const auto& message) { onTransforms(message); });
}

void OwnShipGate::onTransforms(const tf2_msgs::TFMessage& message) {
  for (const auto& transform : message.transforms)
    if (transform.child_frame_id == params_.frame) take(transform);
  release();
}

/// Headings are clockwise, of the frame's y axis against north.
void OwnShipGate::take(const geometry_msgs::TransformStamped& transform) {
  const auto& place = transform.transform.translation;
  Pose pose{place.x, place.y, -yawOf(transform.transform.rotation)};
  const std::string& parent = transform.header.frame_id;
  std::string why;
  if (parent != frame_) {
    const auto site = tws_runtime::findSite(bus_.transforms(), frame_, parent, why);
    if (!site) {
      return bus_.counter("refused poses of own ship")
          .add("its frame " + params_.frame + " hangs on " + parent + ", which /tf_static does not hang on " + frame_ +
               ": " + why);
    }
    pose = compose(poseOf(*site), pose);
  }
  const double time = tws_runtime::toSeconds(transform.header.stamp);
  const std::string problem = ship_.add(time, pose);
  if (!problem.empty())
    bus_.counter("refused poses of own ship")
        .add("the pose of " + params_.frame + " at " + timeText(time) + " " + problem);
  ship_.forgetBefore(ship_.latest() - kKept);
}

void OwnShipGate::add(std::size_t radar, const std::string& radar_frame, tws::RadarSector sector) {
  newest_ = std::max(newest_, sector.leave_time);
  waiting_.push_back({radar, radar_frame, std::move(sector)});
  release();
}

void OwnShipGate::beginNewRun(double time) {
  constexpr double kMuch = 5.0;  // [s]
  if (ship_.latest() > time + kMuch) ship_.clear();
  waiting_.clear();
  north_.assign(radars_.size(), {});
  newest_ = -std::numeric_limits<double>::infinity();
}

/// In the order in which they came.
void OwnShipGate::release() {
  while (!waiting_.empty() && findMount(waiting_.front()) && isDue(waiting_.front())) {
    Item item = std::move(waiting_.front());
    waiting_.pop_front();
    handOver(item);
  }
}

bool OwnShipGate::findMount(const Item& item) {
  std::optional<tws_runtime::Site>& mount = mounts_[item.radar];
  if (mount) return true;
  if (item.radar_frame == params_.frame)
    mount.emplace();
  else
    mount = tws_runtime::awaitSite(bus_, params_.frame, item.radar_frame, waiting_.size() <= kMostWaiting);
  return mount.has_value();
}

bool OwnShipGate::isDue(const Item& item) const {
  return ship_.latest() >= item.sector.leave_time || newest_ - item.sector.leave_time > params_.wait;
}

void OwnShipGate::handOver(Item& item) {
  if (ship_.latest() < item.sector.leave_time)
    bus_.counter("late poses of own ship")
        .add("the pose of " + params_.frame + " at " + timeText(item.sector.leave_time) + " did not come within " +
             timeText(params_.wait) + "; the latest is of " + timeText(ship_.latest()));
  const auto ship = passageOf(item.radar, item.sector);
  if (!ship) return lose(item.radar, item.sector);
  for (tws::RadarSector& cut : north_[item.radar].add(item.sector, *ship)) give(item.radar, std::move(cut));
}

std::optional<Passage> OwnShipGate::passageOf(std::size_t radar, const tws::RadarSector& sector) const {
  auto ship = ship_.over(sector.enter_time, sector.leave_time);
  if (!ship) return ship;
  ship->from = compose(ship->from, poseOf(*mounts_[radar]));
  ship->to = compose(ship->to, poseOf(*mounts_[radar]));
  return ship;
}

void OwnShipGate::give(std::size_t radar, tws::RadarSector sector) {
  const auto ship = passageOf(radar, sector);
  if (!ship) return lose(radar, sector);
  use_(radar, std::move(sector), *ship);
}

void OwnShipGate::lose(std::size_t radar, const tws::RadarSector& sector) {
  bus_.counter("plots without own ship's place").add(sector.plots.size());
  bus_.counter("sectors without own ship's place")
      .add(radars_[radar] + ": the sector at " + timeText(sector.enter_time) + " is left out: no pose of " +
           params_.frame + " within " + timeText(OwnShip::kLongestExtrapolation) + " of it; see that it comes on /tf");
}

}  // namespace adit_tracker
