#include "known_tracks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include <tws_core/random_test_helpers.h>
#include <tws_core/sectors.h>

#include "correlator_test_helpers.h"

namespace track_correlator {
namespace {

// If this fails, the beam passes a track without anybody looking at it. Tracks at random, some so near that they cross
// sectors fast, against a look at every track in every sector.
TEST(KnownTracks, FindsEveryTrackThatIsNearTheBeam) {
  std::mt19937_64 generator = tws::seededGenerator();
  KnownTracks tracks;
  std::vector<TrackInput> inputs;
  for (std::uint32_t uid = 0; uid < 300; ++uid) {
    // In 18 s none comes nearer than 1 km, where it would cross sectors faster than the beam.
    const double range = uid % 3 == 0 ? tws::uniform(generator, 6e3, 9e3) : tws::uniform(generator, 9e3, 80e3);
    const double azimuth = tws::uniform(generator, 0.0, tws::kTwoPi);
    inputs.push_back(trackInput(uid, 0.0, range * std::sin(azimuth), range * std::cos(azimuth),
                                tws::uniform(generator, -190.0, 190.0), tws::uniform(generator, -190.0, 190.0)));
    tracks.add(inputs.back());
  }
  for (std::int64_t running = 0; running < 3 * tws::kSectors; ++running) {
    const Mark mark{running, static_cast<double>(running) * 6.0 / tws::kSectors};
    std::set<std::uint32_t> found;
    for (const auto& [uid, track] : tracks.nearTo(mark)) found.insert(uid);
    for (const TrackInput& input : inputs) {
      const Eigen::Vector2d at = input.state.head<2>() + mark.time * input.state.tail<2>();
      const double beam = tws::kSectorWidth * static_cast<double>(running);
      // Sectors from the beam's own to the track's: 0 is the same one.
      const int behind = tws::sectorDifference(tws::sectorOf(beam + 1e-9), tws::sectorOf(std::atan2(at.x(), at.y())));
      EXPECT_EQ(found.count(input.uid) == 1, behind >= -1 && behind <= 2) << input.uid << " in sector " << running;
    }
  }
}

TEST(KnownTracks, NamesOnceATrackWithoutUpdates) {
  KnownTracks tracks;
  tracks.add(trackInput(1, 10.0, 1e3, 0.0, 0.0, 0.0));
  tracks.add(trackInput(2, 20.0, 1e3, 0.0, 0.0, 0.0));
  EXPECT_TRUE(tracks.silentAt(40.0, 30.0).empty());
  EXPECT_EQ(tracks.silentAt(41.0, 30.0), (std::vector<std::uint32_t>{1}));
  tracks.erase(1);
  EXPECT_TRUE(tracks.silentAt(50.0, 30.0).empty());
  EXPECT_EQ(tracks.silentAt(50.5, 30.0), (std::vector<std::uint32_t>{2}));
}

}  // namespace
}  // namespace track_correlator
