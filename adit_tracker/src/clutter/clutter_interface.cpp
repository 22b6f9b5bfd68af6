#include "clutter/clutter_interface.h"

#include <tws_runtime/parameters.h>

#include <stdexcept>

#include "clutter/clutter_csv.h"
#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

using Message = tws_msgs::OperatorRequest;

std::vector<ClutterPlace> readStart(const std::string& node, const std::string& file, const ClutterLimits& limits) {
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
  if (at_start_.empty()) return;
  Message message = operators_.blank(Message::LOAD_CLUTTER);
  message.clutter = clutterPoints(at_start_);
  operators_.askAtStart(message);
}

bool ClutterInterface::save(const tws_msgs::SaveClutterMap::Request& request,
                            tws_msgs::SaveClutterMap::Response& response) {
  try {
    const Adit* const adit = adit_();
    if (adit == nullptr) throw std::runtime_error("no sector has been processed yet");
    const std::vector<ClutterPlace> places = adit->clutter().places();
    folder_.save(request.path, places);
    response.count = static_cast<std::uint32_t>(places.size());
    response.message = std::to_string(places.size()) + " points saved to " + folder_.pathOf(request.path);
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

bool ClutterInterface::load(const tws_msgs::LoadClutterMap::Request& request,
                            tws_msgs::LoadClutterMap::Response& response) {
  Message message = operators_.blank(Message::LOAD_CLUTTER);
  std::string problem;
  try {
    message.clutter = clutterPoints(folder_.load(request.path, limits_));
  } catch (const std::exception& error) {
    problem = error.what();
  }
  message = operators_.ask(message, problem).message;
  response.success = message.result == Message::OK;
  response.count = message.count;
  response.message = message.message;
  if (!response.success) return true;
  response.message = std::to_string(message.count) + " points loaded from " + folder_.pathOf(request.path);
  if (message.count < message.clutter.size()) response.message += "; the others got no clutter number, all are in use";
  return true;
}

}  // namespace adit_tracker
