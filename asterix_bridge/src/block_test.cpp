#include "block.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>

#include "block_test_helpers.h"

namespace asterix_bridge {
namespace {

// A report of what is wrong helps only with the place where.
TEST(Block, SaysWhereAndWhyARecordIsBadAndKeepsTheRecordsBeforeIt) {
  Octets cut = plot001();
  cut.resize(8);  // ends amid 040
  const Block block = decoded(blockOf(1, plot001() + cut), 1000);
  EXPECT_EQ(block.reports.size(), 1u);
  ASSERT_TRUE(block.fault);
  EXPECT_EQ(block.fault->offset, 1000u + 3u + 12u + 8u);
  EXPECT_EQ(block.fault->reason, "I001/070: needs 2 bytes, 0 are left");
}

TEST(Block, RefusesABlockWhoseLengthIsWrong) {
  Octets octets = blockOf(1, plot001());
  octets[2] = 200;
  EXPECT_EQ(decoded(octets, 7).fault->reason, "block of CAT1 says 200 bytes, 15 are there");
  EXPECT_EQ(decoded(octets, 7).fault->offset, 7u);
  EXPECT_TRUE(decoded({}).fault);
  EXPECT_TRUE(decoded({1, 0}).fault);
  EXPECT_EQ(decoded({1, 0, 3}).fault->reason, "a block without records");
}

TEST(Block, NamesACategoryThatIsNotDecoded) {
  const Block block = decoded(blockOf(62, {0x80, 1, 2}));
  EXPECT_TRUE(block.is_unknown);
  EXPECT_EQ(block.fault->reason, "category 62 is not decoded");
}

TEST(Block, RefusesAnItemThatDoesNotExist) {
  const Block block = decoded(blockOf(1, {0x81, 0x01, 0x40, 0x08, 0x09}));  // spare in the plot profile
  EXPECT_EQ(block.fault->reason, "no item has the field reference number 16");
}

TEST(Block, RefusesFieldSpecificationsThatDoNotEnd) {
  EXPECT_TRUE(decoded(blockOf(48, {0xFF, 0xFF, 0xFF})).fault);
  EXPECT_TRUE(decoded(blockOf(48, {0x00})).fault);
  EXPECT_EQ(decoded(blockOf(48, {0x01, 0x01, 0x01, 0x01, 0x02, 0x00})).fault->reason,
            "no item has the field reference number 35");
}

// Whatever comes over the wire, the program goes on, and good data are decoded as if nothing had been.
TEST(Block, SurvivesRandomMutations) {
  auto random = tws::seededGenerator();
  const Octets good = blockOf(1, plot001() + plot001() + plot001());
  const std::uint8_t categories[] = {1, 2, 34, 48};
  for (int round = 0; round < 20000; ++round) {
    Octets bad = good;
    bad[0] = categories[random() % 4];
    for (unsigned i = 0; i < 1 + random() % 6; ++i)
      bad[3 + random() % (bad.size() - 3)] = static_cast<std::uint8_t>(random());
    const Block block = decoded(bad, 50);
    if (block.fault) {
      ASSERT_GE(block.fault->offset, 50u);
      ASSERT_LE(block.fault->offset, 50u + bad.size());
      ASSERT_FALSE(block.fault->reason.empty());
    }
    ASSERT_LE(block.reports.size() + block.messages.size(), bad.size());
    ASSERT_EQ(decoded(good).reports.size(), 3u);
  }
}

TEST(Block, RefusesARecordCutAnywhere) {
  for (std::size_t length = 0; length < plot001().size(); ++length) {
    Octets record = plot001();
    record.resize(length);
    EXPECT_TRUE(decoded(blockOf(1, record)).fault) << length;
  }
}

}  // namespace
}  // namespace asterix_bridge
