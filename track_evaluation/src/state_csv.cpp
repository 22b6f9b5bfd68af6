#include "state_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace track_evaluation {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) {
    const auto begin = cell.find_first_not_of(" \t\r"), end = cell.find_last_not_of(" \t\r");
    cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
  }
  return cells;
}

class RowReader {
 public:
  RowReader(std::istream& input, std::string name) : name_(std::move(name)) {
    std::string line;
    if (!std::getline(input, line)) fail("is empty");
    header_ = cells(line);
    if (header_.size() < 4) fail("wants columns t_s,id,x_m,y_m[,vx_mps,vy_mps]");
    while (std::getline(input, line)) {
      ++line_;
      if (line.find_first_not_of(" \t\r") != std::string::npos) read(cells(line));
    }
  }
  std::vector<CsvState> states;

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(name_ + ":" + std::to_string(line_) + ": " + reason);
  }

  double number(const std::vector<std::string>& row, std::size_t column) const {
    char* end = nullptr;
    const double value = std::strtod(row[column].c_str(), &end);
    if (row[column].empty() || *end != '\0' || !std::isfinite(value))
      fail(header_[column] + " '" + row[column] + "' is no number");
    return value;
  }

  void read(const std::vector<std::string>& row) {
    if (row.size() != header_.size())
      fail(std::to_string(row.size()) + " values under " + std::to_string(header_.size()) + " column names");
    for (std::size_t i = 4; i < row.size(); ++i)
      if (header_[i] == "status" && row[i] == "tentative") return;
    CsvState state;
    state.time = std::round(number(row, 0) * 1e4) / 1e4;
    const double id = number(row, 1);
    if (id < 0.0 || id > 4294967295.0 || id != std::floor(id)) fail("id '" + row[1] + "' is no whole number from 0");
    state.id = static_cast<std::uint32_t>(id);
    state.state.position = {number(row, 2), number(row, 3)};
    const bool fast = row.size() >= 6;
    state.state.velocity = {fast ? number(row, 4) : kUnknown, fast ? number(row, 5) : kUnknown};
    states.push_back(state);
  }

  std::string name_;
  std::size_t line_ = 1;
  std::vector<std::string> header_;
};

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
  std::vector<CsvState> states = RowReader(input, name).states;
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
  for (auto& [time, epoch] : by_time) epochs.push_back(std::move(epoch));
  return epochs;
}

}  // namespace track_evaluation
