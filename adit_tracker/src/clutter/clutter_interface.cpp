#include "clutter/clutter_interface.h"

#include <tws_runtime/parameters.h>

#include <stdexcept>

#include "clutter/clutter_csv.h"
#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

SavedMaps readStart(const std::string& node, const std::string& file, const ClutterLimits& limits) {
  if (file.empty()) return {};
  try {
    return loadClutterFile(file, limits);
  } catch (const std::runtime_error& error) {
    throw tws_runtime::ParameterError(node + ": clutter_map: " + error.what());
  }
}

}  // namespace

ClutterInterface::ClutterInterface(tws_runtime::Bus& bus, OperatorInterface& operators, const AditParams& params,
                                   const ClutterFiles& files, std::function<const Adit*()> adit)
    : operators_(operators),
      limits_(params),
      folder_(files.folder),
      adit_(std::move(adit)),
      at_start_(readStart(bus.name(), files.at_start, limits_)) {
  bus.serve<tws_msgs::SaveClutterMap>("~save_clutter_map",
                                      [this](auto& request, auto& response) { return save(request, response); });
  bus.serve<tws_msgs::LoadClutterMap>("~load_clutter_map",
                                      [this](auto& request, auto& response) { return load(request, response); });
}

void ClutterInterface::beginRun() {
  if (!at_start_.empty()) operators_.askAtStart(loadMessage(at_start_));
}

ClutterInterface::Message ClutterInterface::loadMessage(const SavedMaps& maps) const {
  Message message = operators_.blank(Message::LOAD_CLUTTER);
  setMaps(message, maps);
  return message;
}

bool ClutterInterface::save(const tws_msgs::SaveClutterMap::Request& request,
                            tws_msgs::SaveClutterMap::Response& response) {
  try {
    const Adit* const adit = adit_();
    if (adit == nullptr) throw std::runtime_error("no sector has been processed yet");
    const SavedMaps maps = adit->maps();
    folder_.save(request.path, maps);
    response.count = static_cast<std::uint32_t>(maps.clutter.size());
    response.message = inWords(maps, maps.clutter.size()) + " saved to " + folder_.pathOf(request.path);
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

bool ClutterInterface::load(const tws_msgs::LoadClutterMap::Request& request,
                            tws_msgs::LoadClutterMap::Response& response) {
  SavedMaps maps;
  std::string problem;
  try {
    maps = folder_.load(request.path, limits_);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  const Message message = operators_.ask(loadMessage(maps), problem).message;
  response.success = message.result == Message::OK;
  response.count = message.count;
  response.message = message.message;
  if (!response.success) return true;
  response.message = inWords(maps, message.count) + " loaded from " + folder_.pathOf(request.path);
  if (message.count < message.clutter.size()) response.message += "; the others got no clutter number, all are in use";
  return true;
}

}  // namespace adit_tracker
