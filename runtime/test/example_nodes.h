#pragma once

#include <std_msgs/Header.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/DropTrack.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/source.h>

#include <cstdint>
#include <optional>
#include <string>

namespace tws_runtime {

/// A source as small as can be: 40 messages on /numbers, one each 50 ms of data time from 10 s on, and its site.
class NumbersSource : public Source {
 public:
  explicit NumbersSource(Bus& bus) : publisher_(bus.advertise<tws_msgs::Detections>("/numbers")) {
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "numbers";
    site.transform.translation.x = 1000.0;
    site.transform.rotation.w = 1.0;
    bus.publishStaticTransform(site);
  }

  std::optional<ros::Time> nextTime() const override {
    if (count_ == kCount) return std::nullopt;
    return ros::Time(10, 0) + ros::Duration(0, 50000000 * static_cast<std::int32_t>(count_));
  }

  void step() override {
    tws_msgs::Detections message;
    message.header.stamp = *nextTime();
    message.running_sector = count_++;
    publisher_.publish(message);
  }

  static constexpr std::uint32_t kCount = 40;

 private:
  Publisher<tws_msgs::Detections> publisher_;
  std::uint32_t count_ = 0;
};

/// A node that uses everything a Bus offers: it sends on each number times its parameter `gain` plus what its service
/// has added, ticks twice a second of data time, and counts.
class RelayNode {
 public:
  explicit RelayNode(Bus& bus)
      : bus_(bus),
        out_(bus.advertise<tws_msgs::Detections>("~out")),
        ticks_(bus.advertise<std_msgs::Header>("~ticks")) {
    ParameterReader reader(bus.parameters(), bus.name());
    reader.integer("gain", gain_, 1, 100);
    reader.done();
    bus.subscribe<tws_msgs::Detections>("/numbers", [this](const auto& message) { relay(message); });
    bus.serve<tws_msgs::DropTrack>("~add", [this](auto& request, auto& response) { return add(request, response); });
    bus.everyData(0.5, [this](ros::Time deadline) { tick(deadline); });
  }

 private:
  void relay(const tws_msgs::Detections& message) {
    bus_.counter("numbers").add();
    if (message.running_sector % 10 == 7) bus_.counter("sevens").add(std::to_string(message.running_sector));
    tws_msgs::Detections answer = message;
    answer.running_sector = message.running_sector * static_cast<std::uint32_t>(gain_) + added_;
    answer.radar = bus_.transforms().canTransform("map", "numbers", ros::Time()) ? "placed" : "nowhere";
    out_.publish(answer);
  }

  bool add(tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response) {
    for (const std::uint32_t number : request.numbers) added_ += number;
    response.message = "added " + std::to_string(request.numbers.size());
    return true;
  }

  void tick(ros::Time deadline) {
    std_msgs::Header message;
    message.stamp = deadline;
    ticks_.publish(message);
  }

  Bus& bus_;
  Publisher<tws_msgs::Detections> out_;
  Publisher<std_msgs::Header> ticks_;
  long gain_ = 1;
  std::uint32_t added_ = 0;
};

}  // namespace tws_runtime
