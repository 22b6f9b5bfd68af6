#pragma once

#include <tws_core/plot.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "sector_pace.h"

namespace tws_runtime {

/// What a radar's message of one sector's detections says. Bad plots are taken out before.
struct SectorDetections {
  std::uint32_t running = 0;   ///< Running number of the sector.
  double leave_time = 0.0;     ///< The beam left it [s].
  std::size_t sent_count = 0;  ///< Plots in the message, bad ones too.
  std::vector<tws::Plot> plots;
};

/// What a radar's sector mark says.
struct SectorCrossing {
  std::uint32_t running = 0;                                          ///< Running number of the sector entered.
  double time = 0.0;                                                  ///< Of the crossing [s].
  std::size_t closed_count = 0;                                       ///< Detections in the sector just left.
  double rotation_period = std::numeric_limits<double>::quiet_NaN();  ///< [s]; NaN: unknown.
};

/// Joins the two streams of one rotating radar into complete sectors, each exactly once and in order. Sector k is
/// complete with its detections and the mark that closes it (running number k + 1).
///
/// Arrival: in any order, as long as what belongs together comes within `limit`. What is then missing is counted and
/// replaced: no detections, or a crossing time from the other stream or in line with its neighbours. Gaps of up to
/// eight turns are filled in this way. The sectors are the same for every order of arrival within the limit.
///
/// A message whose running number does not fit its time is held back; when two others agree with it, the run
/// goes on there, behind a gap. So one damaged message, or a detection and its mark together, does no harm. Stamps that
/// are out of line must not come this far: see Intake.
class SectorJoin {
 public:
  struct Options {
    double limit = 0.5;          ///< Longest wait for what is missing [s of data time], >= 0.
    double restart_limit = 5.0;  ///< Plots stamped further from their sector's time are bad [s], > 0.
  };
  struct Events {
    std::function<void(tws::RadarSector)> sector;
    /// Something was wrong: the counter's name and the reason.
    std::function<void(const std::string& counter, const std::string& reason)> fault;
  };

  SectorJoin(Options options, Events events);

  void add(SectorDetections detections) { addMessage(std::move(detections)); }
  void add(const SectorCrossing& mark) { addMessage(mark); }
  /// Forgets all: a new run begins with the next message.
  void beginNewRun();

 private:
  using Message = std::variant<SectorDetections, SectorCrossing>;

  void reset();
  void addMessage(Message message);
  void holdBack(Message message);
  std::deque<Message> agreeingWith(const Message& message) const;
  void continueWith(const std::deque<Message>& messages);
  bool agree(const Message& a, const Message& b) const;
  Crossing crossingOf(const Message& message) const;

  void store(std::int64_t sector, SectorDetections&& detections);
  void store(std::int64_t entered, const SectorCrossing& mark);
  void refuse(std::set<std::int64_t>& lost, std::int64_t number, const std::string& what);

  bool start();
  bool hasComplete() const;
  std::int64_t earliestPending() const;
  double firstEnterTime() const;
  void continueNumbers();

  void release();
  bool releaseNext(double limit);
  std::optional<double> leaveTime() const;
  void reportLosses(bool has_detections, const SectorCrossing* mark, double leave_time);
  void emit(double leave_time, const SectorDetections* detections);
  void keepTimelyPlots(tws::RadarSector& sector, const std::vector<tws::Plot>& plots);
  std::string sectorText(std::int64_t sector) const;

  Options options_;
  Events events_;
  SectorPace pace_;
  std::deque<Message> strays_;  ///< Held back, oldest first; since the latest one of their kind that fitted.

  bool started_ = false;
  double first_time_ = 0.0;                              ///< Of the run's first message.
  std::int64_t first_ = 0;                               ///< The sector released first,
  std::int64_t next_ = 0;                                ///< the one to release next,
  double enter_time_ = 0.0;                              ///< and when the beam entered it.
  std::map<std::int64_t, SectorDetections> detections_;  ///< By sector; all from next_ on.
  std::map<std::int64_t, SectorCrossing> marks_;         ///< By the sector entered; all after next_.
  std::set<std::int64_t> lost_detections_;               ///< Lately replaced, to tell late messages from duplicates.
  std::set<std::int64_t> lost_marks_;
  std::int64_t number_offset_ = 0;  ///< Running number given out minus the radar's, which may count anew; whole turns.
  std::int64_t last_number_ = std::numeric_limits<std::int64_t>::min();  ///< Given out last.
};

}  // namespace tws_runtime
