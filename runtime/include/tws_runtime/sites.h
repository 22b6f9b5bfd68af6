#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include <tf2/buffer_core.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/conversions.h>

namespace tws_runtime {

/// For input that waits for the site transform, so that the output does not depend on when that comes: the site of the
/// radar with that frame in `frame`; nothing: not known yet, wait. When it is enough of waiting (not
/// `patient`), that is counted as an unknown site, and `otherwise` is the answer.
std::optional<Site> awaitSite(Bus& bus, const std::string& frame, const std::string& radar_frame, bool patient,
                              const Site& otherwise = {});

/// What turns places in frame `from` into places in frame `to`; nothing: no transform says it (yet), and `why`.
std::optional<Eigen::Isometry3d> findPose(const tf2::BufferCore& transforms, const std::string& to,
                                          const std::string& from, std::string& why);

}  // namespace tws_runtime
