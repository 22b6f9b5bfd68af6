#include "secondary_sensor.h"

#include <limits>
#include <optional>

#include <tws_core/plot.h>
#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>

#include "mode_c.h"
#include "rotating_sensor.h"
#include "scenario.h"
#include "secondary_reader.h"
#include "sensor_port.h"

namespace radar_sim {
namespace {

/// Those on whose masts it may turn.
std::vector<RadarParams> primaryRadars(const Scenario& scenario) {
  std::vector<RadarParams> radars;
  for (const auto& sensor : scenario.sensors)
    if (const auto* radar = dynamic_cast<const RotatingSpec*>(sensor.get())) radars.push_back(radar->params);
  return radars;
}

std::uint16_t codeOf(const CodeReading& reading) {
  return reading.code ? *reading.code : std::uint16_t{tws_msgs::SsrPlot::CODE_UNKNOWN};
}

/// Two octal digits, of which the second has two bits.
std::uint16_t mode1Of(const CodeReading& reading) {
  if (!reading.code) return tws_msgs::SsrPlot::CODE_UNKNOWN;
  return static_cast<std::uint16_t>((*reading.code >> 9 & 7) << 3 | (*reading.code >> 6 & 3));
}

double heightOf(const CodeReading& reading) {
  const std::optional<double> height = reading.code ? modeCHeight(*reading.code) : std::nullopt;
  return height.value_or(tws::Plot::kUnknown);
}

tws_msgs::SsrPlot toSsrPlot(const SecondaryPlot& plot) {
  using tws_msgs::SsrPlot;
  const auto reading = [&](Mode mode) { return plot.readings[index(mode)]; };
  const auto bit = [&](Mode mode, int value) { return reading(mode).garbled ? value : 0; };
  SsrPlot message;
  message.stamp = tws_runtime::toTime(plot.time);
  message.range = plot.range;
  message.azimuth = plot.azimuth;
  message.height = heightOf(reading(Mode::kC));
  message.mode_1 = mode1Of(reading(Mode::k1));
  message.mode_2 = codeOf(reading(Mode::k2));
  message.mode_3a = codeOf(reading(Mode::k3A));
  message.garbled =
      static_cast<std::uint8_t>(bit(Mode::k1, SsrPlot::GARBLED_MODE_1) | bit(Mode::k2, SsrPlot::GARBLED_MODE_2) |
                                bit(Mode::k3A, SsrPlot::GARBLED_MODE_3A) | bit(Mode::kC, SsrPlot::GARBLED_MODE_C));
  message.amplitude = std::numeric_limits<float>::quiet_NaN();
  return message;
}

}  // namespace

std::unique_ptr<SensorSpec> readSecondarySensor(ParameterReader& reader, const Scenario& scenario) {
  auto spec = std::make_unique<SecondarySpec>(readSecondaryRadar(reader, primaryRadars(scenario), scenario.start_time));
  settleSite(spec->params.site, scenario, reader);
  return spec;
}

tws_msgs::SsrPlots toSsrPlots(const SecondarySector& sector, const std::string& radar) {
  tws_msgs::SsrPlots message;
  message.header.stamp = tws_runtime::toTime(sector.span.leave_time);
  message.header.frame_id = radar;
  message.radar = radar;
  message.sector = static_cast<std::uint8_t>(sector.span.running % tws::kSectors);
  message.running_sector = static_cast<std::uint32_t>(sector.span.running);
  for (const SecondaryPlot& plot : sector.plots) message.plots.push_back(toSsrPlot(plot));
  return message;
}

std::unique_ptr<Sensor> SecondarySpec::make(const Scene& scene) const {
  return std::make_unique<SecondarySensor>(*this, scene);
}

SecondarySensor::SecondarySensor(const SecondarySpec& spec, const Scene& scene)
    : MastSensor(spec, scene), marks_(*this, scene) {}

void SecondarySensor::connect(SensorPort& port) {
  plots_ = port.advertise<tws_msgs::SsrPlots>("plots");
  marks_.connect(port);
  port.publishFrame(mapToSite());
}

void SecondarySensor::step() {
  const double now = radar().nextMark();
  const SecondarySector sector = radar().closeSector();
  const SectorSpan& span = sector.span;
  plots_.publish(toSsrPlots(sector, name()));
  marks_.publish({span.running, now, span.leave_time, sector.plots.size(), radar().rotationPeriod(span.running + 1)});
}

}  // namespace radar_sim
