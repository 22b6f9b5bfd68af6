#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace asterix_bridge {

/// Data time of a live feed, going on with this machine's clock between its data: how far the data lead that clock at
/// most, by the last minute or two. Several datagrams must agree: a single one from another time moves nothing.
class FeedTime {
 public:
  /// A datagram with data of a time came at a time of this machine's clock [s since 1970].
  void add(double data, double wall);
  /// The feed's time at a time of this machine's clock [s]. Something must have been added.
  double at(double wall) const;
  /// How far behind the feed's time data come [s], 0 .. 60: by the last minute or two, and by several datagrams.
  double delay() const;

 private:
  static constexpr std::size_t kConfirmed = 4;
  // The greatest leads (or delays) of a minute, the greatest first.
  struct Leads {
    std::array<double, kConfirmed> greatest;
    std::size_t count = 0;
    void add(double lead);
    // As many say at least that; of fewer datagrams, all do.
    double confirmed() const;
  };

  Leads leads_, last_leads_;
  Leads delays_, last_delays_;
  double since_ = -std::numeric_limits<double>::infinity();  // this minute began [s]
  std::size_t behind_ = 0;                                   // datagrams in a row from another run
};

}  // namespace asterix_bridge
