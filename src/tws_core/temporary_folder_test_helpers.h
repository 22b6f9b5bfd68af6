#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace tws {

/// A new folder that goes, with all in it, when the test ends: two runs of the tests at once do not meet.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(testing::TempDir() + "tws_test_XXXXXX") {
    if (!mkdtemp(path_.data())) throw std::runtime_error("cannot make a folder like " + path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }

  const std::string& path() const { return path_; }
  /// The path of a file of that name, which need not be there.
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  /// The same, of a file that now has this content.
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(file(name)) << content;
    return file(name);
  }

 private:
  std::string path_;
};

}  // namespace tws
