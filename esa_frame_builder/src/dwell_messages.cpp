#include "dwell_messages.h"

#include <algorithm>
#include <cmath>

#include <tws_core/sine_space.h>
#include <tws_runtime/conversions.h>

namespace esa_frame_builder {
namespace {

using Covariance = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

std::string say(const std::string& what, double value) { return what + " is " + std::to_string(value); }

// The first of the dwell's numbers that is not finite.
std::string nanOf(const tws_msgs::DwellReport& dwell) {
  const std::pair<const char*, double> numbers[] = {
      {"u", dwell.u},
      {"v", dwell.v},
      {"beamwidth_u", dwell.beamwidth_u},
      {"beamwidth_v", dwell.beamwidth_v},
      {"range_min", dwell.range_min},
      {"range_max", dwell.range_max},
  };
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value)) return say(name, value);
  return "";
}

std::string badCovariance(const Eigen::Map<const Covariance>& covariance) {
  if (!covariance.allFinite()) return "a covariance is not finite";
  if (!(covariance.diagonal().array() > 0.0).all()) return "a variance is not positive";
  return "";
}

}  // namespace

DwellFault faultOf(const tws_msgs::DwellReport& dwell, double earliest, double latest) {
  const std::string name = "dwell " + std::to_string(dwell.dwell) + ": ";
  const double time = tws_runtime::toSeconds(dwell.stamp);
  const std::string nan = nanOf(dwell);
  if (!nan.empty()) return {"dwells with NaN", name + nan};
  if (!tws::isVisible(dwell.u, dwell.v))
    return {"dwells outside the visible region", name + say("u", dwell.u) + ", " + say("v", dwell.v)};
  if (!(dwell.beamwidth_u > 0.0 && dwell.beamwidth_v > 0.0))
    return {"dwells without a beamwidth",
            name + say("beamwidth_u", dwell.beamwidth_u) + ", " + say("beamwidth_v", dwell.beamwidth_v)};
  if (!(dwell.range_min >= 0.0 && dwell.range_max >= dwell.range_min))
    return {"dwells with a bad receive window",
            name + say("range_min", dwell.range_min) + ", " + say("range_max", dwell.range_max)};
  if (time < earliest)
    return {"dwells back in time", name + say("stamp", time) + ", the dwell before it " + say("", earliest)};
  if (time > latest)
    return {"dwells after their period", name + say("stamp", time) + ", its period's end" + say("", latest)};
  return {};
}

std::string faultOf(const tws_msgs::RuvMeasurement& measurement) {
  if (!(measurement.range > 0.0 && measurement.range < 1e8)) return say("range", measurement.range);
  if (!tws::isVisible(measurement.u, measurement.v)) return say("u", measurement.u) + ", " + say("v", measurement.v);
  if (!(measurement.snr >= 0.0 && std::isfinite(measurement.snr))) return say("snr", measurement.snr);
  return badCovariance(Eigen::Map<const Covariance>(measurement.covariance.data()));
}

Dwell toDwell(const tws_msgs::DwellReport& message, std::vector<std::string>& faults) {
  Dwell dwell;
  dwell.time = tws_runtime::toSeconds(message.stamp);
  dwell.number = message.dwell;
  dwell.is_track_dwell = message.is_track_dwell != 0;
  dwell.group_indices = message.dwell_group_indices;
  std::sort(dwell.group_indices.begin(), dwell.group_indices.end());
  dwell.group = message.group;
  dwell.expected_group_dwells = message.expected_group_dwells;
  dwell.u = message.u;
  dwell.v = message.v;
  dwell.beamwidth_u = message.beamwidth_u;
  dwell.beamwidth_v = message.beamwidth_v;
  dwell.range_min = message.range_min;
  dwell.range_max = message.range_max;
  dwell.measurements.reserve(message.measurements.size());
  for (const tws_msgs::RuvMeasurement& m : message.measurements) {
    const std::string fault = faultOf(m);
    if (!fault.empty())
      faults.push_back("dwell " + std::to_string(message.dwell) + ": a measurement's " + fault);
    else
      dwell.measurements.push_back(
          {m.range, m.u, m.v, Eigen::Map<const Covariance>(m.covariance.data()), m.snr, m.rcs});
  }
  return dwell;
}

tws_msgs::DwellReport toMessage(const Dwell& dwell) {
  tws_msgs::DwellReport message;
  message.stamp = tws_runtime::toTime(dwell.time);
  message.dwell = dwell.number;
  message.is_track_dwell = dwell.is_track_dwell;
  message.dwell_group_indices = dwell.group_indices;
  message.group = dwell.group;
  message.expected_group_dwells = dwell.expected_group_dwells;
  message.u = dwell.u;
  message.v = dwell.v;
  message.beamwidth_u = dwell.beamwidth_u;
  message.beamwidth_v = dwell.beamwidth_v;
  message.range_min = dwell.range_min;
  message.range_max = dwell.range_max;
  message.measurements.reserve(dwell.measurements.size());
  for (const Measurement& measurement : dwell.measurements) {
    tws_msgs::RuvMeasurement& m = message.measurements.emplace_back();
    m.range = measurement.range;
    m.u = measurement.u;
    m.v = measurement.v;
    Eigen::Map<Covariance>(m.covariance.data()) = measurement.covariance;
    m.snr = measurement.snr;
    m.rcs = measurement.rcs;
  }
  return message;
}

tws_msgs::Frame toMessage(const Frame& frame) {
  tws_msgs::Frame message;
  message.frame = frame.number;
  message.status = frame.closed ? tws_msgs::Frame::CLOSED : tws_msgs::Frame::PARTIAL;
  for (const Dwell& dwell : frame.dwells) message.dwells.push_back(toMessage(dwell));
  message.discarded = static_cast<std::uint32_t>(frame.discarded);
  return message;
}

Frame toFrame(const tws_msgs::Frame& message, std::vector<std::string>& faults) {
  Frame frame;
  frame.number = message.frame;
  frame.closed = message.status == tws_msgs::Frame::CLOSED;
  for (const tws_msgs::DwellReport& dwell : message.dwells) frame.dwells.push_back(toDwell(dwell, faults));
  frame.discarded = message.discarded;
  return frame;
}

}  // namespace esa_frame_builder
