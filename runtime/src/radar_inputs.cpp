#include <tws_runtime/radar_inputs.h>

#include <tws_core/sectors.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/conversions.h>

#include <utility>

#include "radar_joins.h"

namespace tws_runtime {
namespace {

SectorCrossing crossingOf(const tws_msgs::SectorMark& mark) {
  return {mark.running_sector, toSeconds(mark.header.stamp), mark.closed_count, mark.rotation_period};
}

}  // namespace

RadarTopics usualTopics(const std::string& radar) { return {radar, radar + "/detections", radar + "/sector_marks"}; }

class RadarInputs::Impl {
 public:
  Impl(Bus& bus, const std::vector<RadarTopics>& radars, Options options, OnSector on_sector, OnNewRun on_new_run)
      : bus_(bus),
        radars_(radars),
        frames_(radars.size()),
        joins_(radars.size(), {options.wait_limit, options.restart_limit},
               events(std::move(on_sector), std::move(on_new_run))) {
    for (std::size_t radar = 0; radar < radars.size(); ++radar) {
      bus.subscribe<tws_msgs::Detections>(radars[radar].detections,
                                          [this, radar](const auto& message) { hear(radar, message); });
      bus.subscribe<tws_msgs::SectorMark>(radars[radar].sector_marks,
                                          [this, radar](const auto& message) { hear(radar, message); });
    }
  }

  const std::string& frame(std::size_t radar) const { return frames_.at(radar); }

 private:
  RadarJoins::Events events(OnSector on_sector, OnNewRun on_new_run) {
    RadarJoins::Events events;
    events.sector = [this, on_sector = std::move(on_sector)](std::size_t radar, tws::RadarSector sector) {
      bus_.counter("sectors").add();
      bus_.counter("detections").add(sector.plots.size());
      on_sector(radar, std::move(sector));
    };
    events.new_run = [this, on_new_run = std::move(on_new_run)](double time) {
      bus_.counter("new runs").add("time has gone back to " + std::to_string(time) + " s");
      on_new_run(time);
    };
    events.fault = [this](std::size_t radar, const std::string& counter, const std::string& reason) {
      bus_.counter(counter).add(radars_[radar].radar + ": " + reason);
    };
    return events;
  }

  void hear(std::size_t radar, const tws_msgs::Detections& message) {
    if (!isGood(radar, radars_[radar].detections, message)) return;
    SectorDetections detections;
    detections.running = message.running_sector;
    detections.leave_time = toSeconds(message.header.stamp);
    detections.sent_count = message.detections.size();
    for (const tws_msgs::Detection& detection : message.detections) {
      const std::string fault = faultOf(detection);
      if (fault.empty())
        detections.plots.push_back(toPlot(detection));
      else
        bus_.counter("bad detections")
            .add(fault + " in " + radars_[radar].detections + " at " + std::to_string(detection.stamp.toSec()) + " s");
    }
    joins_.add(radar, std::move(detections));
  }

  void hear(std::size_t radar, const tws_msgs::SectorMark& message) {
    if (isGood(radar, radars_[radar].sector_marks, message)) joins_.add(radar, crossingOf(message));
  }

  /// The message comes from this radar, and its sector and running number agree.
  template <class M>
  bool isGood(std::size_t radar, const std::string& topic, const M& message) {
    std::string fault;
    if (message.radar != radars_[radar].radar)
      fault = "radar '" + message.radar + "', expected '" + radars_[radar].radar + "'";
    else if (message.sector != message.running_sector % tws::kSectors)
      fault =
          "sector " + std::to_string(message.sector) + " with running number " + std::to_string(message.running_sector);
    if (!fault.empty())
      bus_.counter("bad messages")
          .add(fault + " in " + topic + " at " + std::to_string(message.header.stamp.toSec()) + " s");
    else
      frames_[radar] = message.header.frame_id;
    return fault.empty();
  }

  Bus& bus_;
  std::vector<RadarTopics> radars_;
  std::vector<std::string> frames_;
  RadarJoins joins_;
};

RadarInputs::RadarInputs(Bus& bus, const std::vector<RadarTopics>& radars, Options options, OnSector on_sector,
                         OnNewRun on_new_run)
    : impl_(std::make_unique<Impl>(bus, radars, options, std::move(on_sector), std::move(on_new_run))) {}
RadarInputs::~RadarInputs() = default;

const std::string& RadarInputs::frame(std::size_t radar) const { return impl_->frame(radar); }

}  // namespace tws_runtime
