#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tws {

/// Merges several clocked streams into one sequence by (time, stream), whatever the order in which the streams' items
/// arrive.
///
/// Within a stream, times do not go back. An item is released once every other stream has passed its time, or once some
/// stream has come more than `limit` past it: a silent stream, also one that never came, holds the rest up no longer
/// than that. The sequence is the same in every run as long as streams arrive less than `limit` out of step; what comes
/// too late for that is counted and refused, so that late() == 0 says the sequence can be trusted. One outlier in the
/// future would make all that follows late: the caller checks stamps first.
template <class T>
class TimeOrder {
 public:
  struct Item {
    std::size_t stream;
    double time;  // [s]
    T value;
  };

  /// limit in data time [s]. Throws std::invalid_argument when there is no stream or the limit is negative or NaN.
  explicit TimeOrder(std::size_t streams, double limit = 1.0)
      : queues_(streams), latest_(streams, kNever), limit_(limit) {
    if (streams == 0) throw std::invalid_argument("TimeOrder: there must be at least one stream");
    if (!(limit >= 0.0)) throw std::invalid_argument("TimeOrder: the limit must be a time of at least 0 s");
  }

  /// Queues the item. One that is late, since it sorts before one already released or before one of its own stream, is
  /// counted, and its value handed back, for the caller to use or to drop. Throws std::invalid_argument for an unknown
  /// stream or a time that is not finite.
  std::optional<T> push(std::size_t stream, double time, T value) {
    checkInput(stream, time);
    const bool late = time < latest_[stream] || std::make_pair(time, stream) < released_;
    note(stream, time);
    if (late) {
      ++late_;
      return std::optional<T>(std::move(value));
    }
    queues_[stream].push_back({stream, time, std::move(value)});
    ++size_;
    return std::nullopt;
  }

  /// The stream has come to this time without an item; its next one may still have this very time. An earlier time than
  /// already noted changes nothing. Throws as push().
  void advance(std::size_t stream, double time) {
    checkInput(stream, time);
    note(stream, time);
  }

  /// The next item that may be released; nothing: wait for more input.
  std::optional<Item> pop() {
    if (size_ == 0) return std::nullopt;
    const std::size_t stream = earliest();
    if (!releasable(queues_[stream].front())) return std::nullopt;
    std::optional<Item> item(std::move(queues_[stream].front()));
    queues_[stream].pop_front();
    --size_;
    released_ = {item->time, stream};
    return item;
  }

  /// Releases all that came so far: pop() then gives every queued item, in order.
  void flush() { flushed_ = newest_; }

  /// A new run: forgets all, also the queued items and the count of late ones.
  void reset() { *this = TimeOrder(queues_.size(), limit_); }

  /// Items refused as late since the start or the last reset.
  std::uint64_t late() const { return late_; }
  /// Items queued.
  std::size_t size() const { return size_; }
  std::size_t streams() const { return queues_.size(); }
  /// Newest time of any stream [s]; -infinity when none was.
  double newest() const { return newest_; }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  void checkInput(std::size_t stream, double time) const {
    if (stream >= queues_.size()) throw std::invalid_argument("TimeOrder: no stream " + std::to_string(stream));
    if (!std::isfinite(time))
      throw std::invalid_argument("TimeOrder: time not finite on stream " + std::to_string(stream));
  }

  void note(std::size_t stream, double time) {
    latest_[stream] = std::max(latest_[stream], time);
    newest_ = std::max(newest_, time);
  }

  // The stream whose first item sorts first; the lower stream wins equal times.
  std::size_t earliest() const {
    std::size_t best = queues_.size();
    for (std::size_t i = 0; i < queues_.size(); ++i) {
      if (queues_[i].empty()) continue;
      if (best == queues_.size() || queues_[i].front().time < queues_[best].front().time) best = i;
    }
    return best;
  }

  // The item is the earliest of all queued ones, so only streams without a queued item can still send something before
  // it.
  bool releasable(const Item& item) const {
    if (item.time < newest_ - limit_ || item.time <= flushed_) return true;
    for (std::size_t i = 0; i < queues_.size(); ++i) {
      const bool passed = latest_[i] > item.time || (latest_[i] == item.time && i >= item.stream);
      if (!passed) return false;
    }
    return true;
  }

  std::vector<std::deque<Item>> queues_;
  std::vector<double> latest_;
  double limit_;
  double newest_ = kNever;
  double flushed_ = kNever;
  std::pair<double, std::size_t> released_{kNever, 0};
  std::size_t size_ = 0;
  std::uint64_t late_ = 0;
};

}  // namespace tws
