#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

namespace tws_launch {

/// How many tracks of one tracker there were, and in which state those are that live (tws_msgs/Track's states). It
/// holds living tracks only, so that a run of days needs no more memory than one of minutes.
class TrackCensus {
 public:
  void add(std::uint32_t uid, std::uint8_t state);
  /// The tracker begins anew, and its numbers too: all that lived have ended.
  void beginNewRun();

  std::size_t begun() const { return ended_ + living_.size(); }
  std::size_t everFirm() const { return ever_firm_; }
  std::size_t ended() const { return ended_; }
  std::size_t living() const { return living_.size(); }
  /// Those that live, in this state.
  std::size_t count(std::uint8_t state) const;

 private:
  struct Living {
    std::uint8_t state = 0;
    bool was_firm = false;
  };
  std::map<std::uint32_t, Living> living_;
  std::size_t ended_ = 0;
  std::size_t ever_firm_ = 0;
};

}  // namespace tws_launch
