#include <tws_core/time_order.h>

#include <gtest/gtest.h>

#include <memory>
#include <tuple>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

using Order = TimeOrder<int>;
using Entry = std::tuple<double, std::size_t, int>;  // time, stream, number

void drain(Order& order, std::vector<Entry>& out) {
  while (auto item = order.pop()) out.emplace_back(item->time, item->stream, item->value);
}

std::vector<int> values(Order& order) {
  std::vector<int> out;
  while (auto item = order.pop()) out.push_back(item->value);
  return out;
}

using Values = std::vector<int>;

TEST(TimeOrder, HoldsAnItemUntilEveryOtherStreamHasPassedItsTime) {
  Order order(3);
  order.push(0, 10.0, 100);
  EXPECT_EQ(order.pop(), std::nullopt);
  order.push(1, 10.1, 101);
  EXPECT_EQ(order.pop(), std::nullopt);
  order.push(2, 10.2, 102);
  EXPECT_EQ(values(order), (Values{100}));
  order.advance(0, 10.15);  // a heartbeat is enough
  EXPECT_EQ(values(order), (Values{101}));
  EXPECT_EQ(order.size(), 1U);
}

TEST(TimeOrder, PutsEqualTimesInOrderOfTheirStreams) {
  Order order(2);
  order.push(1, 5.0, 1);
  EXPECT_EQ(order.pop(), std::nullopt);  // stream 0 may still send one of 5.0, which goes first
  order.push(0, 5.0, 0);
  EXPECT_EQ(values(order), (Values{0}));  // and one more
  order.push(0, 5.0, 2);
  order.advance(0, 5.001);
  EXPECT_EQ(values(order), (Values{2, 1}));
}

TEST(TimeOrder, ReleasesAtAnEqualTimeOnceOnlyHigherStreamsCanFollow) {
  Order order(2);
  order.push(0, 5.0, 0);
  order.advance(1, 5.0);
  EXPECT_EQ(values(order), (Values{0}));
}

// Otherwise one dead radar would freeze the whole picture.
TEST(TimeOrder, DoesNotWaitLongerThanTheLimitForASilentStream) {
  Order order(2, 1.0);
  order.push(0, 10.0, 1);  // stream 1 never speaks
  order.push(0, 11.0, 2);
  EXPECT_EQ(order.pop(), std::nullopt);  // exactly the limit is not more than the limit
  order.advance(0, 11.001);
  EXPECT_EQ(values(order), (Values{1}));
  order.push(0, 13.0, 3);
  EXPECT_EQ(values(order), (Values{2}));
}

TEST(TimeOrder, CountsAndReturnsALateItemInsteadOfReleasingItOutOfOrder) {
  TimeOrder<std::unique_ptr<int>> order(2, 1.0);
  order.push(0, 10.0, std::make_unique<int>(1));
  order.advance(0, 12.0);
  ASSERT_TRUE(order.pop());
  const auto late = order.push(1, 9.0, std::make_unique<int>(2));
  ASSERT_TRUE(late && *late);
  EXPECT_EQ(**late, 2);
  EXPECT_EQ(order.late(), 1U);
  EXPECT_EQ(order.size(), 0U);
  EXPECT_FALSE(order.push(1, 10.0, std::make_unique<int>(3)));  // sorts after (10.0, 0)
}

// Whether it is late must not hang on how fast the others came.
TEST(TimeOrder, CallsAnItemLateThatGoesBackWithinItsOwnStream) {
  Order order(2);
  order.push(0, 10.0, 1);
  EXPECT_EQ(order.push(0, 9.9, 2), 2);
  order.advance(1, 20.0);
  EXPECT_EQ(order.push(1, 19.9, 3), 3);
  EXPECT_EQ(order.late(), 2U);
}

TEST(TimeOrder, TakesAHeartbeatOfAnEarlierTimeForNothingNew) {
  Order order(2);
  order.advance(1, 10.0);
  order.advance(1, 3.0);
  order.push(0, 9.0, 1);
  EXPECT_EQ(values(order), (Values{1}));
}

TEST(TimeOrder, FlushReleasesAllInOrder) {
  Order order(3);
  order.push(2, 1.0, 3);
  order.push(0, 1.5, 4);
  order.push(1, 0.5, 1);
  order.push(1, 1.0, 2);
  order.flush();
  EXPECT_EQ(values(order), (Values{1, 2, 3, 4}));
  order.push(0, 1.6, 5);
  EXPECT_EQ(order.pop(), std::nullopt);  // what came after the flush waits again
}

TEST(TimeOrder, StartsAfreshAfterAReset) {
  Order order(2, 0.5);
  order.push(0, 100.0, 1);
  order.push(0, 101.0, 2);
  EXPECT_EQ(values(order), (Values{1}));
  order.push(0, 50.0, 3);
  order.reset();
  EXPECT_EQ(order.size(), 0U);
  EXPECT_EQ(order.late(), 0U);
  EXPECT_FALSE(order.push(1, 7.0, 4));
  order.push(1, 7.6, 5);  // the limit is still half a second
  EXPECT_EQ(values(order), (Values{4}));
}

TEST(TimeOrder, RefusesUnknownStreamsAndTimesThatAreNone) {
  Order order(2);
  EXPECT_THROW(order.push(2, 1.0, 0), std::invalid_argument);
  EXPECT_THROW(order.advance(2, 1.0), std::invalid_argument);
  EXPECT_THROW(order.push(0, std::nan(""), 0), std::invalid_argument);
  EXPECT_THROW(order.advance(0, HUGE_VAL), std::invalid_argument);
  EXPECT_THROW(Order(0), std::invalid_argument);
  EXPECT_THROW(Order(1, -1.0), std::invalid_argument);
  EXPECT_THROW(Order(1, std::nan("")), std::invalid_argument);
}

struct Arrival {
  double arrives;
  double time;
  std::size_t stream;
  int number;  // -1: a heartbeat
};

// A stream of items and heartbeats a tenth of a second apart or none, so that times often coincide.
std::vector<Arrival> makeStream(std::mt19937_64& generator, std::size_t stream, int& numbers) {
  std::vector<Arrival> arrivals;
  double time = uniformInt(generator, 0, 30) * 0.1;
  const bool falls_silent = uniformInt(generator, 0, 3) == 0;
  for (int i = 0; i < (falls_silent ? 20 : 60); ++i) {
    arrivals.push_back({0.0, time, stream, uniformInt(generator, 0, 4) == 0 ? -1 : numbers++});
    time += uniformInt(generator, 0, uniformInt(generator, 0, 9) == 0 ? 25 : 3) * 0.1;
  }
  return arrivals;
}

// Delays every arrival by up to `skew`; what one stream sends still arrives in order.
void delay(std::mt19937_64& generator, std::vector<Arrival>& arrivals, double skew, std::size_t streams) {
  std::vector<double> last(streams, 0.0);
  for (Arrival& arrival : arrivals) {
    double& after = last[arrival.stream];
    after = arrival.arrives = std::max(after, arrival.time + uniform(generator, 0.0, skew));
  }
  std::stable_sort(arrivals.begin(), arrivals.end(),
                   [](const Arrival& a, const Arrival& b) { return a.arrives < b.arrives; });
}

void feed(Order& order, const Arrival& arrival) {
  if (arrival.number < 0) {
    order.advance(arrival.stream, arrival.time);
  } else {
    order.push(arrival.stream, arrival.time, arrival.number);
  }
}

// The promise that tracks come out the same live, replayed and offline rests on this.
TEST(TimeOrder, GivesTheSameSortedSequenceForEveryInterleavingWithinTheLimit) {
  auto generator = seededGenerator();
  for (int trial = 0; trial < 200; ++trial) {
    const auto streams = static_cast<std::size_t>(uniformInt(generator, 1, 5));
    std::vector<Arrival> sent;
    std::vector<Entry> expected;
    int numbers = 0;
    for (std::size_t stream = 0; stream < streams; ++stream) {
      for (const Arrival& arrival : makeStream(generator, stream, numbers)) sent.push_back(arrival);
    }
    for (const Arrival& a : sent) {
      if (a.number >= 0) expected.emplace_back(a.time, a.stream, a.number);
    }
    std::sort(expected.begin(), expected.end());  // numbers rise within a stream
    for (int interleaving = 0; interleaving < 10; ++interleaving) {
      std::vector<Arrival> arrivals = sent;
      delay(generator, arrivals, 0.99, streams);
      Order order(streams + (interleaving % 2), 1.0);  // in half of them one stream never speaks
      std::vector<Entry> out;
      for (const Arrival& arrival : arrivals) {
        feed(order, arrival);
        if (uniformInt(generator, 0, 2) > 0) drain(order, out);
      }
      order.flush();
      drain(order, out);
      ASSERT_EQ(order.late(), 0U) << "trial " << trial;
      ASSERT_EQ(out, expected) << "trial " << trial;
    }
  }
}

TEST(TimeOrder, StaysInOrderAndLosesNothingWhenArrivalsAreFarOutOfStep) {
  auto generator = seededGenerator();
  std::uint64_t late = 0;
  for (int trial = 0; trial < 200; ++trial) {
    int numbers = 0;
    std::vector<Arrival> arrivals;
    for (std::size_t stream = 0; stream < 3; ++stream) {
      for (const Arrival& arrival : makeStream(generator, stream, numbers)) arrivals.push_back(arrival);
    }
    delay(generator, arrivals, 6.0, 3);
    Order order(3, 1.0);
    std::vector<Entry> out;
    for (const Arrival& arrival : arrivals) {
      feed(order, arrival);
      drain(order, out);
    }
    order.flush();
    drain(order, out);
    ASSERT_TRUE(std::is_sorted(out.begin(), out.end()));
    ASSERT_EQ(out.size() + order.late(), static_cast<std::size_t>(numbers));
    late += order.late();
  }
  EXPECT_GT(late, 0U) << "the test never went beyond the limit";
}

}  // namespace
}  // namespace tws
