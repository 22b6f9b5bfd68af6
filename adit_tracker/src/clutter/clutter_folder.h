#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "clutter/saved_maps.h"

namespace adit_tracker {

/// The one folder in which a tracker keeps clutter maps for whoever calls its services: anybody in the network may, so
/// that what they say is a name within it and never a path. Files are touched by a thread of their own: a disk that
/// does not answer costs the tracker the time limit once, and not its picture.
class ClutterFolder {
 public:
  static constexpr double kTimeLimit = 1.0;  // [s of wall time]
  static constexpr std::size_t kMostFiles = 1000;

  /// Empty: `clutter_maps` in ROS's own folder (~/.ros, or $ROS_HOME). It is made when something is saved.
  explicit ClutterFolder(const std::string& folder);

  /// Throw std::runtime_error with the reason.
  SavedMaps load(const std::string& name, const ClutterLimits& limits);
  void save(const std::string& name, const SavedMaps& maps);

  /// The whole path of a name. Throws std::runtime_error when it is none.
  std::string pathOf(const std::string& name) const;

  /// Does `work` on another thread; what it throws is thrown here. Throws std::runtime_error after kTimeLimit, and at
  /// once while earlier work hangs. It must own all that it uses.
  void within(std::function<void()> work);

 private:
  std::string folder_;
  std::shared_ptr<void> at_work_;  ///< Each thread holds it, too.
};

}  // namespace adit_tracker
