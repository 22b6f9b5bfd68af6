#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <tws_core/alpha_beta.h>
#include <tws_core/geodesy.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include <tws_core/multiple_model_filter.h>
#include <tws_core/registration.h>
#include "core/gate.h"
#include "core/volume_region.h"
#include "elevation/elevation_params.h"

namespace adit_tracker {

/// One radar that feeds the tracker.
struct RadarParams {
  std::string name;
  double period = 6.0;                            // Of a turn, until its marks tell [s].
  double range_sigma = 100.0;                     // Standard deviation of its ranges where the plot does not say [m].
  double azimuth_sigma = 0.3 * tws::kPi / 180.0;  // The same of its azimuths [rad].
  double range_rate_sigma = 0.0;                  // The same of its range rates (Doppler) [m/s]; 0: they are not used.
  double range_rate_span = 600.0;                 // Over how many m/s those of its false plots are spread evenly.
  double range_rate_ambiguity = 0.0;              // They are known but for multiples of this [m/s]; 0: they are known.
};

/// A secondary radar that reports which tracks answer (IFF).
struct IffParams {
  std::string name;
  // Of its plots against the tracks of a radar, which looks at the skin: standard deviations [m], [rad].
  double range_sigma = 150.0;
  double azimuth_sigma = 0.3 * tws::kPi / 180.0;
  double range_bias = 0.0, azimuth_bias = 0.0;  // Measured less true [m], [rad].
};

constexpr std::size_t kGates = 5;

/// The report's timers decide over the life of a track, or the chance that it follows a target.
enum class TrackLife { kTimers, kExistence };
/// The report's filter in range and azimuth, or the turning filter on the plane.
enum class FilterKind { kAlphaBeta, kTurning };
/// The report's fixed regions, or regions from the filter's covariance.
enum class GateKind { kFixed, kStatistical };

/// The report's five passes, each track to the closest plot that is left; or by the chances of all ways to pair them.
enum class Association { kPasses, kChances };

/// The clutter map. A common map is shared by all radars.
struct ClutterParams {
  bool per_radar = true;  // The report's "dual clutter map".
  std::uint32_t capacity = 100000;
  double drop_time = 40.0;       // TCMAX [s]
  Gate gate;                     // CRC, CAC; statistical: the outer limit of it
  double gate_sigmas = 3.0;      // Half-width in standard deviations of the radar; 0: `gate` alone
  long hits = 4;                 // Detections before a point takes detections out of the file; the report's is 1.
  double smoothing = 0.2;        // Least weight of a detection in the point's position; 1: it takes over the position.
  bool yields_to_tracks = true;  // A point on probation ends when a firm track uses its detection.
};

/// Turning clutter points into tracks and tracks into clutter points, every few scans of the reference radar.
struct ConversionParams {
  long scans = 4;  // the report's eight take a minute
  double speed_up =
      56.0 * tws::kMetresPerSecondPerKnot;  // VRMIN upwards: a faster clutter point becomes a track [m/s].
  double speed_down =
      45.0 * tws::kMetresPerSecondPerKnot;  // VRMIN downwards: a slower track becomes a clutter point [m/s].
  // A track in a quiet place must be slower by so many standard deviations of its velocity; 0: its places tell alone.
  double speed_sigmas = 1.0;
  double quiet_density = 3e-9;                         // of false plots a scan, below which a place is quiet [1/m²]
  double azimuth_rate = 100.0 * tws::kAzimuthRateLsb;  // VAMIN [rad/s]
  bool from_start = true;                              // A new track is compared with its first place already.
  bool over_ground = true;  // Judge the speed over ground, in place of range and azimuth rates apart.
};

/// Does something at `range` with these rates [m/s, rad/s] move faster than `speed`, in the sense of the parameters?
bool isFaster(double range_rate, double azimuth_rate, double range, double speed, const ConversionParams& params);

/// When a new track takes over the number of one that was lost.
struct StitchingParams {
  double longest_gap = 2.2;    // from the lost one's last detection to the new one's first [scans]; 0: never
  double speed_change = 50.0;  // greatest difference of their speeds, besides what errors explain [m/s]
};

/// Life of tracks by the report's timers.
struct TimerParams {
  double tentative_drop_time = 9.0;  // TNMAX [s]
  double drop_time = 20.0;           // TTMAX [s]
  double firm_time = 20.0;           // TFIX [s]
};

/// Life of tracks by the chance of existence (Musicki, Evans & Stankovic, IEEE Trans. AC 39(6), 1994).
struct ExistenceParams {
  double new_targets = 1.0;               // Expected number of new targets a scan, against the radar's false plots.
  double firm_probability = 0.99;         // A tentative track becomes firm above it …
  long firm_updates = 3;                  // … with at least so many detections,
  double moving_evidence = 2.0;           // and that much log-likelihood in favour of movement over a fixed place.
  double firm_speed = 0.0;                // It must once have been surely so fast over ground [m/s]; 0: it need not.
  double drop_probability = 0.001;        // A firm track is dropped below it,
  double doubt_probability = 0.3;         // Below it, a firm track shows as tentative until it is detected again.
  double tentative_drop_fraction = 0.03;  // a tentative one below this share of its first chance.
  double detection_probability = 0.85;    // Assumed of a new track; each track then learns its own.
  double survival_time = 1000.0;          // Mean time that a target stays where radars see [s].
};

/// Unresolved targets, and targets that part.
struct PartingParams {
  // The resolution cell of a radar, in standard deviations of its errors, between two plots.
  double cell_range_sigmas = 3.5;
  double cell_azimuth_sigmas = 8.0;
  double unresolved_time = 120.0;  // Two unresolved tracks count as two targets for so long [s].
  double branch_time = 12.0;       // The same of a branch that is not firm yet [s].
  double speed = 200.0;            // Greatest [m/s].
  double speed_sigma = 75.0;       // Of each velocity component of a branch, about its parent's [m/s].
  double per_scan = 0.005;         // Expected of a track in a scan, against the false plots near it.
  double moving_evidence = 0.0;    // A branch becomes firm with this log-likelihood in favour of movement
  long firm_updates = 2;           // A branch becomes firm with so many detections, which must be evidence enough.
};

/// What radars cover, as their firm tracks show.
struct CoverageParams {
  // A track that leaves what they all cover ends, unless its course brings it back within so long [s]; 0: it is not
  // learned what they cover.
  double longest_gap = 30.0;
};

/// What operators get.
struct OperatorParams {
  std::uint32_t page = 0;      // Most tracks that one answer lists; 0: all of them. The report's is 32.
  double point_sigma = 500.0;  // How well an operator's point is placed [m].
};

/// A place of which radars report plots, and which is known: a site monitor, a mast, a moored buoy with a transponder.
struct RegistrationReference {
  std::string name;
  double x = 0.0, y = 0.0;  // East and north of the first radar [m].
  double height = 0.0;      // Above the radars' antennas [m].
  double sigma = 10.0;      // How well the place is known [m].
};

/// What may differ from place to place.
struct LocalParams {
  tws::MultipleModelParams turning;
  ExistenceParams existence;
  ClutterParams clutter;
  ConversionParams conversion;
  StitchingParams stitching;
  PartingParams parting;
};

/// A volume with parameters of its own (ARTAS's tuning areas). Of clutter, conversion and parting those differ that say
/// so in config/default.yaml.
struct Volume {
  std::string name;
  VolumeRegion region;
  LocalParams params;
};

constexpr std::size_t kMostVolumes = 1000;

/// All that the tracker's behaviour depends on. The member initialisers are the set `default`.
struct AditParams : LocalParams {
  std::vector<RadarParams> radars;
  std::vector<IffParams> iff;
  std::optional<tws::LocalFrame> map;  // where the frame of positions lies on earth, if that is known
  std::string reference_radar;         // Whose scans count in conversions (the report's SPS-39). Empty: the last one.
  std::uint32_t capacity = 100000;     // Track numbers; one of them always stays unused.
  double skew_limit = 1.0;             // How late a radar's data may be before it counts as silent [s].

  FilterKind filter = FilterKind::kTurning;
  tws::AdaptiveAlphaBetaParams alpha_beta;
  bool learn_noise = true;  // Learn each radar's standard deviations from its firm tracks.

  GateKind gates = GateKind::kStatistical;
  std::array<Gate, kGates> track_gates;                                    // Fixed: CRT, CAT.
  std::array<double, kGates> gate_distances = {2.0, 4.0, 7.0, 11.0, 1e9};  // Statistical: limits of the distance …
  double gate_sigmas = 5.0;  // … and of the innovation, in standard deviations.

  Association association = Association::kChances;

  TrackLife life = TrackLife::kExistence;
  TimerParams timers;
  CoverageParams coverage;
  bool bifurcation = true;  // Two tracks may share merged plots, and one track may split into two.
  OperatorParams operators;
  tws::RegistrationParams registration;  // Radars that disagree are aligned.
  std::vector<RegistrationReference> registration_references;
  ElevationParams elevation;

  std::vector<Volume> volumes;  // The first that holds a place counts there; where none does, what stands here.

  /// Of volume `number`, counted from 1; 0: of no volume.
  const LocalParams& in(std::uint16_t number) const {
    return number == 0 ? *this : volumes[number - std::size_t{1}].params;
  }
  /// The number of the volume at a place, for what went by the parameters of `before` so far and leaves that only when
  /// it is clearly out of it.
  std::uint16_t volumeAt(const VolumePlace& place, std::uint16_t before = 0) const;

  /// The names that named() knows.
  static const std::vector<std::string>& sets();
  /// The same as a list in words.
  static std::string setNames();
  /// The named set without radars: "default"; "airport"; "marine" for boats and ships; or "nrl7952", the report's
  /// letter. Throws std::invalid_argument.
  static AditParams named(const std::string& name);
};

/// No radar sees further [m]: plots and places beyond are mistakes, and their squares must stay finite.
constexpr double kFarthest = 1e7;

/// Larger range rates are mistakes [m/s].
constexpr double kFastestRate = 1e5;

/// Can radars at different sites be joined? That needs the turning filter, which is on the plane, and a clutter map for
/// each radar.
bool joinsSites(const AditParams& params);

/// The index of the radar of that name; of the last one when there is none. Needs a radar.
std::size_t radarIndex(const AditParams& params, const std::string& name);

/// Throws std::invalid_argument that names the parameter, its value and its range.
void check(const AditParams& params);

}  // namespace adit_tracker
