#pragma once

#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "array_radar.h"
#include "range_radar.h"
#include "rotating_radar.h"
#include "scenario.h"
#include "secondary_radar.h"

namespace radar_sim {

/// What the mark that closes a sector says besides.
struct MarkReport {
  std::uint64_t plot_count = 0;  ///< Plots of this radar since the start, the sector's included.
  double rotation_period = 0.0;  ///< Of the latest full turn [s]; NaN before there was one.
  struct Beam {
    std::size_t radar;  ///< Index in Simulation::radars().
    double azimuth;     ///< At the mark [rad].
  };
  std::vector<Beam> others;  ///< Of the other primary radars that are not silent.
};

/// A sector that one primary radar has closed, and the mark that closes it.
struct SectorReport : MarkReport {
  std::size_t radar;        ///< Index in Simulation::radars().
  tws::RadarSector sector;  ///< Its leave_time is the mark's time.
};

/// The same of a secondary radar.
struct SecondarySectorReport : MarkReport {
  std::size_t radar;  ///< Index in Simulation::secondaryRadars().
  SecondarySector sector;
};

/// What one array radar did in a resource period.
struct ArrayReport {
  std::size_t radar;  ///< Index in Simulation::arrayRadars().
  ResourcePeriod period;
};

/// A profile of one range radar.
struct RangeReport {
  std::size_t radar;  ///< Index in Simulation::rangeRadars().
  AmplitudeProfile profile;
};

/// Every target that exists at one instant.
struct TruthReport {
  double time;  ///< [s of data time]
  struct Sighting {
    double slant_range;            ///< [m]
    double azimuth;                ///< [rad]
    double detection_probability;  ///< See RotatingRadar::detectionProbability(), ArrayRadar::detectionProbability().
  };
  struct Entry {
    std::size_t target;  ///< Index in Simulation::targets().
    TargetState state;
    std::vector<Sighting> sightings;  ///< One a primary radar: the rotating ones, then the arrays.
  };
  std::vector<Entry> entries;
};

/// Runs a scenario: what happens next, in order of time. At equal times truth comes first, then the radars in their
/// order, then the secondary ones, then the arrays, then those that measure range profiles. The same scenario with
/// the same commands gives the same reports, bit for bit.
class Simulation {
 public:
  /// Throws std::invalid_argument when the scenario contradicts itself.
  explicit Simulation(const Scenario& scenario);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Time of what step() returns next [s of data time]; nothing: the scenario has ended.
  std::optional<double> nextTime() const;
  /// Must not be called after the end.
  std::variant<SectorReport, SecondarySectorReport, ArrayReport, RangeReport, TruthReport> step();

  const std::vector<Target>& targets() const { return targets_; }
  /// In the order of the scenario.
  const std::deque<RotatingRadar>& radars() const { return radars_; }
  const std::deque<SecondaryRadar>& secondaryRadars() const { return secondary_radars_; }
  const std::deque<ArrayRadar>& arrayRadars() const { return array_radars_; }
  const std::deque<RangeRadar>& rangeRadars() const { return range_radars_; }
  /// See RotatingRadar::setElevationSearches().
  std::size_t setElevationSearches(std::size_t radar, const std::vector<ElevationOrder>& orders) {
    return radars_[radar].setElevationSearches(orders);
  }
  /// Closes the loop of an array: its dwells are planned by these tracks from now on.
  void setTracks(std::size_t array, std::vector<ArrayTrack> tracks) {
    array_radars_[array].setTracks(std::move(tracks));
  }
  /// The gate of a range radar from its next profile on. False: it makes no sense, and the old one stays.
  bool setGate(std::size_t radar, RangeGate gate) { return range_radars_[radar].setGate(gate); }

 private:
  double truthTime() const { return scenario_.start_time + static_cast<double>(truth_count_) * scenario_.truth_period; }
  /// Makes the radar of these parameters, and lets it turn until it is heard of.
  template <class Radar, class Params>
  void addRadar(std::deque<Radar>& radars, const Params& params);
  template <class Radar>
  void skipSilence(Radar& radar) const;
  /// `count`: of this radar's plots, goes on.
  template <class Report, class Radar>
  Report closeSector(Radar& radar, std::uint64_t& count) const;
  template <class Report, class Radar>
  Report closeEarliest(std::deque<Radar>& radars, std::vector<std::uint64_t>& counts) const;
  ArrayReport runArray();
  RangeReport takeProfile();
  TruthReport takeTruth();

  Scenario scenario_;
  std::vector<Target> targets_;
  std::deque<RotatingRadar> radars_;
  std::deque<SecondaryRadar> secondary_radars_;
  std::deque<ArrayRadar> array_radars_;
  std::deque<RangeRadar> range_radars_;
  std::vector<std::uint64_t> plot_counts_;
  std::vector<std::uint64_t> secondary_plot_counts_;
  std::uint64_t truth_count_ = 0;
};

}  // namespace radar_sim
