#pragma once

namespace adit_tracker {

/// Share of the new targets that are much faster than the rest: what is assumed, until the tracks that have become firm
/// tell of more. It follows the last few hundred of them.
class FastShare {
 public:
  explicit FastShare(double assumed) : assumed_(assumed), fast_(assumed * kAssumed) {}

  /// A track has become firm.
  void add(bool fast);

  /// Never less than assumed, as the first fast one comes unannounced; at most 0.5: the usual target is never ruled
  /// out.
  double value() const;

 private:
  static constexpr double kAssumed = 20.0;  // So many tracks weigh as much as what is assumed.

  double assumed_, fast_, all_ = kAssumed;
};

}  // namespace adit_tracker
