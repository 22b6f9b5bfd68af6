#pragma once

#include <tws_core/time_order.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "correlation.h"
#include "evaluation_params.h"
#include "evaluator.h"
#include "identity.h"
#include "timing.h"
#include "track_picture.h"

namespace track_evaluation {

/// One tracker, or a correlator, against truth: joins both by time and feeds the metrics, whatever the order in which
/// they arrive.
class TrackerEvaluation {
 public:
  /// Where the tracker's radar stands in the frame of the truth [m].
  using FindSite = std::function<Eigen::Vector3d(const std::string& radar, const std::string& frame)>;
  using OnEpoch = std::function<void(const Epoch&, const Evaluator&)>;

  /// A confirmed track was updated; called only while there is no truth.
  using OnUpdate = std::function<void(const tws_msgs::Track&)>;

  TrackerEvaluation(const EvaluationParams& params, FindSite find_site, OnEpoch on_epoch, OnUpdate on_update);

  /// False: it came too late, and (truth) was left out or (tracks) will show later than it should.
  bool add(const tws_msgs::Truth& message);
  bool add(const tws_msgs::Tracks& message);
  /// Of a correlator: its own identity is the track.
  bool add(const tws_msgs::CorrelatedTracks& message);
  /// No more will come.
  void finish();

  const Evaluator* evaluator() const { return evaluator_ ? &*evaluator_ : nullptr; }
  std::size_t epochs() const { return epochs_; }
  Timing timing;
  IdentityMetrics identity;
  CorrelationMetrics correlation;

 private:
  using Input = std::variant<tws_msgs::Tracks, tws_msgs::CorrelatedTracks, tws_msgs::Truth>;
  template <class M>
  bool addTracks(const M& message);
  void drain();
  void take(const tws_msgs::Tracks& message);
  void take(const tws_msgs::CorrelatedTracks& message);
  void take(const tws_msgs::Truth& message);
  TruthFilter filter() const;
  Eigen::Vector3d siteOf(const tws_msgs::Truth& message);
  bool isOnGround() const;
  void addUpdates(const tws_msgs::Tracks& message);

  const EvaluationParams& params_;
  FindSite find_site_;
  OnEpoch on_epoch_;
  OnUpdate on_update_;
  tws::TimeOrder<Input> order_;
  TrackPicture picture_;
  std::optional<Evaluator> evaluator_;
  std::string radar_;                             // of the latest message
  std::map<std::string, Eigen::Vector3d> sites_;  // of all radars so far
  std::map<std::uint32_t, double> last_update_;
  std::size_t epochs_ = 0;
};

}  // namespace track_evaluation
