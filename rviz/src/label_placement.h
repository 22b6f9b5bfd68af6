#pragma once

#include <Eigen/Core>
#include <vector>

namespace tws_rviz {

/// A label that wants a place beside its symbol.
struct LabelRequest {
  Eigen::Vector2d symbol;  // [m]
  Eigen::Vector2d size;    // of the text block: width, height [m]
  double gap = 0.0;        // between the symbol's middle and the block [m]
  int side = 0;            // where it stands now, or would like to: 0 right, then clockwise in steps of 45°
};

constexpr int kLabelSides = 8;

/// The middle of the block of text when it stands on `side` of its symbol [m].
Eigen::Vector2d labelCentre(const LabelRequest& request, int side);

/// The sides on which the labels stand, one for each request: each in turn takes the side where it covers the least of
/// symbols and of the labels before it, its own side when no other is better. Labels therefore move only when they
/// must. Of more than 800 labels each stays on its own side.
std::vector<int> placeLabels(const std::vector<LabelRequest>& requests);

}  // namespace tws_rviz
