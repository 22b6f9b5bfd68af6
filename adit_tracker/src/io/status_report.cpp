#include "io/status_report.h"

#include <algorithm>
#include <cmath>

namespace adit_tracker {
namespace {

using tws_runtime::Diagnosis;
using Level = Diagnosis::Level;

// Longer than the tracker waits for a radar plus this, and something is wrong with it.
constexpr double kPatience = 1.0;     // [s]
constexpr std::size_t kMuchToDo = 5;  // sectors

std::uint32_t word(std::uint64_t value) { return static_cast<std::uint32_t>(value); }

template <class Is>
std::uint32_t countOf(const Adit& adit, const Is& is) {
  const auto living = adit.tracks().living();
  return word(static_cast<std::uint64_t>(
      std::count_if(living.begin(), living.end(), [&](TrackFile::Slot slot) { return is(adit.tracks().at(slot)); })));
}

bool isStale(const Adit& adit, double silence) { return silence > adit.params().skew_limit + kPatience; }

/// One more trouble: in words, and how bad it is.
void add(Diagnosis& diagnosis, Level level, const std::string& what) {
  diagnosis.level = std::max(diagnosis.level, level);
  diagnosis.summary += (diagnosis.summary.empty() ? "" : "; ") + what;
}

void judgeRadars(const Adit& adit, const NodeState& state, Diagnosis& diagnosis) {
  std::size_t stale = 0;
  for (std::size_t i = 0; i < state.silence.size(); ++i) {
    if (!isStale(adit, state.silence[i])) continue;
    ++stale;
    const std::string since = std::isinf(state.silence[i]) ? "has sent nothing yet" : "is silent";
    add(diagnosis, Level::kWarning, adit.params().radars[i].name + " " + since);
  }
  if (stale == state.silence.size()) diagnosis.level = Level::kError;
}

/// Radars whose errors of registration want a person's attention.
void judgeRegistration(const Adit& adit, Diagnosis& diagnosis) {
  using tws::RegistrationState;
  const auto& reports = adit.registration().reports();
  for (std::size_t i = 0; i < reports.size() && reports.size() > 1; ++i) {
    const RegistrationState state = reports[i].state;
    const std::string& radar = adit.params().radars[i].name;
    if (state != RegistrationState::kOff) diagnosis.values.emplace_back("registration of " + radar, tws::nameOf(state));
    if (state == RegistrationState::kTooLarge)
      add(diagnosis, Level::kWarning, radar + "'s errors of registration are too large to be corrected");
    if (state == RegistrationState::kDrifting)
      add(diagnosis, Level::kWarning, radar + "'s errors of registration are drifting");
  }
}

void judgeLoad(const Adit& adit, const NodeState& state, const std::vector<std::size_t>& ready, Diagnosis& diagnosis) {
  const std::string numbers = std::to_string(adit.tracks().size()) + " of " +
                              std::to_string(adit.params().capacity - 1) + " track numbers are in use";
  if (adit.tracks().size() + 1 >= adit.params().capacity)
    add(diagnosis, Level::kError, "full: " + numbers);
  else if (isFilled(adit, kNearlyFull))
    add(diagnosis, Level::kWarning, numbers);
  const std::size_t most = ready.empty() ? 0 : *std::max_element(ready.begin(), ready.end());
  if (most > kMuchToDo) add(diagnosis, Level::kWarning, std::to_string(most) + " sectors wait to be processed");
  if (state.skipped_sectors > 0)
    add(diagnosis, Level::kWarning, std::to_string(state.skipped_sectors) + " sectors skipped");
}

/// Which volumes there are, and how much is in each.
void listVolumes(const Adit& adit, Diagnosis& diagnosis) {
  constexpr std::size_t kMostListed = 20;
  const auto& volumes = adit.params().volumes;
  for (std::size_t i = 0; i < std::min(volumes.size(), kMostListed); ++i) {
    const auto firm = countOf(adit, [&](const Track& track) { return track.firm && track.volume == i + 1; });
    diagnosis.values.emplace_back("firm tracks in volume " + volumes[i].name, std::to_string(firm));
  }
}

void list(const Adit& adit, const NodeState& state, const std::vector<std::size_t>& ready, Diagnosis& diagnosis) {
  const auto value = [&](const std::string& name, std::uint64_t number) {
    diagnosis.values.emplace_back(name, std::to_string(number));
  };
  const tws_msgs::TrackerStatus status = statusMessage(adit, state);
  value("firm tracks", status.firm_tracks);
  value("tracks", status.tracks);
  value("track numbers", status.capacity - 1);
  value("clutter points", status.clutter_points);
  for (std::size_t i = 0; i < ready.size(); ++i) value("sectors behind " + status.radars[i], status.sector_lag[i]);
  value("sectors skipped", status.skipped_sectors);
  value("slow tracks to clutter", adit.counts().to_clutter);
  value("moving clutter to tracks", adit.counts().to_track);
  value("tracks joined to a lost one", adit.counts().stitched);
  listVolumes(adit, diagnosis);
  value("refused tracks", status.refused_tracks);
  value("late detections", status.late_detections);
  value("rejected detections", status.rejected_detections);
  value("handed off", status.handed_off.size());
}

}  // namespace

bool isFilled(const Adit& adit, double share) {
  return adit.tracks().size() >= share * static_cast<double>(adit.params().capacity - 1);
}

tws_msgs::TrackerStatus statusMessage(const Adit& adit, const NodeState& state) {
  tws_msgs::TrackerStatus message;
  const AditCounts& counts = adit.counts();
  message.firm_tracks = countOf(adit, [](const Track& track) { return track.firm; });
  message.tracks = adit.tracks().size();
  for (const ClutterMap& map : adit.clutter().maps()) message.clutter_points += map.size();
  message.operator_calls = state.operator_calls;
  const std::vector<std::size_t> ready = adit.order().ready();
  for (std::size_t i = 0; i < ready.size(); ++i) {
    message.radars.push_back(adit.params().radars[i].name);
    message.sector_lag.push_back(word(kSectorsAhead + ready[i]));
    message.stale.push_back(adit.order().silent(i));
  }
  message.elevation_searches = countOf(adit, [](const Track& track) { return track.designated; });
  message.skipped_sectors = state.skipped_sectors;
  message.capacity = adit.params().capacity;
  message.refused_tracks = word(counts.refused_tracks);
  message.late_detections = word(counts.late_plots);
  message.rejected_detections = word(counts.rejected_plots + counts.duplicate_plots + state.bad_detections);
  message.late_sectors = word(counts.late_sectors);
  for (const auto slot : adit.tracks().living())
    if (adit.tracks().at(slot).handed_off) message.handed_off.push_back(adit.tracks().at(slot).number);
  std::sort(message.handed_off.begin(), message.handed_off.end());
  return message;
}

Diagnosis diagnosisOf(const Adit& adit, const NodeState& state) {
  Diagnosis diagnosis;
  const std::vector<std::size_t> ready = adit.order().ready();
  judgeRadars(adit, state, diagnosis);
  judgeLoad(adit, state, ready, diagnosis);
  judgeRegistration(adit, diagnosis);
  if (diagnosis.summary.empty()) diagnosis.summary = "caught up";
  list(adit, state, ready, diagnosis);
  return diagnosis;
}

}  // namespace adit_tracker
