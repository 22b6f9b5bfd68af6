#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/adit.h"

namespace adit_tracker {

/// What an operator may ask (IOPER 1 to 8, and more). The numbers are those of tws_msgs/OperatorRequest.
enum class OperatorAction : std::uint8_t {
  kHandOff = 1,
  kListAzimuth = 2,
  kListRange = 3,
  kParameters = 4,
  kListAll = 5,
  kListTentative = 6,
  kListClosing = 7,
  kListElevation = 8,
  kDesignate = 20,
  kInitiate = 21,
  kDrop = 22,
  kDropAll = 23,
  kLoadClutter = 24
};

struct OperatorRequest {
  static constexpr double kUnused = std::numeric_limits<double>::quiet_NaN();

  OperatorAction action = OperatorAction::kListAll;
  std::uint32_t track = 0;              // number, where one is named
  bool cancel = false;                  // a handoff or a designation
  double from = kUnused, to = kUnused;  // azimuths clockwise [rad]; ranges, inside `to` and outside `from` [m]; least
                                        // closing speed `from` [m/s]
  std::uint32_t start = 0;              // of a list: least number
  double x = kUnused, y = kUnused;      // point, east and north of the radars [m]
  SavedMaps maps;                       // to be loaded
};

struct OperatorAnswer {
  std::string refusal;                  // why not; empty: it was done
  std::uint32_t count = 0;              // tracks that fulfil the request (NUM); points loaded
  std::uint32_t next = 0;               // least number of the next page; 0: there is none (ISTART)
  std::vector<TrackFile::Slot> tracks;  // a page of them, by number (JTAR)
};

/// Carries a request out between two sectors (the report's ALPNM). Tracks are looked at as of the sector processed
/// last. Lists of targets hold the tracks that are no longer tentative. A track that has been dropped stays valid in
/// the answer until the next sector.
OperatorAnswer execute(Adit& adit, const OperatorRequest& request);

}  // namespace adit_tracker
