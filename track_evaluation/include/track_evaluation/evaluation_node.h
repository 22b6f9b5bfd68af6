#pragma once

#include <tws_runtime/bus.h>

#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string>

namespace track_evaluation {

/// Scores trackers while they run: /truth and /<tracker>/tracks in, /evaluation/summary and /evaluation/timing out.
class EvaluationNode {
 public:
  /// Throws tws_runtime::ParameterError.
  explicit EvaluationNode(tws_runtime::Bus& bus);
  ~EvaluationNode();

  /// At the end of a run: evaluates what still waits for tracks that will not come.
  void finish();
  /// Epochs of truth, and plots that bear an identity, so far.
  std::size_t epochs() const;
  std::size_t identifiedPlots() const;
  /// All scores so far, as doc/metrics.md says. `input`: what the run is called.
  void writeJson(std::ostream& out, const std::string& input) const;
  void writeTable(std::ostream& out) const;

  /// From now on writes a line for each epoch and tracker: sizes, OSPA, GOSPA and its parts, completeness, error. The
  /// stream must outlive the node.
  void writeSeries(std::ostream& out);
  /// From now on writes where truths and tracks are, every `period` [s].
  void writePicture(std::ostream& out, double period);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace track_evaluation
