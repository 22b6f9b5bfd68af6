#include <tws_runtime/site_gate.h>

#include <tws_runtime/sites.h>

namespace tws_runtime {

void SiteGate::wait(Item item) {
  waiting_.push_back(std::move(item));
  const bool patient = waiting_.size() <= most_waiting_;
  for (const Item& each : waiting_)
    if (!find(each.radar, each.radar_frame, patient)) return;
  std::deque<Item> ready;
  ready.swap(waiting_);
  for (const Item& each : ready) each.use();
}

bool SiteGate::find(std::size_t radar, const std::string& radar_frame) { return find(radar, radar_frame, true); }

bool SiteGate::find(std::size_t radar, const std::string& radar_frame, bool patient) {
  Radar& own = radars_[radar];
  if (own.decided) return true;
  std::string why;
  own.site = findSite(bus_.transforms(), frame_, radar_frame, why);
  if (own.site) own.pose = findPose(bus_.transforms(), frame_, radar_frame, why);
  if (!own.site && !patient)
    bus_.counter("unknown sites").add("no transform from " + radar_frame + " to " + frame_ + ": " + why);
  return own.decided = own.site || !patient;
}

}  // namespace tws_runtime
