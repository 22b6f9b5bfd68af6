#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>
#include <tws_core/plot.h>
#include <tws_msgs/Detection.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SsrPlot.h>

#include <optional>
#include <string>

namespace tws_runtime {

/// Data time in seconds: the double next to it. Below 2^23 s (97 days: simulated time, or time since midnight) toTime()
/// gives back the very nanosecond; for wall time since 1970 a double is good to 0.12 us, in which an aircraft moves
/// less than 0.1 mm.
double toSeconds(ros::Time time);
/// How long after `earlier` `later` is [s]; below 0: before it. A difference of ros::Time throws when one of them is a
/// mad stamp.
double secondsBetween(ros::Time earlier, ros::Time later);
/// The nanosecond next to `seconds`. Throws std::invalid_argument when it is NaN or not in [0, 2^32).
ros::Time toTime(double seconds);

/// Where a radar stands in the frame of positions, and how its east is turned from the x axis, anticlockwise.
struct Site {
  double x = 0.0, y = 0.0, z = 0.0;  ///< [m]
  double turn = 0.0;                 ///< [rad]
};

/// The site of the radar with that frame; nothing: no transform says it (yet), and `why`.
std::optional<Site> findSite(const tf2::BufferCore& transforms, const std::string& frame,
                             const std::string& radar_frame, std::string& why);

/// Why a detection cannot be used, e.g. "azimuth is nan"; empty: it can. Range and azimuth must be in range; what may
/// be unknown may be NaN, and if known must be in range too.
std::string faultOf(const tws_msgs::Detection& detection);

/// The same of a secondary plot of a sector that its beam left at `leave_time` [s]; its codes are not looked at.
std::string faultOf(const tws_msgs::SsrPlot& plot, double leave_time);

/// Both ways; signal-to-noise ratios have 24 bits in the message. toDetection throws as toTime.
tws::Plot toPlot(const tws_msgs::Detection& detection);
tws_msgs::Detection toDetection(const tws::Plot& plot);

/// The message of one sector: stamp, frame and radar in the header, and its plots. Throws as toTime.
tws_msgs::Detections toDetections(const tws::RadarSector& sector, const std::string& radar, const std::string& frame);

}  // namespace tws_runtime
