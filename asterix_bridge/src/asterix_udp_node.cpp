#include <asterix_bridge/asterix_node.h>

#include <tws_runtime/conversions.h>

#include <algorithm>
#include <cstdio>

#include "feed_time.h"
#include "radar_outlet.h"
#include "udp_receiver.h"

namespace asterix_bridge {
namespace {

double wallTime() { return ros::WallTime::now().toSec(); }

}  // namespace

class AsterixUdpNode::Impl {
 public:
  explicit Impl(tws_runtime::Bus& bus)
      : bus_(bus),
        params_(readUdpParams(tws_runtime::ParameterReader(bus.parameters(), bus.name()))),
        outlet_(bus, params_),
        feed_(DataClock(wallTime()), params_.feed, events()),
        latency_(params_.feed.sectors.latency) {
    for (const UdpAddress& address : params_.udp) receivers_.emplace_back(address);
    for (const auto& [radar, setting] : params_.radars) outlet_.open(radar);
  }

  std::optional<ros::Time> poll() {
    for (UdpReceiver& receiver : receivers_)
      receiver.receive([this](Bytes datagram, const std::string& sender) { hear(datagram, sender); });
    if (feed_.records() == 0) return std::nullopt;
    const double now = time_.at(wallTime());
    feed_.advance(now);
    return tws_runtime::toTime(now);
  }

 private:
  void hear(Bytes datagram, const std::string& sender) {
    if (!params_.senders.empty() && params_.senders.count(sender.substr(0, sender.rfind(':'))) == 0)
      return bus_.counter("datagrams of other senders").add("from " + sender + "; see parameter senders");
    bus_.counter("datagrams").add();
    const std::uint64_t before = feed_.records();
    for (const FramingStep& step : blocksOfDatagram(datagram)) feed_.add(step, sender);
    if (feed_.records() == before) return;
    const double wall = wallTime();
    time_.add(feed_.now(), wall);
    adaptLatency();
    feed_.advance(time_.at(wall));
  }

  // It grows to what is usual, and stays: sectors that come later and earlier by turns help nobody.
  void adaptLatency() {
    constexpr double kMargin = 0.25, kStep = 0.25;  // [s]
    const double needed = std::min(time_.delay() + kMargin, params_.most_latency);
    if (needed < latency_ + kStep) return;
    latency_ = needed;
    feed_.setLatency(latency_);
    char text[120];
    std::snprintf(text, sizeof text, "data come %.2f s late: sectors are closed %.2f s behind the feed's time",
                  time_.delay(), latency_);
    bus_.counter("latency raised").add(text);
  }

  RadarFeed::Events events() {
    RadarFeed::Events events;
    events.sector = [this](SourceId radar, CutSector&& sector) {
      outlet_.open(radar);
      outlet_.placeWhenLate(radar);
      outlet_.publish(radar, sector);
    };
    events.position = [this](SourceId radar, const tws::Geodetic& position) { outlet_.place(radar, position); };
    events.fault = [this](const std::string& counter, const std::string& reason) { bus_.counter(counter).add(reason); };
    events.left_out = [this](const std::string& counter) { bus_.counter(counter).add(); };
    return events;
  }

  tws_runtime::Bus& bus_;
  const AsterixParams params_;
  RadarOutlet outlet_;
  RadarFeed feed_;
  FeedTime time_;
  double latency_;  // [s]
  std::vector<UdpReceiver> receivers_;
};

AsterixUdpNode::AsterixUdpNode(tws_runtime::Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
AsterixUdpNode::~AsterixUdpNode() = default;
std::optional<ros::Time> AsterixUdpNode::poll() { return impl_->poll(); }

}  // namespace asterix_bridge
