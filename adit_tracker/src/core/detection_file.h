#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/plot.h>
#include <tws_core/registration.h>
#include "core/passage.h"
#include "core/plot_fates.h"

namespace adit_tracker {

/// A plot that waits in the detection file, and what has become of it.
struct Detection {
  tws::Plot plot;
  bool used = false;               // by a track or the clutter map: it is out of the file (NB is one less)
  bool absorbed = false;           // by the clutter map
  double left = 1.0;               // chance that nothing so far has made it: no track, no clutter point
  double fresh = 1.0;              // chance that it is no stray plot of a track that was missed
  std::uint64_t flagged_in = 0;    // the correlation run in which it proved closer to a track in a secondary sector
  std::uint32_t claim = kNoClaim;  // clutter point on probation that would have taken it
  static constexpr std::uint32_t kNoClaim = 0xffffffff;
  std::uint32_t taker = kNoTaker;  // slot of the track that it was given to, or is flagged for
  static constexpr std::uint32_t kNoTaker = 0xffffffff;
  bool promised = false;  // to a track whose turn it was not yet

  // Of the correlation run in which it was a candidate last: notes of association by chances.
  std::uint64_t asked_in = 0, taken_in = 0;  // ... and in which it was given
  std::uint32_t asked_by = 0, askers = 0;    // the first entry that wants it, and how many do
  std::uint32_t index = kNoIndex;            // in its cluster
  static constexpr std::uint32_t kNoIndex = 0xffffffff;
  double false_density = 0.0;  // of false plots at its place [1/m²] …
  double crowding = 0.0;       // … and twice its logarithm where they are many; else -infinity

  std::vector<PlotClaim> claims;  // only if they are kept (Correlator::keepClaims)

  /// It is out of the file, for tracks or for good.
  void use() {
    used = true;
    left = 0.0;
  }
  /// A track took it when it was its turn.
  bool isTaken() const { return taker != kNoTaker && !promised; }
  /// Rather some track's than a new one's.
  bool isGiven() const { return taker != kNoTaker && (used || left < 0.5); }
};

/// The detections of one sector of one radar, by range.
struct DetectionSector {
  struct Place {
    double range, azimuth;
  };

  std::int64_t running = -1;
  double enter_time = 0.0, leave_time = 0.0;
  std::optional<Passage> ship;        // own ship meanwhile, if the radar is on one
  tws::RegistrationTerms taken{};     // errors of registration that were taken out of the plots
  std::vector<Detection> detections;  // in order of range
  std::vector<Place> places;          // theirs, side by side for the search
  std::vector<std::uint32_t> begins;  // of each range bin, in `places`; as many bins as detections
  double bin = 1.0;                   // width of one [m]
  // All azimuths lie within `spread` of `middle`: by the errors of the radar, some lie outside of the sector.
  double middle = 0.0, spread = 0.0;

  /// To be called when `detections` are there: brings them into order and fills what follows them.
  void index();

  /// Calls `take(detection, range difference, azimuth difference)` for each detection within the half-widths [m, rad]
  /// of a place, used or not. Cost: those within the range; nothing when all are too far away in azimuth.
  template <class Take>
  void within(double range, double azimuth, double range_gate, double azimuth_gate, const Take& take) {
    if (places.empty() || outOfReach(azimuth, azimuth_gate)) return;
    for (auto place = firstFrom(range - range_gate); place != places.end() && place->range <= range + range_gate;
         ++place) {
      const double azimuth_difference = tws::angularDifference(place->azimuth, azimuth);
      if (std::abs(azimuth_difference) > azimuth_gate) continue;
      Detection& detection = detections[static_cast<std::size_t>(place - places.begin())];
      take(detection, place->range - range, azimuth_difference);
    }
  }

  /// The same for those that are still in the file.
  template <class Take>
  void near(double range, double azimuth, double range_gate, double azimuth_gate, const Take& take) {
    within(range, azimuth, range_gate, azimuth_gate, [&](Detection& detection, double by_range, double by_azimuth) {
      if (!detection.used) take(detection, by_range, by_azimuth);
    });
  }

 private:
  std::size_t binOf(double range) const {
    return static_cast<std::size_t>(std::clamp(range / bin, 0.0, static_cast<double>(begins.size() - 1)));
  }

  std::vector<Place>::const_iterator firstFrom(double range) const {
    auto place = places.begin() + begins[binOf(range)];
    while (place != places.end() && place->range < range) ++place;
    return place;
  }

  bool outOfReach(double azimuth, double azimuth_gate) const {
    constexpr double kRounding = 1e-9;
    return std::abs(tws::angularDifference(azimuth, middle)) > spread + azimuth_gate + kRounding;
  }
};

/// The latest sectors of one radar (the report's input data bank: RM, AM, TM, addressed by NP and NB).
class DetectionFile {
 public:
  DetectionFile();

  /// Takes a sector in; running numbers grow. The oldest makes room. Plots must be finite with range > 0.
  DetectionSector& add(const tws::RadarSector& sector);

  /// An empty sector with running -1 when it is not there (never received, or too old).
  DetectionSector& at(std::int64_t running);

  /// The origin of their ranges and azimuths moves [m].
  void moveOrigin(double dx, double dy);

  static constexpr std::int64_t kKept = 128;  // sectors: two scans

 private:
  std::vector<DetectionSector> sectors_;
  DetectionSector empty_;
};

}  // namespace adit_tracker
