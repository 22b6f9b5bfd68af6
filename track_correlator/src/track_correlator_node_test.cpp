#include <track_correlator/track_correlator_node.h>

#include <gtest/gtest.h>
#include <ros/serialization.h>
#include <tws_core/random_test_helpers.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/defaults.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <variant>

namespace track_correlator {
namespace {

using tws_msgs::CorrelatedTrack;
using tws_msgs::Track;

constexpr double kPeriod = 6.4, kSectorTime = kPeriod / 64.0, kLag = 0.5;  // [s]
constexpr double kStart = 1000.0;

/// A track that stands at this azimuth [rad], 30 km away.
Track trackAt(std::uint32_t uid, double time, double azimuth, std::uint8_t state = Track::FIRM) {
  Track track;
  track.uid = uid;
  track.number = uid + 1000;
  track.state = state;
  track.stamp = track.last_update = track.first_detection = tws_runtime::toTime(time);
  track.range = 30e3;
  track.azimuth = azimuth;
  track.position.x = 30e3 * std::sin(azimuth);
  track.position.y = 30e3 * std::cos(azimuth);
  track.mode_1 = track.mode_2 = track.mode_3a = Track::CODE_UNKNOWN;
  track.height = std::nan("");
  return track;
}

/// One message on its way: it arrives some time after its stamp.
struct Arrival {
  double time;
  std::variant<tws_msgs::Tracks, tws_msgs::SectorMark> message;
  bool primary = false;
};

/// Turns of a radar and two trackers that lag behind it; one aircraft in sector 10 that both see.
std::vector<Arrival> feed(int turns) {
  std::vector<Arrival> arrivals;
  for (std::uint32_t n = 0; n < 64U * static_cast<std::uint32_t>(turns); ++n) {
    const double t = kStart + n * kSectorTime;
    tws_msgs::SectorMark mark;
    mark.header.stamp = tws_runtime::toTime(t);
    mark.radar = "sps12";
    mark.running_sector = n;
    mark.sector = static_cast<std::uint8_t>(n % 64);
    arrivals.push_back({t, mark});
    for (const bool primary : {true, false}) {
      tws_msgs::Tracks tracks;
      tracks.header.stamp = mark.header.stamp;
      tracks.header.frame_id = "map";
      tracks.running_sector = tracks.sequence = n;
      tracks.sector = mark.sector;
      if (n % 64 == 10) {
        tracks.tracks.push_back(trackAt(primary ? 7 : 8, t + 0.01, primary ? 1.02 : 1.021));
        if (!primary) {
          tracks.tracks.back().mode_3a = 04321;
          tracks.tracks.back().height = 9000.0;
        }
      }
      arrivals.push_back({t + (primary ? kLag : 0.2), tracks, primary});
    }
  }
  std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return arrivals;
}

/// The node in one process, and all that it has said.
struct Graph {
  explicit Graph(const std::string& parameters = "{}") {
    tws_runtime::Bus& bus = graph.addNode("others");
    topics[0] = bus.advertise<tws_msgs::Tracks>("/ssr/tracks");
    topics[1] = bus.advertise<tws_msgs::Tracks>("/adit/tracks");
    marks = bus.advertise<tws_msgs::SectorMark>("/sps12/sector_marks");
    bus.subscribe<tws_msgs::CorrelatedTracks>("/correlated/tracks", [this](const auto& m) { published.push_back(m); });
    node = std::make_unique<TrackCorrelatorNode>(graph.addNode("track_correlator", YAML::Load(parameters)));
  }
  void publish(const std::vector<Arrival>& arrivals) {
    for (const Arrival& arrival : arrivals) {
      if (const auto* mark = std::get_if<tws_msgs::SectorMark>(&arrival.message))
        marks.publish(*mark);
      else
        topics[arrival.primary].publish(std::get<tws_msgs::Tracks>(arrival.message));
      graph.drain();
    }
  }
  std::vector<CorrelatedTrack> tracks() const {
    std::vector<CorrelatedTrack> all;
    for (const auto& message : published) all.insert(all.end(), message.tracks.begin(), message.tracks.end());
    return all;
  }
  std::uint64_t count(const std::string& name) const {
    for (const auto& reading : graph.counters())
      if (reading.node == "track_correlator" && reading.name == name) return reading.value;
    return 0;
  }

  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  tws_runtime::Publisher<tws_msgs::Tracks> topics[2];
  tws_runtime::Publisher<tws_msgs::SectorMark> marks;
  std::vector<tws_msgs::CorrelatedTracks> published;
  std::unique_ptr<TrackCorrelatorNode> node;
};

// If this fails, the picture lacks height and code, or shows one aircraft twice.
TEST(TrackCorrelatorNode, JoinsThePrimarysMotionWithTheSecondarysCodeAndHeight) {
  Graph graph;
  graph.publish(feed(6));
  const CorrelatedTrack last = graph.tracks().back();
  EXPECT_EQ(last.kind, CorrelatedTrack::CORRELATED);
  EXPECT_EQ(last.primary, 1007U);
  EXPECT_EQ(last.secondary, 1008U);
  EXPECT_EQ(last.fusion_count, 6U);
  EXPECT_EQ(last.scan_count, 5U);
  EXPECT_EQ(last.identity, 1U);
  EXPECT_EQ(last.track.number, 1U);
  EXPECT_EQ(last.track.mode_3a, 04321);
  EXPECT_EQ(last.track.height, 9000.0);
  EXPECT_DOUBLE_EQ(last.track.azimuth, 1.02);
  // At the mark of the sector where it lies: 1.02 rad is in sector 10, of 0.0982 rad each.
  EXPECT_NEAR(last.track.stamp.toSec(), kStart + (5 * 64 + 10) * kSectorTime, 1e-6);
  EXPECT_EQ(graph.count("late messages"), 0U);
}

TEST(TrackCorrelatorNode, SaysEverySectorOnceInOrder) {
  Graph graph;
  graph.publish(feed(3));
  ASSERT_GT(graph.published.size(), 180U);
  for (std::size_t n = 0; n < graph.published.size(); ++n) {
    EXPECT_EQ(graph.published[n].running_sector, n);
    EXPECT_EQ(graph.published[n].header.frame_id, "map");
    EXPECT_EQ(graph.published[n].radar, "sps12");
  }
}

// If this fails, live runs and replays differ.
TEST(TrackCorrelatorNode, SaysTheSameBytesInWhateverOrderItsInputsArrive) {
  auto generator = tws::seededGenerator();
  std::vector<Arrival> arrivals = feed(8);
  std::vector<std::vector<std::uint8_t>> said;
  for (int run = 0; run < 4; ++run) {
    Graph graph;
    graph.publish(arrivals);
    std::vector<std::uint8_t> bytes;
    for (const auto& message : graph.published) {
      const auto buffer = ros::serialization::serializeMessage(message);
      bytes.insert(bytes.end(), buffer.buf.get(), buffer.buf.get() + buffer.num_bytes);
    }
    EXPECT_EQ(graph.count("late messages"), 0U);
    // Offline may go a few sectors further: compare what all have said.
    said.push_back(bytes);
    const std::size_t common = std::min(said.front().size(), bytes.size());
    ASSERT_GT(common, 400U * 45) << "a message without tracks has 45 bytes";
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(common), said.front().begin()));
    // Each stream stays in order, but up to a second late against the others.
    double late[3] = {};
    for (double& l : late) l = tws::uniform(generator, 0.0, 1.0);
    for (Arrival& a : arrivals) {
      const bool mark = std::holds_alternative<tws_msgs::SectorMark>(a.message);
      const double stamp = mark ? std::get<tws_msgs::SectorMark>(a.message).header.stamp.toSec()
                                : std::get<tws_msgs::Tracks>(a.message).header.stamp.toSec();
      a.time = stamp + late[mark ? 2 : a.primary];
    }
    std::stable_sort(arrivals.begin(), arrivals.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  }
}

// If this fails, a secondary radar that is switched off takes the primary picture with it.
TEST(TrackCorrelatorNode, GoesOnWithThePrimaryWhileTheSecondaryFeedIsSilentAndTakesItInAgain) {
  Graph graph("{track_timeout_s: 15}");
  std::vector<Arrival> arrivals = feed(30);
  arrivals.erase(std::remove_if(arrivals.begin(), arrivals.end(),
                                [](const Arrival& a) {
                                  const auto* m = std::get_if<tws_msgs::Tracks>(&a.message);
                                  return m != nullptr && !a.primary && m->sequence >= 320 && m->sequence < 960;
                                }),
                 arrivals.end());
  graph.publish(arrivals);
  EXPECT_EQ(graph.count("silent tracks"), 1U);
  EXPECT_EQ(graph.count("lost messages"), 1U);
  int primary_only = 0;
  for (const auto& track : graph.tracks()) {
    primary_only += track.kind == CorrelatedTrack::PRIMARY_ONLY && track.scan_count == 0;
    if (track.track.state != Track::DROPPED && track.kind != CorrelatedTrack::SECONDARY_ONLY) {
      EXPECT_EQ(track.identity, 1U);
    }
  }
  EXPECT_GT(primary_only, 3);
  EXPECT_EQ(graph.tracks().back().kind, CorrelatedTrack::CORRELATED);
}

TEST(TrackCorrelatorNode, CountsWhatIsBadAndLosesNothingElse) {
  Graph graph;
  std::vector<Arrival> arrivals = feed(8);
  for (Arrival& a : arrivals) {
    if (auto* m = std::get_if<tws_msgs::Tracks>(&a.message); m != nullptr && m->sequence == 202 && a.primary) {
      m->tracks.push_back(m->tracks[0]);  // twice
      m->tracks.push_back(trackAt(50, kStart, std::nan("")));
      m->tracks.push_back(trackAt(51, kStart, 2.0));
      m->tracks.back().covariance.assign(3, 1.0);
      m->tracks.push_back(trackAt(52, kStart + 20.2, 2.0, Track::TENTATIVE));
    }
    auto* mark = std::get_if<tws_msgs::SectorMark>(&a.message);
    if (mark != nullptr && mark->running_sector == 300) mark->radar = "sps39";
    if (mark != nullptr && mark->running_sector == 310) mark->header.stamp = ros::Time(1.0);
  }
  graph.publish(arrivals);
  EXPECT_EQ(graph.count("duplicate tracks"), 1U);
  EXPECT_EQ(graph.count("bad tracks"), 2U);
  EXPECT_EQ(graph.count("bad messages"), 1U);
  EXPECT_EQ(graph.count("stray messages"), 1U);
  EXPECT_EQ(graph.count("lost sector marks"), 2U);
  EXPECT_EQ(graph.count("new runs"), 0U);
  EXPECT_EQ(graph.tracks().back().fusion_count, 8U);
}

// If this fails, stamps that were damaged on their way, of all inputs of a sector together, cost the picture.
TEST(TrackCorrelatorNode, StrayStampsLoseNoTrack) {
  for (const double off : tws_runtime::kStrays) {
    Graph graph;
    std::vector<Arrival> arrivals = feed(8);
    for (Arrival& a : arrivals) {
      auto* mark = std::get_if<tws_msgs::SectorMark>(&a.message);
      auto* tracks = std::get_if<tws_msgs::Tracks>(&a.message);
      if (mark != nullptr && mark->running_sector == 300) *mark = tws_runtime::withStrayStamp(*mark, off);
      if (tracks != nullptr && tracks->sequence == 300) *tracks = tws_runtime::withStrayStamp(*tracks, off);
    }
    graph.publish(arrivals);
    EXPECT_EQ(graph.count("stray messages"), 3U) << off;
    EXPECT_EQ(graph.count("new runs"), 0U);
    EXPECT_EQ(graph.tracks().back().fusion_count, 8U);
    EXPECT_EQ(graph.tracks().back().identity, 1U);
  }
}

TEST(TrackCorrelatorNode, BeginsAnewWhenTimeGoesBack) {
  Graph graph;
  graph.publish(feed(8));
  graph.publish(feed(8));
  EXPECT_EQ(graph.count("new runs"), 1U);
  EXPECT_EQ(graph.tracks().back().identity, 1U);
  EXPECT_EQ(graph.tracks().back().fusion_count, 8U);
}

TEST(TrackCorrelatorNode, LoadsTheShippedFileAndRefusesUnknownParameters) {
  const YAML::Node tree = tws_runtime::loadParameterFile(TRACK_CORRELATOR_CONFIG "/track_correlator.yaml");
  const auto departures = tws_runtime::departuresFromDefaults([&] { Graph(YAML::Dump(tree)); });
  EXPECT_EQ(departures, std::vector<std::string>{}) << "the file is the reference of the defaults";
  EXPECT_THROW(Graph("{schema: plain}"), tws_runtime::ParameterError);
  EXPECT_THROW(Graph("{scheme: fast}"), tws_runtime::ParameterError);
  EXPECT_THROW(Graph("{delay_sectors: 1}"), tws_runtime::ParameterError);
  EXPECT_THROW(Graph("{secondary: adit/tracks}"), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace track_correlator
