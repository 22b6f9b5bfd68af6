#include "iff_port.h"

#include <tws_runtime/conversions.h>

#include <cmath>

#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

// More than a turn of each of eight radars: their site is known by then, or never.
constexpr std::size_t kMostWaiting = std::size_t{8} * tws::kSectors;

bool isGood(const tws_msgs::SsrPlot& plot) {
  return plot.range > 0.0 && plot.range <= 1e7 && plot.azimuth >= 0.0 && plot.azimuth < tws::kTwoPi;
}

}  // namespace

IffPort::IffPort(tws_runtime::Bus& bus, const std::string& frame, const std::vector<IffParams>& params)
    : bus_(bus), frame_(frame), params_(params) {
  for (std::size_t i = 0; i < params_.size(); ++i)
    bus.subscribe<tws_msgs::SsrPlots>("/" + params_[i].name + "/plots", [this, i](const auto& m) { hear(i, m); });
}

void IffPort::hear(std::size_t iff, const tws_msgs::SsrPlots& message) {
  Waiting heard{iff, message.header.frame_id, {}};
  heard.sector.sector = message.sector % tws::kSectors;
  heard.sector.running = message.running_sector;
  heard.sector.leave_time = tws_runtime::toSeconds(message.header.stamp);
  for (const tws_msgs::SsrPlot& p : message.plots) {
    if (!isGood(p)) {
      bus_.counter("bad IFF plots")
          .add("range is " + std::to_string(p.range) + ", azimuth " + std::to_string(p.azimuth) + " in /" +
               params_[iff].name + "/plots");
      continue;
    }
    tws::Plot& plot = heard.sector.plots.emplace_back();
    plot.time = tws_runtime::toSeconds(p.stamp);
    plot.range = p.range;
    plot.azimuth = p.azimuth;
  }
  waiting_.push_back(std::move(heard));
}

void IffPort::handOver(Adit& adit, const RadarSites& sites) {
  std::deque<Waiting> still;
  for (Waiting& heard : waiting_) {
    std::string why;
    const auto site = tws_runtime::findSite(bus_.transforms(), frame_, heard.frame, why);
    if (!site && waiting_.size() <= kMostWaiting) {
      still.push_back(std::move(heard));
      continue;
    }
    const std::string& name = params_[heard.iff].name;
    if (!site) bus_.counter("unknown sites").add("no transform from " + name + " to " + frame_ + ": " + why);
    const std::string late = "up to " + std::to_string(heard.sector.leave_time) + " s, of " + name;
    const std::size_t plots = heard.sector.plots.size();
    if (adit.hearIff(heard.iff, std::move(heard.sector), site ? sites.onPlane(*site) : SiteFrame{})) continue;
    for (std::size_t i = 0; i < plots; ++i) bus_.counter("late IFF plots").add(late);
  }
  waiting_ = std::move(still);
}

}  // namespace adit_tracker
