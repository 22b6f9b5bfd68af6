#include <tws_runtime/radar_inputs.h>

#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/intake.h>

#include <utility>

#include "sector_join.h"

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
        on_sector_(std::move(on_sector)),
        on_new_run_(std::move(on_new_run)),
        intake_(
            bus, options.restart_limit, [this](double time) { beginNewRun(time); }, options.skew_limit) {
    joins_.reserve(radars.size());
    for (std::size_t radar = 0; radar < radars.size(); ++radar) {
      joins_.emplace_back(SectorJoin::Options{options.wait_limit, options.restart_limit}, eventsOf(radar));
      subscribe<tws_msgs::Detections>(radar, radars[radar].detections);
      subscribe<tws_msgs::SectorMark>(radar, radars[radar].sector_marks);
    }
  }

  const std::string& frame(std::size_t radar) const { return frames_.at(radar); }
  Intake& intake() { return intake_; }

 private:
  template <class M>
  void subscribe(std::size_t radar, const std::string& topic) {
    intake_.subscribe<M>({topic, radars_[radar].radar, StampOrder::kAny, sectorFault<M>},
                         [this, radar](const M& message) {
                           frames_[radar] = message.header.frame_id;
                           add(radar, message);
                         });
  }

  SectorJoin::Events eventsOf(std::size_t radar) {
    return {[this, radar](tws::RadarSector sector) {
              bus_.counter("sectors").add();
              bus_.counter("detections").add(sector.plots.size());
              on_sector_(radar, std::move(sector));
            },
            [this, radar](const std::string& counter, const std::string& reason) {
              bus_.counter(counter).add(radars_[radar].radar + ": " + reason);
            }};
  }

  void beginNewRun(double time) {
    for (SectorJoin& join : joins_) join.beginNewRun();
    on_new_run_(time);
  }

  void add(std::size_t radar, const tws_msgs::Detections& message) {
    SectorDetections detections;
    detections.running = message.running_sector;
    detections.leave_time = toSeconds(message.header.stamp);
    detections.sent_count = message.detections.size();
    for (const tws_msgs::Detection& detection : message.detections) {
      const std::string fault = faultOf(detection);
      if (fault.empty())
        detections.plots.push_back(toPlot(detection));
      else
        bus_.counter("bad detections").add(fault + whereText(radars_[radar].detections, detection.stamp));
    }
    joins_[radar].add(std::move(detections));
  }

  void add(std::size_t radar, const tws_msgs::SectorMark& message) { joins_[radar].add(crossingOf(message)); }

  Bus& bus_;
  std::vector<RadarTopics> radars_;
  std::vector<std::string> frames_;
  OnSector on_sector_;
  OnNewRun on_new_run_;
  std::vector<SectorJoin> joins_;
  Intake intake_;
};

RadarInputs::RadarInputs(Bus& bus, const std::vector<RadarTopics>& radars, Options options, OnSector on_sector,
                         OnNewRun on_new_run)
    : impl_(std::make_unique<Impl>(bus, radars, options, std::move(on_sector), std::move(on_new_run))) {}
RadarInputs::~RadarInputs() = default;

const std::string& RadarInputs::frame(std::size_t radar) const { return impl_->frame(radar); }
Intake& RadarInputs::intake() { return impl_->intake(); }

}  // namespace tws_runtime
