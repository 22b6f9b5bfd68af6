#include <tws_core/sector_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

std::vector<std::uint32_t> numbersIn(const SectorFile& file, int sector) {
  std::vector<std::uint32_t> numbers;
  for (auto n = file.first(sector); n != SectorFile::kNone; n = file.next(n)) numbers.push_back(n);
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

// Firm tracks must be offered the detections first, or a tentative track steals them.
TEST(SectorFile, KeepsFirmTracksBeforeTentativeOnes) {
  SectorFile file(10);
  file.addLast(7, 3);   // tentative
  file.addFirst(2, 3);  // firm
  file.addLast(8, 3);
  file.addFirst(1, 3);
  EXPECT_EQ(numbersIn(file, 3), (Numbers{1, 2, 7, 8}));
  EXPECT_EQ(file.count(3), 4U);
  EXPECT_EQ(file.sector(7), 3);
}

TEST(SectorFile, StartsWithEverySectorEmpty) {
  SectorFile file(5);
  for (int sector = 0; sector < kSectors; ++sector) {
    EXPECT_EQ(file.first(sector), SectorFile::kNone);
    EXPECT_EQ(file.count(sector), 0U);
  }
  EXPECT_EQ(file.sector(4), -1);
  EXPECT_EQ(file.sector(5), -1);
}

TEST(SectorFile, RemovesFromTheFrontTheMiddleAndTheEnd) {
  SectorFile file(5);
  for (std::uint32_t n = 0; n < 5; ++n) file.addLast(n, 0);
  file.remove(2);
  EXPECT_EQ(numbersIn(file, 0), (Numbers{0, 1, 3, 4}));
  file.remove(0);
  file.remove(4);
  EXPECT_EQ(numbersIn(file, 0), (Numbers{1, 3}));
  file.addLast(4, 0);
  EXPECT_EQ(numbersIn(file, 0), (Numbers{1, 3, 4}));
  EXPECT_EQ(file.sector(2), -1);
}

TEST(SectorFile, RefusesWhatWouldBreakTheChains) {
  SectorFile file(4, 8);
  file.addFirst(1, 5);
  EXPECT_THROW(file.addFirst(1, 6), std::invalid_argument);
  EXPECT_THROW(file.addLast(1, 5), std::invalid_argument);
  EXPECT_THROW(file.addFirst(4, 5), std::invalid_argument);
  EXPECT_THROW(file.addLast(2, 8), std::invalid_argument);
  EXPECT_THROW(file.addLast(2, -1), std::invalid_argument);
  EXPECT_THROW(file.remove(2), std::invalid_argument);
  EXPECT_THROW(file.remove(4), std::invalid_argument);
  EXPECT_THROW(SectorFile(4, 0), std::invalid_argument);
  EXPECT_EQ(numbersIn(file, 5), (Numbers{1}));
}

// A broken chain loses every track behind the break.
TEST(SectorFile, BehavesLikeListsOfNumbersUnderRandomUse) {
  auto generator = seededGenerator();
  constexpr int kCount = 40, kFew = 4;
  SectorFile file(kCount, kFew);
  std::array<Numbers, kFew> model;
  for (int step = 0; step < 50000; ++step) {
    const auto number = static_cast<std::uint32_t>(uniformInt(generator, 0, kCount - 1));
    const int sector = uniformInt(generator, 0, kFew - 1);
    Numbers& chain = model[sector];
    if (file.sector(number) >= 0) {
      Numbers& old = model[file.sector(number)];
      old.erase(std::find(old.begin(), old.end(), number));
      file.remove(number);
    } else if (step % 2 == 0) {
      chain.insert(chain.begin(), number);
      file.addFirst(number, sector);
    } else {
      chain.push_back(number);
      file.addLast(number, sector);
    }
    for (int s = 0; s < kFew; ++s) {
      ASSERT_EQ(numbersIn(file, s), model[s]) << "step " << step;
      ASSERT_EQ(file.count(s), model[s].size());
    }
  }
}

}  // namespace
}  // namespace tws
