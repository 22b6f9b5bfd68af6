#include "state_csv.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

#include "csv_table.h"

namespace track_evaluation {
namespace {

TrackState trackOf(const CsvState& row, double time) {
  TrackState track;
  track.id = row.id;
  track.state = row.state;
  track.age = time - row.time;
  if (track.age > 0.0) track.state.position += track.age * track.state.velocity;
  return track;
}

std::map<double, Epoch> truthEpochs(const std::vector<CsvState>& truth) {
  std::map<double, Epoch> epochs;
  for (const CsvState& row : truth) {
    Epoch& epoch = epochs[row.time];
    epoch.time = row.time;
    TruthState state;
    state.id = row.id;
    state.ground = state.slant = row.state;
    epoch.truths.push_back(state);
  }
  return epochs;
}

void addAtEpochs(std::map<double, Epoch>& epochs, const std::vector<CsvState>& tracks) {
  for (const CsvState& row : tracks) {
    const auto epoch = epochs.find(row.time);
    if (epoch == epochs.end())
      throw std::runtime_error("a track stands at " + std::to_string(row.time) +
                               " s, which is no time of the truth; --resample AGE extrapolates");
    epoch->second.tracks.push_back(trackOf(row, row.time));
  }
}

void addResampled(std::map<double, Epoch>& epochs, const std::vector<CsvState>& tracks, double age) {
  constexpr double kSameTime = 1e-9;
  std::map<std::uint32_t, CsvState> newest;
  std::size_t next = 0;
  for (auto& [time, epoch] : epochs) {
    for (; next < tracks.size() && tracks[next].time <= time + kSameTime; ++next)
      newest[tracks[next].id] = tracks[next];
    for (const auto& [id, row] : newest) {
      if (time - row.time > age) continue;
      if (time > row.time && std::isnan(row.state.velocity.x()))
        throw std::runtime_error("tracks without velocity cannot be extrapolated");
      epoch.tracks.push_back(trackOf(row, time));
    }
  }
}

}  // namespace

std::vector<CsvState> readStates(std::istream& input, const std::string& name) {
  CsvTable table(input, name);
  if (table.columns() < 4) table.fail("wants columns t_s,id,x_m,y_m[,vx_mps,vy_mps]");
  const std::size_t status = table.find("status");
  const bool fast = table.columns() >= 6;
  std::vector<CsvState> states;
  while (table.next()) {
    if (status < table.columns() && table.text(status) == "tentative") continue;
    CsvState& state = states.emplace_back();
    state.time = std::round(table.number(0) * 1e4) / 1e4;
    state.id = table.whole(1);
    state.state.position = {table.number(2), table.number(3)};
    state.state.velocity = {fast ? table.number(4) : kUnknown, fast ? table.number(5) : kUnknown};
    state.coasting = status < table.columns() && table.text(status) == "coasting";
  }
  std::stable_sort(states.begin(), states.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return states;
}

std::vector<CsvState> readStateFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return readStates(file, path);
}

std::vector<Epoch> epochsOf(const std::vector<CsvState>& truth, const std::vector<CsvState>& tracks,
                            std::optional<double> resample_age) {
  if (truth.empty()) throw std::runtime_error("the truth has no rows");
  std::map<double, Epoch> by_time = truthEpochs(truth);
  resample_age ? addResampled(by_time, tracks, *resample_age) : addAtEpochs(by_time, tracks);
  std::vector<Epoch> epochs;
  epochs.reserve(by_time.size());
  for (auto& [time, epoch] : by_time) epochs.push_back(std::move(epoch));
  return epochs;
}

}  // namespace track_evaluation
