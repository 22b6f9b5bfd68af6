#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/time.h>
#include <tws_runtime/bus.h>
#include <tws_runtime/run.h>
#include <tws_runtime/source.h>

namespace asterix_bridge {

/// The radars of an ASTERIX recording as a source of messages: of each radar /<radar>/detections, /<radar>/plots and
/// /<radar>/sector_marks, and its frame. Parameters: see the README.
class AsterixFileNode : public tws_runtime::Source {
 public:
  /// Throws tws_runtime::ParameterError, and std::runtime_error that names the file when it cannot be read.
  explicit AsterixFileNode(tws_runtime::Bus& bus);
  ~AsterixFileNode() override;

  std::optional<ros::Time> nextTime() const override;
  void step() override;
  std::optional<ros::Time> endTime() const override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The same from the network, as it comes.
class AsterixUdpNode : public tws_runtime::Feed {
 public:
  /// Throws tws_runtime::ParameterError, and std::runtime_error when a port cannot be opened.
  explicit AsterixUdpNode(tws_runtime::Bus& bus);
  ~AsterixUdpNode() override;

  std::optional<ros::Time> poll() override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// What a user wants to know of a recording before it is played.
struct RecordingSummary {
  std::string framing;
  std::vector<std::string> radars;  ///< By their number of reports, the busiest first.
  double length = 0.0;              ///< From the first record to the last [s].
};
/// Throws std::runtime_error that names the file and says why it is no ASTERIX.
RecordingSummary inspectRecording(const std::string& path);

}  // namespace asterix_bridge
