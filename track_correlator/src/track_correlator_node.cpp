#include <track_correlator/track_correlator_node.h>

#include <tws_core/sectors.h>
#include <tws_core/time_order.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/count_report.h>
#include <tws_runtime/intake.h>

#include <array>
#include <optional>
#include <set>
#include <unordered_map>
#include <variant>

#include "correlator_messages.h"
#include "correlator_params_reader.h"

namespace track_correlator {
namespace {

using tws_runtime::Bus;

struct NodeParams {
  CorrelatorParams correlator;
  std::string clock_radar = "sps12";
  std::array<std::string, 2> tracks = {"adit/tracks", "ssr/tracks"};  // topics: primary, secondary
  double skew_limit = 3.0;                                            // [s]
  double restart_limit = 5.0;                                         // [s]
  double position_sigma = 200.0, velocity_sigma = 30.0;               // of tracks without a covariance [m], [m/s]
};

NodeParams readNodeParams(Bus& bus) {
  tws_runtime::ParameterReader reader(bus.parameters(), bus.name());
  NodeParams params;
  params.correlator = readCorrelatorParams(reader);
  reader.text("clock_radar", params.clock_radar);
  reader.text("primary", params.tracks[0]);
  reader.text("secondary", params.tracks[1]);
  reader.number("skew_limit_s", params.skew_limit, 0.1, 60.0);
  reader.number("restart_limit_s", params.restart_limit, 0.5, 3600.0);
  reader.number("position_sigma_m", params.position_sigma, 0.1, 1e5);
  reader.number("velocity_sigma_mps", params.velocity_sigma, 0.1, 1e4);
  reader.done();
  for (const char* key : {"clock_radar", "primary", "secondary"})
    if ((key[0] == 'c' ? params.clock_radar : params.tracks[key[0] == 's']).empty()) reader.fail(key, "is empty");
  if (params.tracks[0] == params.tracks[1]) reader.fail("secondary", "must be another topic than primary");
  return params;
}

// The clocked inputs. Of equal times tracks come before marks.
constexpr std::size_t kPrimary = 0, kSecondary = 1, kMarks = 2;

}  // namespace

class TrackCorrelatorNode::Impl {
 public:
  explicit Impl(Bus& bus)
      : bus_(bus),
        params_(readNodeParams(bus)),
        order_(3, params_.skew_limit),
        out_(bus.advertise<tws_msgs::CorrelatedTracks>("correlated/tracks")),
        counts_(bus,
                {{"initiated pairs", &CorrelatorCounts::initiated},
                 {"partners taken over", &CorrelatorCounts::taken_over},
                 {"released pairs", &CorrelatorCounts::released},
                 {"cleared rows", &CorrelatorCounts::cleared},
                 {"clusters", &CorrelatorCounts::clusters},
                 {"silent tracks", &CorrelatorCounts::silent_tracks,
                  "its tracker no longer updates it and has published no final update"},
                 {"lost sector marks", &CorrelatorCounts::lost_marks, "a running number of the clock radar is missing"},
                 {"stray sector marks", &CorrelatorCounts::stray_marks,
                  "a running number of the clock radar is out of line"}}),
        intake_(bus, params_.restart_limit, [this](double) { begin(); }) {
    begin();
    for (const std::size_t stream : {kPrimary, kSecondary})
      intake_.subscribe<tws_msgs::Tracks>(
          {params_.tracks[stream]}, [this, stream](const tws_msgs::Tracks& message) { onTracks(stream, message); });
    const std::string marks = params_.clock_radar + "/sector_marks";
    intake_.subscribe<tws_msgs::SectorMark>(
        {marks, params_.clock_radar, tws_runtime::StampOrder::kAny, tws_runtime::sectorFault<tws_msgs::SectorMark>},
        [this, marks](const auto& mark) { queue(kMarks, marks, mark); });
  }

 private:
  using Input = std::variant<tws_msgs::Tracks, tws_msgs::SectorMark>;

  void begin() {
    order_.reset();
    stream_time_ = {};
    for (auto& tracks : latest_) tracks.clear();
    counts_.reset();
    correlator_.emplace(params_.correlator, [this](const CorrelatorReport& report) { publish(report); });
  }

  void onTracks(std::size_t stream, const tws_msgs::Tracks& message) {
    frame_ = stream == kPrimary || frame_.empty() ? message.header.frame_id : frame_;
    checkSequence(stream, message);
    queue(stream, params_.tracks[stream], message);
  }

  void checkSequence(std::size_t stream, const tws_msgs::Tracks& message) {
    std::optional<std::uint32_t>& last = sequence_[stream];
    if (last && message.sequence > *last + 1)
      bus_.counter("lost messages")
          .add("sequence jumps to " + std::to_string(message.sequence) + " in " + params_.tracks[stream]);
    last = message.sequence;
  }

  /// All inputs go on in order of time, whatever the order in which they arrive.
  template <class M>
  void queue(std::size_t stream, const std::string& topic, const M& message) {
    // A tracker of several radars may step back a little from message to message.
    double& stream_time = stream_time_[stream];
    stream_time = std::max(stream_time, tws_runtime::toSeconds(message.header.stamp));
    if (const auto late = order_.push(stream, stream_time, Input(message))) {
      bus_.counter("late messages")
          .add("more than skew_limit_s behind the others" + tws_runtime::whereText(topic, message.header.stamp));
      apply(stream, *late);  // A late update of a track is better than none.
    }
    while (auto next = order_.pop()) apply(next->stream, next->value);
    counts_.add(correlator_->counts());
  }

  void apply(std::size_t stream, const Input& input) {
    if (stream == kMarks) {
      const auto& mark = std::get<tws_msgs::SectorMark>(input);
      correlator_->addMark(mark.running_sector, tws_runtime::toSeconds(mark.header.stamp));
      return;
    }
    std::set<std::uint32_t> said;
    for (const tws_msgs::Track& track : std::get<tws_msgs::Tracks>(input).tracks) {
      // A tracker may update a track and drop it in the same sector.
      if (!said.insert(track.uid).second && track.state != tws_msgs::Track::DROPPED)
        bus_.counter("duplicate tracks")
            .add("uid " + std::to_string(track.uid) + " twice in one message of " + params_.tracks[stream]);
      else
        take(stream, track);
    }
  }

  void take(std::size_t stream, const tws_msgs::Track& track) {
    const std::string fault = faultOf(track);
    if (!fault.empty()) {
      bus_.counter("bad tracks").add(fault + " in " + params_.tracks[stream] + ", uid " + std::to_string(track.uid));
      return;
    }
    auto& latest = latest_[stream];
    // What a tracker does not believe yet is no aircraft; one that it only doubts for a while still is.
    if (track.state == tws_msgs::Track::TENTATIVE && latest.count(track.uid) == 0) return;
    if (track.state == tws_msgs::Track::DROPPED && latest.count(track.uid) == 0) return;
    latest[track.uid] = track;
    const TrackInput input = toInput(track, params_.position_sigma, params_.velocity_sigma);
    stream == kPrimary ? correlator_->addPrimary(input) : correlator_->addSecondary(input);
  }

  const tws_msgs::Track* find(std::size_t stream, std::uint32_t uid) const {
    const auto found = latest_[stream].find(uid);
    return found == latest_[stream].end() ? nullptr : &found->second;
  }

  void publish(const CorrelatorReport& report) {
    tws_msgs::CorrelatedTracks message;
    message.header.stamp = tws_runtime::toTime(report.time);
    message.header.frame_id = frame_;
    message.radar = params_.clock_radar;
    message.running_sector = static_cast<std::uint32_t>(report.running);
    message.sector = static_cast<std::uint8_t>(report.running % tws::kSectors);
    for (const CorrelatedUpdate& update : report.updates)
      message.tracks.push_back(
          toMessage(update, find(kPrimary, update.primary), find(kSecondary, update.secondary), report.time));
    out_.publish(message);
    if (message.sector == 0) forget();
  }

  /// Once a turn: what no row and no track holds is needed no more.
  void forget() {
    std::array<std::unordered_map<std::uint32_t, tws_msgs::Track>, 2> kept;
    for (const std::size_t stream : {kPrimary, kSecondary})
      for (auto& [uid, track] : latest_[stream])
        if (correlator_->holds(stream == kPrimary, uid)) kept[stream].emplace(uid, std::move(track));
    latest_ = std::move(kept);
  }

  Bus& bus_;
  NodeParams params_;
  tws::TimeOrder<Input> order_;
  tws_runtime::Publisher<tws_msgs::CorrelatedTracks> out_;
  std::array<double, 3> stream_time_ = {};
  std::array<std::unordered_map<std::uint32_t, tws_msgs::Track>, 2> latest_;  // updates by uid: primary, secondary
  std::array<std::optional<std::uint32_t>, 2> sequence_;
  std::string frame_;
  tws_runtime::CountReport<CorrelatorCounts> counts_;
  std::optional<Correlator> correlator_;
  tws_runtime::Intake intake_;
};

TrackCorrelatorNode::TrackCorrelatorNode(Bus& bus) : impl_(std::make_unique<Impl>(bus)) {}
TrackCorrelatorNode::~TrackCorrelatorNode() = default;

}  // namespace track_correlator
