#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "epoch.h"

namespace track_evaluation {

/// One row of a file of truth or tracks.
struct CsvState {
  double time = 0.0;  ///< [s], rounded to 0.1 ms: what is equal then belongs to one epoch
  std::uint32_t id = 0;
  PlanarState state;      ///< Velocity NaN when the file has none.
  bool coasting = false;  ///< Its status says so: no detection stands behind this row.
};

/// Reads a table (see tws::CsvTable) with the columns t_s, x_m, y_m and one of id, track_id, truth_id. Further columns
/// vx_mps and vy_mps may be empty: unknown. Any text is an id: what is a whole number keeps it, others are numbered.
/// Rows whose column `status` says tentative are left out. In order of time, within ±1e10 s, rows of one time in the
/// order of the file. Throws std::runtime_error with `name`, line and reason.
std::vector<CsvState> readStates(std::istream& input, const std::string& name);
/// Throws also when the file cannot be opened.
std::vector<CsvState> readStateFile(const std::string& path);

/// The epochs of a pair of files: the times of the truth are the epochs. The tracks must stand at these times, or, when
/// `resample_age` [s] is given, at any time: then each track's newest row not after the epoch and at most that old is
/// extrapolated to it. Throws std::runtime_error when a track's time is no epoch, a row that must be extrapolated has
/// no velocity, or one file is empty of rows (the truth's).
std::vector<Epoch> epochsOf(const std::vector<CsvState>& truth, const std::vector<CsvState>& tracks,
                            std::optional<double> resample_age);

}  // namespace track_evaluation
