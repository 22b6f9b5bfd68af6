#include "ppi_params.h"

namespace tws_rviz {
namespace {

using tws_runtime::ParameterReader;

const std::vector<Rgba> kPalette = {
    {0.25f, 1.0f, 0.35f, 1.0f}, {0.25f, 0.75f, 1.0f, 1.0f}, {1.0f, 0.45f, 0.85f, 1.0f}, {0.65f, 0.65f, 1.0f, 1.0f}};

void readColor(ParameterReader& reader, Rgba& color) {
  std::vector<double> rgb{color.r, color.g, color.b};
  reader.numbers("color", rgb, 0.0, 1.0);
  if (rgb.size() != 3) reader.fail("color", "expected three numbers: red, green, blue");
  color = {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]), 1.0f};
}

RadarParams defaultRadar(const std::string& name, std::size_t place) {
  return {name, name + "/detections", name + "/sector_marks", kPalette[place % kPalette.size()], name + "/plots"};
}

RadarParams readRadar(ParameterReader& reader, std::size_t place) {
  std::string name;
  reader.require("name");
  reader.text("name", name);
  RadarParams radar = defaultRadar(name, place);
  reader.text("detections", radar.detections);
  reader.text("sector_marks", radar.sector_marks);
  reader.text("plots", radar.plots);
  readColor(reader, radar.color);
  reader.done();
  return radar;
}

TrackerParams readTracker(ParameterReader& reader) {
  TrackerParams tracker;
  reader.require("topic");
  reader.text("topic", tracker.topic);
  tracker.name = tracker.topic;
  reader.text("name", tracker.name);
  reader.text("prefix", tracker.prefix);
  reader.flag("symbols_only", tracker.symbols_only);
  reader.done();
  return tracker;
}

CorrelatorParams readCorrelator(ParameterReader& reader) {
  CorrelatorParams correlator;
  reader.require("topic");
  reader.text("topic", correlator.topic);
  correlator.name = correlator.topic;
  reader.text("name", correlator.name);
  reader.texts("covers", correlator.covers);
  reader.done();
  return correlator;
}

void readLists(ParameterReader& reader, PpiParams& params) {
  for (ParameterReader& radar : reader.list("radars")) params.radars.push_back(readRadar(radar, params.radars.size()));
  for (ParameterReader& tracker : reader.list("trackers")) params.trackers.push_back(readTracker(tracker));
  for (ParameterReader& one : reader.list("correlators")) params.correlators.push_back(readCorrelator(one));
  if (!reader.has("correlators")) params.correlators.push_back({"correlated", "correlated/tracks", {"adit/tracks"}});
  if (!reader.has("radars"))
    for (const char* name : {"sps12", "sps39", "sps10"})
      params.radars.push_back(defaultRadar(name, params.radars.size()));
  if (!reader.has("trackers"))
    params.trackers = {{"adit", "adit/tracks", "", false}, {"esa", "esa/tracks", "E", false}};
}

void readPicture(ParameterReader& reader, PpiParams& params) {
  double afterglow_deg = tws::degrees(params.afterglow);
  reader.text("frame", params.frame);
  reader.number("picture_range", params.picture_range, 1000.0, 2e6);
  reader.number("ring_spacing", params.ring_spacing, 0.0, 2e6);
  reader.number("text_scale", params.text_scale, 0.2, 5.0);
  reader.number("redraw_rate", params.redraw_rate, 1.0, 60.0);
  reader.number("track_rate", params.track_rate, 0.2, 60.0);
  reader.number("afterglow_deg", afterglow_deg, 1.0, 360.0);
  reader.number("persistence_scans", params.persistence_scans, 0.1, 100.0);
  params.afterglow = tws::radians(afterglow_deg);
  if (params.ring_spacing != 0.0 && params.ring_spacing < params.picture_range / 50.0)
    reader.fail("ring_spacing", "more than 50 rings; expected 0 or at least a fiftieth of picture_range");
}

}  // namespace

PpiParams loadPpiParams(ParameterReader reader) {
  PpiParams params;
  readPicture(reader, params);
  reader.number("leader_time", params.tracks.leader_time, 0.0, 3600.0);
  reader.number("trail_time", params.tracks.trail_time, 0.0, 36000.0);
  reader.number("track_timeout", params.tracks.timeout, 1.0, 36000.0);
  reader.text("clutter_topic", params.clutter_topic);
  reader.text("maps_topic", params.maps_topic);
  reader.text("registration_topic", params.registration_topic);
  reader.flag("legend", params.legend);
  reader.flag("truth", params.truth);
  reader.text("truth_topic", params.truth_topic);
  readLists(reader, params);
  reader.done();
  return params;
}

}  // namespace tws_rviz
