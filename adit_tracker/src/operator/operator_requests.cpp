#include "operator/operator_requests.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

using Slot = TrackFile::Slot;

OperatorAnswer refused(const std::string& why) {
  OperatorAnswer answer;
  answer.refusal = why;
  return answer;
}

OperatorAnswer about(Slot slot) {
  OperatorAnswer answer;
  answer.count = 1;
  answer.tracks = {slot};
  return answer;
}

/// Those that fulfil the request, by number, from `start` on: as many as the page holds. Pages by number neither repeat
/// nor lose a track that moves on to another sector in between.
template <class Fulfils>
OperatorAnswer list(const Adit& adit, const OperatorRequest& request, const Fulfils& fulfils) {
  OperatorAnswer answer;
  std::vector<Slot>& tracks = answer.tracks;
  const auto number = [&](Slot slot) { return adit.tracks().at(slot).number; };
  tracks = adit.tracks().living();
  const auto out = [&](Slot slot) { return number(slot) < request.start || !fulfils(slot); };
  tracks.erase(std::remove_if(tracks.begin(), tracks.end(), out), tracks.end());
  std::sort(tracks.begin(), tracks.end(), [&](Slot a, Slot b) { return number(a) < number(b); });
  answer.count = static_cast<std::uint32_t>(tracks.size());
  const std::uint32_t page = adit.params().operators.page;
  if (page == 0 || answer.count <= page) return answer;
  tracks.resize(page);
  answer.next = number(tracks.back()) + 1;
  return answer;
}

bool isTarget(const Adit& adit, Slot slot) { return adit.tracks().at(slot).firm; }

Kinematics nowOf(const Adit& adit, Slot slot) {
  return adit.tracks().extrapolate(slot, adit.tracks().latest().enter_time).kinematics;
}

OperatorAnswer listAzimuth(const Adit& adit, const OperatorRequest& request) {
  if (!std::isfinite(request.from) || !std::isfinite(request.to))
    return refused("lower and upper must be azimuths [rad]");
  const bool all_round = request.to - request.from >= tws::kTwoPi;
  const double width = tws::wrapTwoPi(request.to - request.from);
  return list(adit, request, [&](Slot slot) {
    const double beyond = tws::wrapTwoPi(nowOf(adit, slot).azimuth - tws::wrapTwoPi(request.from));
    return isTarget(adit, slot) && (all_round || beyond <= width);
  });
}

OperatorAnswer listRange(const Adit& adit, const OperatorRequest& request) {
  const bool outside = !std::isnan(request.from), inside = !std::isnan(request.to);
  if (!outside && !inside) return refused("one of lower and upper must be a range [m]");
  if (outside && inside && request.from > request.to) return refused("lower must not be greater than upper");
  return list(adit, request, [&](Slot slot) {
    const double range = nowOf(adit, slot).range;
    return isTarget(adit, slot) && !(outside && range < request.from) && !(inside && range > request.to);
  });
}

OperatorAnswer listClosing(const Adit& adit, const OperatorRequest& request) {
  if (!std::isfinite(request.from)) return refused("lower must be a closing speed [m/s]");
  return list(adit, request,
              [&](Slot slot) { return isTarget(adit, slot) && -nowOf(adit, slot).range_rate >= request.from; });
}

/// The target within three standard deviations of the point, if there is one.
std::optional<Slot> targetAt(const Adit& adit, double x, double y) {
  const double reach = 3.0 * adit.params().operators.point_sigma;
  for (const Slot slot : adit.tracks().living()) {
    const Kinematics k = nowOf(adit, slot);
    if (isTarget(adit, slot) && std::hypot(k.x - x, k.y - y) <= reach) return slot;
  }
  return std::nullopt;
}

OperatorAnswer initiate(Adit& adit, const OperatorRequest& request) {
  const double range = std::hypot(request.x, request.y);
  if (!(range > 0.0 && range <= kFarthest)) return refused("the point must lie within 10 000 km of the radars");
  if (const auto there = targetAt(adit, request.x, request.y))
    return refused("track " + std::to_string(adit.tracks().at(*there).number) + " is there already");
  const auto slot = adit.manual().start(range, std::atan2(request.x, request.y), adit.params().operators.point_sigma);
  if (!slot) return refused("all " + std::to_string(adit.params().capacity - 1) + " track numbers are in use");
  return about(*slot);
}

OperatorAnswer dropAll(Adit& adit) {
  OperatorAnswer answer;
  answer.tracks = adit.tracks().living();
  answer.count = static_cast<std::uint32_t>(answer.tracks.size());
  for (const Slot slot : answer.tracks) adit.manual().drop(slot);
  return answer;
}

OperatorAnswer loadClutter(Adit& adit, const OperatorRequest& request) {
  const std::size_t points = request.maps.clutter.size();
  if (request.maps.empty()) return refused("there are no clutter points to load");
  OperatorAnswer answer;
  try {
    const std::size_t without_number = adit.manual().load(request.maps);
    answer.count = static_cast<std::uint32_t>(points - std::min(points, without_number));
  } catch (const std::invalid_argument& error) {
    return refused(error.what());
  }
  return answer;
}

/// Requests that name a track.
OperatorAnswer actOn(Adit& adit, Slot slot, const OperatorRequest& request) {
  if (request.action == OperatorAction::kHandOff) adit.manual().handOff(slot, !request.cancel);
  if (request.action == OperatorAction::kDesignate) adit.manual().designate(slot, !request.cancel);
  if (request.action == OperatorAction::kDrop) adit.manual().drop(slot);
  return about(slot);
}

OperatorAnswer onOne(Adit& adit, const OperatorRequest& request) {
  const auto slot = adit.tracks().find(request.track);
  if (!slot) return refused("there is no track " + std::to_string(request.track));
  return actOn(adit, *slot, request);
}

}  // namespace

OperatorAnswer execute(Adit& adit, const OperatorRequest& request) {
  const auto target = [&](Slot slot) { return isTarget(adit, slot); };
  switch (request.action) {
    case OperatorAction::kHandOff:
    case OperatorAction::kParameters:
    case OperatorAction::kDesignate:
    case OperatorAction::kDrop:
      return onOne(adit, request);
    case OperatorAction::kListAzimuth:
      return listAzimuth(adit, request);
    case OperatorAction::kListRange:
      return listRange(adit, request);
    case OperatorAction::kListAll:
      return list(adit, request, target);
    case OperatorAction::kListTentative:
      return list(adit, request, [&](Slot slot) { return !isTarget(adit, slot); });
    case OperatorAction::kListClosing:
      return listClosing(adit, request);
    case OperatorAction::kListElevation:
      return list(adit, request, [&](Slot slot) { return adit.tracks().at(slot).designated; });
    case OperatorAction::kInitiate:
      return initiate(adit, request);
    case OperatorAction::kDropAll:
      return dropAll(adit);
    case OperatorAction::kLoadClutter:
      return loadClutter(adit, request);
  }
  return refused("request " + std::to_string(static_cast<int>(request.action)) + " is unknown");
}

}  // namespace adit_tracker
