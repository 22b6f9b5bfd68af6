#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <tws_core/registration.h>

#include "adit_params.h"
#include "core/radars.h"
#include "core/track_file.h"

namespace adit_tracker {

/// Radars that measure with errors of registration are aligned: their errors are learned from targets that two of them
/// detect, and taken out of their plots where these enter the tracker. See doc/registration.md.
class Alignment {
 public:
  /// `radars` are to outlive it.
  Alignment(const AditParams& params, Radars& radars);

  /// Off: it costs nothing, and changes nothing.
  bool isOn() const { return registration_.mode() != tws::RegistrationMode::kOff; }
  /// Is there anything to learn from?
  bool learns() const { return isOn() && (radars_.size() > 1 || !references_.empty()); }

  /// The sector of that running number of a radar is processed next [s].
  void advance(double time);

  /// A sector with plots as they came: looks for references among them.
  void look(std::size_t radar, const tws::RadarSector& sector);

  /// A track that one plot alone has updated.
  void add(const TrackFile& tracks, TrackFile::Slot slot, const tws::SectorRef& sector, const Detection& detection);

  tws::Registration& registration() { return registration_; }
  const tws::Registration& registration() const { return registration_; }

 private:
  struct Seen {
    tws::Plot plot;                // as the tracker has it
    tws::RegistrationTerms taken;  // out of it already
    std::size_t radar;
  };
  struct History {
    std::uint32_t uid = 0;
    std::deque<Seen> plots;  // the latest, in order of arrival
  };

  void pair(const Track& track, const Seen& at, const Seen& before, const Seen& after);
  double periodOf(std::size_t radar) const { return radars_.antenna(radar).period(); }
  bool isSlower(std::size_t radar, std::size_t other) const;

  Radars& radars_;
  std::vector<RegistrationReference> references_;
  tws::Registration registration_;
  std::vector<History> histories_;  // by slot
};

/// Takes a radar's errors out of a sector: plots, and times of the beam.
void takeOut(const tws::RegistrationTerms& errors, tws::RadarSector& sector);
/// The way back: sets a plot's range, azimuth and time to what its radar has told.
void asTold(const tws::RegistrationTerms& taken, double& time, double& range, double& azimuth);

}  // namespace adit_tracker
