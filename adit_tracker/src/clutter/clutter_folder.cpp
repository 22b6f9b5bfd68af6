#include "clutter/clutter_folder.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>

#include "clutter/clutter_csv.h"

namespace adit_tracker {
namespace {

namespace fs = std::filesystem;

std::string usualFolder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  const std::string ros = variable("ROS_HOME");
  return (ros.empty() ? variable("HOME") + "/.ros" : ros) + "/clutter_maps";
}

bool isName(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest && text.front() != '.' &&
         std::none_of(text.begin(), text.end(), [](unsigned char c) { return c == '/' || c < ' ' || c == 127; });
}

/// What a caller can do again and again must not fill the disk.
void checkCount(const fs::path& folder, const fs::path& path) {
  if (fs::exists(path)) return;
  const auto files = std::distance(fs::directory_iterator(folder), fs::directory_iterator());
  if (static_cast<std::size_t>(files) >= ClutterFolder::kMostFiles)
    throw std::runtime_error(folder.string() + ": holds " + std::to_string(files) + " files: remove some");
}

}  // namespace

ClutterFolder::ClutterFolder(const std::string& folder)
    : folder_(fs::absolute(folder.empty() ? usualFolder() : folder).string()), at_work_(std::make_shared<char>()) {}

std::string ClutterFolder::pathOf(const std::string& name) const {
  if (name.empty()) throw std::runtime_error("path is empty");
  if (!isName(name))
    throw std::runtime_error("path must be the name of a file in " + folder_ +
                             " (parameter clutter_map_folder), without / and not beginning with a dot");
  return (fs::path(folder_) / name).string();
}

SavedMaps ClutterFolder::load(const std::string& name, const ClutterLimits& limits) {
  const auto maps = std::make_shared<SavedMaps>();
  within([path = pathOf(name), limits, maps] {
    if (fs::is_symlink(path)) throw std::runtime_error(path + ": cannot be read: it is no regular file");
    *maps = loadClutterFile(path, limits);
  });
  return *maps;
}

void ClutterFolder::save(const std::string& name, const SavedMaps& maps) {
  within([folder = folder_, path = pathOf(name), maps] {
    fs::create_directories(folder);
    checkCount(folder, path);
    saveClutterFile(path, maps);
  });
}

void ClutterFolder::within(std::function<void()> work) {
  const std::string silent =
      folder_ + ": the disk has not answered for " + std::to_string(kTimeLimit).substr(0, 3) + " s";
  if (at_work_.use_count() > 1) throw std::runtime_error(silent + ", and earlier work is not done");
  std::packaged_task<void()> task([work = std::move(work), token = at_work_]() mutable {
    const auto until_done = std::move(token);
    work();
  });
  std::future<void> done = task.get_future();
  std::thread(std::move(task)).detach();
  if (done.wait_for(std::chrono::duration<double>(kTimeLimit)) != std::future_status::ready)
    throw std::runtime_error(silent);
  done.get();
}

}  // namespace adit_tracker
