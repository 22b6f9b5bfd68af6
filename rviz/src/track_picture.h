#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "ppi_style.h"

namespace tws_rviz {

enum class TrackState { kTentative, kFirm, kCoasting, kDropped };

/// Which radars see the aircraft.
enum class TrackKind { kPrimary, kSecondary, kCorrelated };

/// A track update.
struct TrackReport {
  std::size_t source = 0;  // which tracker
  std::uint32_t uid = 0;   // never used twice by one tracker
  TrackState state = TrackState::kTentative;
  TrackKind kind = TrackKind::kPrimary;
  double published = 0.0;    // data time of the message [s]
  double time = 0.0;         // at which position and velocity hold [s]
  Eigen::Vector2d position;  // [m]
  Eigen::Vector2d velocity =
      Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());  // [m/s]; NaN: unknown
  bool handed_off = false;                                                  // to a tracking radar
  bool designated = false;                                                  // for elevation searches
  bool iff = false;                                                         // it answers interrogations
  std::string name;          // what the operator calls it, e.g. its number
  std::string identity;      // e.g. "4271 F350"; empty: unknown, or as it was
  bool symbol_only = false;  // a triangle without leader, trail and label: a tracker beside the main one
};

/// How tracks are drawn.
struct TrackLook {
  double leader_time = 60.0;  // the speed leader is as long as the track flies in this time [s]
  double trail_time = 120.0;  // age of the oldest dot of a trail [s]
  double timeout = 30.0;      // a track without an update for so long vanishes [s]
};

/// What a picture of tracks is drawn on: tentative tracks can be hidden without the others.
struct TrackLayers {
  Drawing tentative, others;

  Drawing& of(const TrackReport& report) { return report.state == TrackState::kTentative ? tentative : others; }
};

/// All living tracks, of any number of trackers: symbol (a circle, with a dot in it when a secondary radar sees the
/// aircraft too, a triangle when only that does; squares coast), speed leader, trail and label. A track shows where it
/// was last reported; it is not moved on in between, so that it stays on its plots. Where tentative tracks crowd, in
/// rain or over a town, each is a dot: their numbers and leaders would hide what is below.
class TrackPicture {
 public:
  explicit TrackPicture(const TrackLook& look) : look_(look) {}

  /// Keeps the update; a dropped track is removed.
  void add(const TrackReport& report);
  /// Removes the tracks without an update for the time-out.
  void expire(double time);

  /// Appends trails, leaders, symbols and labels. Dots of trails fade with their age at `time` [s]. Remembers where the
  /// labels stand, so that they stay there.
  /// Of the `covered` sources only what was never firm is drawn: the rest is seen under another source.
  void draw(TrackLayers& layers, double time, const PpiStyle& style, const std::set<std::size_t>& covered = {});

  /// How many tracks of a tracker are tentative, firm and coasting, in this order.
  std::array<int, 3> counts(std::size_t source) const;

 private:
  struct TrailDot {
    double time;
    Eigen::Vector2d position;
  };
  struct LivingTrack {
    TrackReport report;
    std::deque<TrailDot> trail;  // oldest first, without the present place
    std::uint32_t label = 0;
    std::optional<int> side;  // of the label
    bool confirmed = false;   // it was firm or coasting at least once
    bool crowded = false;     // tentative, among many others that are
  };
  void leaveTrail(LivingTrack& track, double time) const;
  void drawTrail(Drawing& drawing, const LivingTrack& track, double time, const PpiStyle& style) const;
  static void findCrowds(const std::vector<LivingTrack*>& shown, const PpiStyle& style);
  void drawSymbol(Drawing& drawing, const TrackReport& report, const PpiStyle& style) const;
  static void drawLabels(TrackLayers& layers, const std::vector<LivingTrack*>& shown, const PpiStyle& style);

  TrackLook look_;
  std::map<std::pair<std::size_t, std::uint32_t>, LivingTrack> tracks_;  // by source and uid
  std::uint32_t next_label_ = 0;
};

}  // namespace tws_rviz
