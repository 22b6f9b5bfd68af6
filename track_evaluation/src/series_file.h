#pragma once

#include <iosfwd>
#include <map>
#include <string>

#include "evaluator.h"

namespace track_evaluation {

/// Tables for plots: what each epoch's metrics were, and where everybody was.
class SeriesFile {
 public:
  /// `tracker,t_s,ospa_m,gospa_m,gospa_loc,gospa_miss,gospa_false,completeness,required,tracks,rms_pos_m`
  void openSeries(std::ostream& out);
  /// `tracker,t_s,what,id,x_m,y_m`, every `period` [s], 0: all; what: required, tolerated, track. Truths on the slant
  /// plane when the tracks know no height.
  void openPicture(std::ostream& out, double period);
  void add(const std::string& tracker, const Epoch& epoch, const Evaluator& evaluator);
  /// A track alone, where there is no truth.
  void addTrack(const std::string& tracker, double time, std::uint32_t id, const Eigen::Vector2d& position);

 private:
  void addPlace(const std::string& tracker, double time, const char* what, std::uint32_t id,
                const Eigen::Vector2d& position);
  void addSeries(const std::string& tracker, const Epoch& epoch, const Evaluator& evaluator);
  void addPicture(const std::string& tracker, const Epoch& epoch);

  std::ostream* series_ = nullptr;
  std::ostream* picture_ = nullptr;
  double period_ = 0.0;
  std::map<std::string, double> next_;
};

}  // namespace track_evaluation
