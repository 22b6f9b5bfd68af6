#pragma once

#include <tws_msgs/LoadClutterMap.h>
#include <tws_msgs/SaveClutterMap.h>
#include <tws_runtime/bus.h>

#include <functional>
#include <string>

#include "clutter/clutter_folder.h"
#include "clutter/saved_maps.h"
#include "operator/operator_interface.h"

namespace adit_tracker {

/// As parameters name them: what is loaded at the start of each run (empty: nothing), and where services save and load
/// (empty: see ClutterFolder).
struct ClutterFiles {
  std::string at_start, folder;
};

/// Saves and loads clutter maps, and with them what was learned of the radars: services, and the file that a run starts
/// with. Loading goes through the operator's port, so that a replay repeats it, without the file.
class ClutterInterface {
 public:
  /// `adit`: the tracker as it is; nullptr: it has not processed a sector yet. Throws tws_runtime::ParameterError when
  /// it cannot be used.
  ClutterInterface(tws_runtime::Bus& bus, OperatorInterface& operators, const AditParams& params,
                   const ClutterFiles& files, std::function<const Adit*()> adit);

  /// A new run has begun.
  void beginRun();

 private:
  using Message = OperatorInterface::Message;

  bool save(const tws_msgs::SaveClutterMap::Request& request, tws_msgs::SaveClutterMap::Response& response);
  Message loadMessage(const SavedMaps& maps) const;
  bool load(const tws_msgs::LoadClutterMap::Request& request, tws_msgs::LoadClutterMap::Response& response);

  OperatorInterface& operators_;
  ClutterLimits limits_;
  ClutterFolder folder_;
  std::function<const Adit*()> adit_;
  SavedMaps at_start_;
};

}  // namespace adit_tracker
