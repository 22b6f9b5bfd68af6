#include "state_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <tws_core/csv_table.h>

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

struct Columns {
  explicit Columns(const tws::CsvTable& table)
      : time(table.require("t_s")),
        id(idColumn(table)),
        x(table.require("x_m")),
        y(table.require("y_m")),
        vx(table.find("vx_mps")),
        vy(table.find("vy_mps")),
        status(table.find("status")) {}

  static std::size_t idColumn(const tws::CsvTable& table) {
    for (const char* name : {"id", "track_id", "truth_id"})
      if (const std::size_t place = table.find(name); place < table.columns()) return place;
    return table.require("id");
  }

  std::size_t time, id, x, y, vx, vy, status;
};

CsvState stateOf(const tws::CsvTable& table, const Columns& columns) {
  CsvState state;
  state.time = std::round(table.recordedTime(columns.time) * 1e4) / 1e4;
  state.state.position = {table.number(columns.x), table.number(columns.y)};
  state.state.velocity = {table.numberOrUnknown(columns.vx), table.numberOrUnknown(columns.vy)};
  state.coasting = table.text(columns.status) == "coasting";
  return state;
}

std::string idOf(const tws::CsvTable& table, std::size_t column) {
  if (table.text(column).empty()) table.fail("the id is empty");
  return table.text(column);
}

/// The number that an id is written as; nothing: it is another text.
std::optional<std::uint32_t> asNumber(const std::string& id) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  if (error != std::errc() || end != id.data() + id.size()) return std::nullopt;
  return number;
}

/// Ids that are numbers keep theirs; other texts get those that are free, in order of their appearance.
void number(std::vector<CsvState>& states, const std::vector<std::string>& ids) {
  std::set<std::uint32_t> used;
  for (const std::string& id : ids)
    if (const auto own = asNumber(id)) used.insert(*own);
  std::map<std::string, std::uint32_t> given;
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto own = asNumber(ids[i]);
    const auto [entry, is_new] = given.try_emplace(ids[i], own.value_or(0));
    if (is_new && !own) {
      do ++next;
      while (used.count(next) > 0);
      entry->second = next;
    }
    states[i].id = entry->second;
  }
}

}  // namespace

std::vector<CsvState> readStates(std::istream& input, const std::string& name) {
  tws::CsvTable table(input, name);
  const Columns columns(table);
  std::vector<CsvState> states;
  std::vector<std::string> ids;
  while (table.next()) {
    if (table.text(columns.status) == "tentative") continue;
    states.push_back(stateOf(table, columns));
    ids.push_back(idOf(table, columns.id));
  }
  number(states, ids);
  std::stable_sort(states.begin(), states.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return states;
}

std::vector<CsvState> readStateFile(const std::string& path) { return readStates(*tws::openText(path), path); }

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
