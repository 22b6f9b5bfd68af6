#include "core/track_file.h"

#include <gtest/gtest.h>

#include <set>

namespace adit_tracker {
namespace {

std::vector<std::uint32_t> numbersIn(const TrackFile& file, int sector) {
  std::vector<TrackFile::Slot> slots;
  file.list(sector, slots);
  std::vector<std::uint32_t> numbers;
  for (const auto slot : slots) numbers.push_back(file.at(slot).number);
  return numbers;
}

// If this fails, a number that an operator has just seen vanish comes back at once for another target.
TEST(TrackFile, HandsADroppedNumberOutLast) {
  TrackFile file(4);  // Numbers 0 .. 3; one always stays unused.
  const auto first = *file.start();
  EXPECT_EQ(file.at(first).number, 0U);
  file.drop(first);
  EXPECT_EQ(file.at(*file.start()).number, 1U);
  EXPECT_EQ(file.at(*file.start()).number, 2U);
  EXPECT_EQ(file.at(*file.start()).number, 3U);
}

// The report's FULLT starts at 255 for 256 numbers.
TEST(TrackFile, KeepsOneNumberUnused) {
  TrackFile file(256);
  for (int i = 0; i < 255; ++i) ASSERT_TRUE(file.start());
  EXPECT_FALSE(file.start());
  EXPECT_EQ(file.size(), 255U);
}

TEST(TrackFile, NeverUsesAnIdentityTwice) {
  TrackFile file(3);
  std::set<std::uint32_t> seen;
  for (int i = 0; i < 20; ++i) {
    const auto slot = *file.start();
    EXPECT_TRUE(seen.insert(file.at(slot).uid).second);
    file.drop(slot);
  }
}

// If this fails, a tentative track can take a detection from a firm one.
TEST(TrackFile, PutsFirmTracksFirstAndTentativeOnesLast) {
  TrackFile file(10);
  for (int i = 0; i < 4; ++i) {
    const auto slot = *file.start();
    file.at(slot).firm = i % 2 == 1;
    file.place(slot, 17);
  }
  // Firm ones go on top (3 above 1), tentative ones to the bottom (0 above 2).
  EXPECT_EQ(numbersIn(file, 17), (std::vector<std::uint32_t>{3, 1, 0, 2}));
}

TEST(TrackFile, MovesATrackBetweenSectors) {
  TrackFile file(10);
  const auto a = *file.start(), b = *file.start();
  file.place(a, 63);
  file.place(b, 63);
  file.place(a, 0);
  EXPECT_EQ(file.sector(a), 0);
  EXPECT_EQ(numbersIn(file, 63), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(numbersIn(file, 0), (std::vector<std::uint32_t>{0}));
  file.drop(a);
  EXPECT_TRUE(numbersIn(file, 0).empty());
}

// If this fails, a new track inherits times or flags of a dead one.
TEST(TrackFile, StartsEveryTrackClean) {
  TrackFile file(3);
  const auto slot = *file.start();
  file.at(slot).firm = file.at(slot).coasting = true;
  file.at(slot).updated[2] = 5.0;
  file.at(slot).reference.time = 9.0;
  file.drop(slot);
  const Track& track = file.at(*file.start());
  EXPECT_FALSE(track.firm || track.coasting);
  EXPECT_EQ(track.updated[2], kNever);
  EXPECT_EQ(track.illuminated[2], kNever);
  EXPECT_EQ(track.reference.time, kNever);
  EXPECT_EQ(track.updates, 0);
}

// If this fails, memory grows with the capacity or with time, and not with the number of living tracks.
TEST(TrackFile, UsesTheSlotsOfDroppedTracksAgain) {
  TrackFile file(1000);
  for (int i = 0; i < 500; ++i) {
    const auto slot = *file.start();
    EXPECT_EQ(slot, 0U);
    file.drop(slot);
  }
}

}  // namespace
}  // namespace adit_tracker
