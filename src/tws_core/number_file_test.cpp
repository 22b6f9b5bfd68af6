#include <tws_core/number_file.h>

#include <gtest/gtest.h>

#include <deque>
#include <set>
#include <stdexcept>
#include <string>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

TEST(NumberFile, HandsOut255Of256NumbersInOrderAsTheReportDoes) {
  NumberFile file(256);
  EXPECT_EQ(file.size(), 256U);
  EXPECT_EQ(file.available(), 255U);
  for (std::uint32_t i = 0; i < 255; ++i) EXPECT_EQ(file.take(), i);
  EXPECT_EQ(file.available(), 0U);
  EXPECT_EQ(file.take(), std::nullopt);
}

// A number used again at once would make the operator take a new target for the one just dropped.
TEST(NumberFile, UsesADroppedNumberAgainAfterAllOthers) {
  NumberFile file(4);
  file.take();
  file.take();
  file.drop(0);
  EXPECT_EQ(file.take(), 2U);
  EXPECT_EQ(file.take(), 3U);
  EXPECT_EQ(file.take(), std::nullopt);  // 1, 2 and 3 are in use: three of four
  file.drop(2);
  EXPECT_EQ(file.take(), 0U);
}

TEST(NumberFile, KnowsWhichNumbersAreUsed) {
  NumberFile file(3);
  file.take();
  EXPECT_TRUE(file.used(0));
  EXPECT_FALSE(file.used(1));
  EXPECT_FALSE(file.used(3));
  EXPECT_FALSE(file.used(0xffffffff));
}

TEST(NumberFile, RefusesToDropWhatIsNotInUseAndNamesIt) {
  NumberFile file(8);
  file.take();
  file.drop(0);
  for (std::uint32_t number : {0U, 5U, 8U}) {
    try {
      file.drop(number);
      FAIL() << "dropped " << number;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("number " + std::to_string(number)), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(file.available(), 7U);
}

TEST(NumberFile, RefusesASizeItCannotKeep) {
  for (std::uint32_t size : {0U, 1U, 0xffffffffU}) EXPECT_THROW(NumberFile{size}, std::invalid_argument) << size;
}

// If this fails, a map of clutter that is kept by number grows for hours, whatever it holds.
TEST(NumberFile, ADroppedNumberThatHasRestedIsHandedOutBeforeANewOne) {
  NumberFile file(1000, 3);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(file.take(), i);
  for (std::uint32_t i : {4U, 0U, 2U}) file.drop(i);
  EXPECT_EQ(file.take(), 5U);  // None has rested.
  file.drop(1);
  EXPECT_EQ(file.take(), 4U);
  EXPECT_EQ(file.take(), 6U);
  EXPECT_EQ(file.available(), 995U);
  for (int i = 0; i < 100000; ++i) {
    const auto number = file.take();
    ASSERT_TRUE(number && *number < 5 + 3 + 2) << *number;
    file.drop(*number);
  }
}

TEST(NumberFile, HandsOutNumbersThatHaveNotRestedWhenThereAreNoOthers) {
  NumberFile file(4, 100);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(file.take(), i);
  file.drop(1);
  EXPECT_EQ(file.take(), 3U);
  file.drop(0);
  EXPECT_EQ(file.take(), 1U);
  EXPECT_EQ(file.take(), std::nullopt);
}

// Two tracks with one number overwrite each other; a lost number lowers the capacity for good.
TEST(NumberFile, BehavesLikeAQueueOfUnusedNumbersUnderRandomUse) {
  auto generator = seededGenerator();
  NumberFile file(17);
  std::deque<std::uint32_t> unused;
  for (std::uint32_t i = 0; i < 17; ++i) unused.push_back(i);
  std::set<std::uint32_t> used;
  for (int step = 0; step < 100000; ++step) {
    if (uniformInt(generator, 0, 1) == 0) {
      const auto number = file.take();
      ASSERT_EQ(number.has_value(), unused.size() > 1);
      if (!number) continue;
      ASSERT_EQ(*number, unused.front());
      used.insert(*number);
      unused.pop_front();
    } else if (!used.empty()) {
      const auto victim = std::next(used.begin(), uniformInt(generator, 0, static_cast<int>(used.size()) - 1));
      file.drop(*victim);
      unused.push_back(*victim);
      used.erase(victim);
    }
    ASSERT_EQ(file.available(), unused.size() - 1);
    for (std::uint32_t i = 0; i < 17; ++i) ASSERT_EQ(file.used(i), used.count(i) == 1);
  }
}

}  // namespace
}  // namespace tws
