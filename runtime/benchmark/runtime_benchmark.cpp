// What the Bus costs in one process, and the join of a radar's two topics.
#include <benchmark/benchmark.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/radar_inputs.h>

#include <iostream>
#include <string>
#include <vector>

namespace tws_runtime {
namespace {

/// One sector's message with `plots` detections.
tws_msgs::Detections sectorMessage(std::uint32_t running, std::size_t plots) {
  tws_msgs::Detections message;
  message.header.stamp = ros::Time(0.1 * (running + 1));
  message.radar = "a";
  message.running_sector = running;
  message.sector = static_cast<std::uint8_t>(running % 64);
  message.detections.resize(plots);
  for (tws_msgs::Detection& detection : message.detections) {
    detection.stamp = message.header.stamp;
    detection.range = 50000.0;
    detection.range_sigma = detection.azimuth_sigma = 10.0;
  }
  return message;
}

tws_msgs::SectorMark markMessage(std::uint32_t entered, std::size_t plots) {
  tws_msgs::SectorMark message;
  message.header.stamp = ros::Time(0.1 * entered);
  message.radar = "a";
  message.running_sector = entered;
  message.sector = static_cast<std::uint8_t>(entered % 64);
  message.closed_count = static_cast<std::uint32_t>(plots);
  return message;
}

/// Messages from one node to `range(0)` others; items are deliveries.
void BM_LocalGraphDelivery(benchmark::State& state) {
  LocalGraph graph(std::cerr);
  auto publisher = graph.addNode("sender").advertise<tws_msgs::Detections>("/detections");
  std::uint64_t received = 0;
  for (int i = 0; i < state.range(0); ++i)
    graph.addNode("ear" + std::to_string(i)).subscribe<tws_msgs::Detections>("/detections", [&](const auto&) {
      ++received;
    });
  const auto message = boost::make_shared<const tws_msgs::Detections>(sectorMessage(0, 10));
  for (auto _ : state) {
    publisher.publish(message);
    graph.drain();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(received));
}
BENCHMARK(BM_LocalGraphDelivery)->Arg(1)->Arg(10);

/// The same into a bag; items are messages of 10 detections.
void BM_LocalGraphRecording(benchmark::State& state) {
  LocalGraph graph(std::cerr);
  auto publisher = graph.addNode("sender").advertise<tws_msgs::Detections>("/detections");
  graph.record("/dev/null");
  const auto message = boost::make_shared<const tws_msgs::Detections>(sectorMessage(0, 10));
  for (auto _ : state) {
    publisher.publish(message);
    graph.drain();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(BM_LocalGraphRecording);

/// From two messages on the Bus to a complete sector of `range(0)` plots; items are sectors.
void BM_RadarInputs(benchmark::State& state) {
  const auto plots = static_cast<std::size_t>(state.range(0));
  LocalGraph graph(std::cerr);
  Bus& radar = graph.addNode("a");
  auto detections = radar.advertise<tws_msgs::Detections>("~detections");
  auto marks = radar.advertise<tws_msgs::SectorMark>("~sector_marks");
  std::int64_t sectors = 0;
  const RadarInputs inputs(
      graph.addNode("tracker"), {usualTopics("a")}, RadarInputs::Options(),
      [&](std::size_t, const tws::RadarSector&) { ++sectors; }, [](double) {});
  std::uint32_t running = 0;
  for (auto _ : state) {
    detections.publish(sectorMessage(running, plots));
    marks.publish(markMessage(++running, plots));
    graph.drain();
  }
  state.SetItemsProcessed(sectors);
}
BENCHMARK(BM_RadarInputs)->Arg(0)->Arg(10)->Arg(100);

}  // namespace
}  // namespace tws_runtime

BENCHMARK_MAIN();
