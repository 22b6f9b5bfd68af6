#pragma once

#include <deque>
#include <optional>
#include <variant>
#include <vector>

#include "rotating_radar.h"
#include "scenario.h"

namespace radar_sim {

/// A sector that one radar has closed, and the mark that closes it.
struct SectorReport {
  std::size_t radar;         ///< Index in Simulation::radars().
  tws::RadarSector sector;   ///< Its leave_time is the mark's time.
  std::uint64_t plot_count;  ///< Plots of this radar since the start, these included.
  double rotation_period;    ///< Of the latest full turn [s]; NaN before there was one.
  struct Beam {
    std::size_t radar;
    double azimuth;  ///< At the mark [rad].
  };
  std::vector<Beam> others;  ///< Of the other radars that are not silent.
};

/// Every target that exists at one instant.
struct TruthReport {
  double time;  ///< [s of data time]
  struct Sighting {
    double slant_range;            ///< [m]
    double azimuth;                ///< [rad]
    double detection_probability;  ///< See RotatingRadar::detectionProbability().
  };
  struct Entry {
    std::size_t target;  ///< Index in Simulation::targets().
    TargetState state;
    std::vector<Sighting> sightings;  ///< One a radar.
  };
  std::vector<Entry> entries;
};

/// Runs a scenario: what happens next, in order of time. At equal times truth comes first, then the radars in their
/// order. The same scenario gives the same reports, bit for bit.
class Simulation {
 public:
  /// Throws std::invalid_argument when the scenario contradicts itself.
  explicit Simulation(const Scenario& scenario);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Time of what step() returns next [s of data time]; nothing: the scenario has ended.
  std::optional<double> nextTime() const;
  /// Must not be called after the end.
  std::variant<SectorReport, TruthReport> step();

  const std::vector<Target>& targets() const { return targets_; }
  /// In the order of the scenario.
  const std::deque<RotatingRadar>& radars() const { return radars_; }

 private:
  double truthTime() const { return scenario_.start_time + static_cast<double>(truth_count_) * scenario_.truth_period; }
  std::size_t earliestRadar() const;
  void skipSilence(RotatingRadar& radar) const;
  SectorReport closeSector(std::size_t radar);
  TruthReport takeTruth();

  Scenario scenario_;
  std::vector<Target> targets_;
  std::deque<RotatingRadar> radars_;
  std::vector<std::uint64_t> plot_counts_;
  std::uint64_t truth_count_ = 0;
};

}  // namespace radar_sim
