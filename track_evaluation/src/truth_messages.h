#pragma once

#include <tws_core/sea_level.h>
#include <tws_msgs/Truth.h>

#include <string>
#include <vector>

#include "epoch.h"

namespace track_evaluation {

/// Which targets a tracker is asked for.
struct TruthFilter {
  double least_detection_probability = 0.8;  ///< In cover: on one scan, by the best radar, 0..1.
  std::vector<std::string> radars;           ///< That make the cover; those that the truth does not know are left out.
                                             ///< None of them known: all radars.
  std::vector<std::uint8_t> required_kinds{tws_msgs::TruthTarget::AIRCRAFT, tws_msgs::TruthTarget::SHIP};
  std::vector<std::uint8_t> tolerated_kinds{tws_msgs::TruthTarget::SLOW_MOVER};  ///< A track of one is not wrong.
  tws::SeaLevel sea;  ///< Under the frame of the truth: gives the targets' heights.
};

/// Why a target cannot be used, e.g. "position.x is nan"; empty: it can.
std::string faultOf(const tws_msgs::TruthTarget& target);

/// The targets that are required (of a required kind, in cover) or tolerated (out of cover, or of a tolerated kind);
/// all others, clutter above all, are none. `site` [m] in the frame of the message: where trackers without height look
/// from.
std::vector<TruthState> truthsOf(const tws_msgs::Truth& message, const Eigen::Vector3d& site,
                                 const TruthFilter& filter);

}  // namespace track_evaluation
