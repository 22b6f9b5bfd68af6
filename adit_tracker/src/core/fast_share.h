#pragma once

namespace adit_tracker {

/// Share of the new targets that are much faster than the rest: what is assumed, until the tracks that have become firm
/// tell. It follows the last few hundred of them.
class FastShare {
 public:
  explicit FastShare(double assumed) : fast_(assumed * kAssumed) {}

  /// A track has become firm.
  void add(bool fast);

  /// (0, 0.5]: the usual target is never ruled out.
  double value() const;

 private:
  static constexpr double kAssumed = 20.0;  // So many tracks weigh as much as what is assumed.

  double fast_, all_ = kAssumed;
};

}  // namespace adit_tracker
