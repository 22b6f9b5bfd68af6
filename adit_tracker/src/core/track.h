#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include <tws_core/alpha_beta.h>

#include <tws_core/multiple_model_filter.h>
#include "core/rate_prediction.h"
#include "core/reference_place.h"
#include "elevation/height_guess.h"

namespace adit_tracker {

constexpr std::size_t kMaxRadars = 8;
// After so many detections a track has settled: only then does it tell of its radar's errors, or is a partner of
// others.
constexpr std::int32_t kSettledUpdates = 6;

/// The report's filter: range and azimuth apart.
struct PolarFilter {
  tws::AlphaBetaState range;    // RS, VRS, P1R, P2R
  tws::AlphaBetaState azimuth;  // AS, VAS, P1A, P2A
};

/// Position and velocity at one instant, in both coordinates. Without height, slant range is laid on the plane.
struct Kinematics {
  double time = 0.0;
  double range = 0.0, azimuth = 0.0;            // RS, AS [m], [rad]
  double range_rate = 0.0, azimuth_rate = 0.0;  // VRS, VAS [m/s], [rad/s]
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;  // x east, y north [m], [m/s]
};

/// Where a track will be when a beam meets it next.
struct Prediction {
  double time = 0.0;
  double range = 0.0, azimuth = 0.0;  // RPT, APT
  std::uint32_t radar = 0;            // whose beam
  bool vague_height = false;          // a good deal of `innovation` comes of the unknown height
  float cover = 1.0F;                 // by how much the radar sees worse there: share of a track's own chance
  // Of the innovation in range and cross-range [m²], the radar's own errors included. Statistical gates only.
  tws::Symmetric2 innovation;
  double manoeuvre = 0.0;   // variance that a hard manoeuvre adds to each axis of it [m²]
  double log_volume = 0.0;  // ln(determinant of `innovation` / that of the radar's errors), ≥ 0
};

/// The place of the first detections, if they came from something that does not move: for telling clutter from targets.
struct FixedPlace {
  double x = 0.0, y = 0.0;
  tws::Symmetric2 covariance;
  double moving_evidence = 0.0;  // log-likelihood of movement minus that of this place
};

// Share of its usual chance of detection with which a track is seen where the radar sees hardly anything.
constexpr float kCoverWhereBlind = 0.1F;

/// What the correlator looks at, of many tracks and little of each, stands first.
struct alignas(64) Track {
  Prediction predicted;
  std::array<double, kMaxRadars> illuminated;  // unwrapped azimuth at which each beam met it last, detected or not
  std::uint32_t number = 0;                    // NT
  std::uint32_t uid = 0;                       // never used twice in a run
  bool coasting = false;                       // not detected when a beam met it last
  bool firm = false;                           // the opposite of bit 15 of OUT
  bool handed_off = false;                     // to a tracking radar: bit 5 of OUT
  bool designated = false;                     // for elevation searches: bit 6 of OUT
  std::uint8_t answers_iff = 0;                // secondary radars, one bit each, that detect it: bit 4 of OUT
  std::uint16_t volume = 0;                    // by whose parameters it goes: AditParams::in
  std::uint16_t detected_by = 0;   // radars that detected it when they last had the chance: bits 1..3 of OUT
  std::int32_t updates = 0;        // detections used
  Kinematics smoothed;             // at the latest update
  double first_time = 0.0;         // TF
  double last_update = 0.0;        // TT
  double last_illumination = 0.0;  // by any radar, detected or not
  double apart = 0.0;              // the latest detection that it had for itself
  std::uint32_t parent = 0;        // uid of the track that it has split from; 0: none
  float existence = 1.0F;          // chance that it follows a target
  float first_existence = 1.0F;    // the same at its first detection
  std::array<float, kMaxRadars> counted_false{};  // of its plots as a tentative one, in each radar's map of false plots
  std::array<float, kMaxRadars>
      detection_probability;               // by each radar, as this track has shown so far: radars fade apart
  std::array<double, kMaxRadars> updated;  // by each radar, TT12 and TT39; kNever
  RatePrediction predicted_rate;           // with `predicted`
  HeightGuess height_guess;                // where radars at several sites are joined
  FixedPlace fixed;
  ReferencePlace reference;  // NR: eight scans ago
  std::variant<PolarFilter, tws::MultipleModelFilter> filter;

  /// Chance that the radar whose beam meets it next detects it, if it is there.
  double detectionChance() const {
    return static_cast<double>(detection_probability[predicted.radar] * predicted.cover);
  }
};

}  // namespace adit_tracker
