#include "label_placement.h"

#include <algorithm>
#include <cmath>

namespace tws_rviz {
namespace {

// More labels than this cannot be read anyway, and to compare all with all would take long.
constexpr std::size_t kMostPlaced = 800;

// Half the side of the square that a symbol takes, as a share of the gap; less than the root of 1/2, so that a label on
// a slanting side is clear of its own symbol.
constexpr double kSymbolShare = 0.7;

struct Box {
  Eigen::Vector2d centre;
  Eigen::Vector2d size;
};

double overlap(const Box& a, const Box& b) {
  const Eigen::Vector2d depth = 0.5 * (a.size + b.size) - (a.centre - b.centre).cwiseAbs();
  return depth.x() > 0.0 && depth.y() > 0.0 ? depth.x() * depth.y() : 0.0;
}

double covered(const Box& box, const std::vector<Box>& others) {
  double area = 0.0;
  for (const Box& other : others) area += overlap(box, other);
  return area;
}

std::vector<Box> symbolBoxes(const std::vector<LabelRequest>& requests) {
  std::vector<Box> boxes;
  boxes.reserve(2 * requests.size());  // the labels' boxes follow
  for (const LabelRequest& request : requests)
    boxes.push_back({request.symbol, Eigen::Vector2d::Constant(2.0 * kSymbolShare * request.gap)});
  return boxes;
}

int bestSide(const LabelRequest& request, const std::vector<Box>& taken) {
  int best = request.side;
  double least = covered({labelCentre(request, best), request.size}, taken);
  for (int i = 1; i < kLabelSides && least > 0.0; ++i) {
    const int side = (request.side + i) % kLabelSides;
    const double area = covered({labelCentre(request, side), request.size}, taken);
    if (area < least) {
      least = area;
      best = side;
    }
  }
  return best;
}

}  // namespace

Eigen::Vector2d labelCentre(const LabelRequest& request, int side) {
  // East and north of the eight sides, from the right on clockwise.
  static constexpr int kEast[kLabelSides] = {1, 1, 0, -1, -1, -1, 0, 1};
  static constexpr int kNorth[kLabelSides] = {0, -1, -1, -1, 0, 1, 1, 1};
  // On the slanting sides the block's corner is as far from the symbol as its edge is on the straight ones.
  const double share = kEast[side] != 0 && kNorth[side] != 0 ? std::sqrt(0.5) : 1.0;
  const Eigen::Vector2d away = Eigen::Vector2d::Constant(share * request.gap) + 0.5 * request.size;
  return request.symbol + Eigen::Vector2d(kEast[side] * away.x(), kNorth[side] * away.y());
}

std::vector<int> placeLabels(const std::vector<LabelRequest>& requests) {
  std::vector<Box> taken = symbolBoxes(requests);
  std::vector<int> sides;
  for (const LabelRequest& request : requests) {
    if (requests.size() > kMostPlaced) {
      sides.push_back(request.side);
      continue;
    }
    sides.push_back(bestSide(request, taken));
    taken.push_back({labelCentre(request, sides.back()), request.size});
  }
  return sides;
}

}  // namespace tws_rviz
