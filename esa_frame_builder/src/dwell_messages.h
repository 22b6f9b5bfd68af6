#pragma once

#include <tws_msgs/DwellReport.h>
#include <tws_msgs/Frame.h>

#include <string>
#include <vector>

#include "frame.h"

namespace esa_frame_builder {

/// Why a dwell cannot be used: the counter's name ("dwells with NaN") and what is wrong ("dwell 17: u is nan"). Both
/// empty: it can.
struct DwellFault {
  std::string counter;
  std::string reason;
};

/// Checks all of a dwell but its measurements. `earliest`: time of the dwell before it; `latest`: end of its period
/// [s].
DwellFault faultOf(const tws_msgs::DwellReport& dwell, double earliest, double latest);
/// Why a measurement cannot be used; empty: it can.
std::string faultOf(const tws_msgs::RuvMeasurement& measurement);

/// Both ways. Measurements that cannot be used are left out and named in `faults`.
Dwell toDwell(const tws_msgs::DwellReport& message, std::vector<std::string>& faults);
tws_msgs::DwellReport toMessage(const Dwell& dwell);

/// Dwells and counts; the sender fills in header, radar and `through`.
tws_msgs::Frame toMessage(const Frame& frame);
Frame toFrame(const tws_msgs::Frame& message, std::vector<std::string>& faults);

}  // namespace esa_frame_builder
