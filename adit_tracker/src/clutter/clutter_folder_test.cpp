#include "clutter/clutter_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <tws_core/temporary_folder_test_helpers.h>

namespace adit_tracker {
namespace {

namespace fs = std::filesystem;

class ClutterFolderTest : public testing::Test {
 protected:
  static ClutterLimits limits() {
    AditParams params;
    params.radars.resize(1);
    params.radars[0].name = "r1";
    return ClutterLimits(params);
  }
  static std::string complaint(const std::function<void()>& work) {
    try {
      work();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const tws::TemporaryFolder temporary_;
  const fs::path root_ = temporary_.path();
  const fs::path maps_ = root_ / "maps";
  ClutterFolder folder_{maps_};
  const SavedMaps maps_to_save_{{{"", 1000.0, 0.0}}, {}};
};

TEST_F(ClutterFolderTest, WhatIsSavedIsLoadedAndTheFolderIsMade) {
  folder_.save("the harbour's, März.csv", maps_to_save_);
  EXPECT_EQ(folder_.load("the harbour's, März.csv", limits()).clutter, maps_to_save_.clutter);
  EXPECT_EQ(folder_.pathOf("a"), (maps_ / "a").string());
}

// If this fails, whoever reaches the tracker's port overwrites any file that the tracker may write, or reads one.
TEST_F(ClutterFolderTest, NoNameLeadsOutOfTheFolder) {
  std::ofstream(root_ / "secret") << "secret";
  for (const std::string name : {"../secret", "/etc/passwd", "a/../../secret", ".", "..", ".hidden", "a\nb"}) {
    EXPECT_NE(complaint([&] { folder_.save(name, maps_to_save_); }).find("path must be the name of a file in"),
              std::string::npos)
        << name;
    EXPECT_NE(complaint([&] { folder_.load(name, limits()); }), "") << name;
  }
  EXPECT_EQ(complaint([&] { folder_.save("", maps_to_save_); }), "path is empty");
  EXPECT_EQ(fs::file_size(root_ / "secret"), 6U);
}

// If this fails, a link in the folder leads out of it, or a pipe holds up the tracker for good.
TEST_F(ClutterFolderTest, LinksPipesAndDevicesAreNeitherReadNorReplaced) {
  fs::create_directories(maps_);
  std::ofstream(root_ / "secret") << "radar,range_m,az_deg\n";
  fs::create_symlink(root_ / "secret", maps_ / "link");
  fs::create_symlink("/dev/zero", maps_ / "zero");
  ASSERT_EQ(::mkfifo((maps_ / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "zero", "pipe"}) {
    const std::string path = folder_.pathOf(name);
    EXPECT_EQ(complaint([&] { folder_.load(name, limits()); }), path + ": cannot be read: it is no regular file");
    EXPECT_EQ(complaint([&] { folder_.save(name, maps_to_save_); }),
              path + ": cannot be written: it exists and is no regular file");
  }
  EXPECT_EQ(fs::file_size(root_ / "secret"), 21U);
}

TEST_F(ClutterFolderTest, AFileWithoutEndIsRefused) {
  fs::create_directories(maps_);
  std::ofstream(maps_ / "large") << "x";
  fs::resize_file(maps_ / "large", std::uintmax_t{1} << 40U);
  EXPECT_NE(complaint([&] { folder_.load("large", limits()); }).find("is larger than"), std::string::npos);
}

TEST_F(ClutterFolderTest, TheFolderDoesNotGrowWithoutEnd) {
  folder_.save("a", maps_to_save_);
  for (std::size_t i = 1; i < ClutterFolder::kMostFiles; ++i) std::ofstream(maps_ / std::to_string(i));
  EXPECT_NE(complaint([&] { folder_.save("b", maps_to_save_); }).find("remove some"), std::string::npos);
  EXPECT_EQ(complaint([&] { folder_.save("a", maps_to_save_); }), "");
}

// If this fails, a disk in the network that is gone stops the tracker at the first request, or at each one.
TEST_F(ClutterFolderTest, ADiskThatDoesNotAnswerCostsTheTimeLimitOnce) {
  const auto go = std::make_shared<std::atomic<bool>>(false);
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  const auto hang = [go] {
    while (!*go) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_NE(complaint([&] { folder_.within(hang); }).find("the disk has not answered for 1.0 s"), std::string::npos);
  const double first = elapsed();
  EXPECT_GE(first, ClutterFolder::kTimeLimit);
  EXPECT_NE(complaint([&] { folder_.save("a", maps_to_save_); }).find("earlier work is not done"), std::string::npos);
  EXPECT_LT(elapsed() - first, 0.5 * ClutterFolder::kTimeLimit);
  *go = true;
  while (!complaint([&] { folder_.save("a", maps_to_save_); }).empty()) ASSERT_LT(elapsed(), 30.0);
}

TEST_F(ClutterFolderTest, WithoutAParameterItIsInRosFolder) {
  ::setenv("ROS_HOME", root_.c_str(), 1);
  EXPECT_EQ(ClutterFolder("").pathOf("a"), (root_ / "clutter_maps" / "a").string());
  ::unsetenv("ROS_HOME");
}

}  // namespace
}  // namespace adit_tracker
