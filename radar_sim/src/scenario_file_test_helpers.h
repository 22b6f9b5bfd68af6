#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_runtime/parameters.h>

#include "scenario.h"

namespace radar_sim {

/// Writes what a test wants to a scenario file of its own, and loads it.
class ScenarioFile : public ::testing::Test {
 protected:
  Scenario load(const std::string& content) {
    std::ofstream(path_) << content;
    return loadScenario(path_);
  }

  /// What loadScenario says of such a file, without the path before it.
  std::string complaint(const std::string& content) {
    try {
      load(content);
      return "nothing was wrong";
    } catch (const tws_runtime::ParameterError& error) {
      const std::string what = error.what();
      return what.rfind(path_, 0) == 0 ? what.substr(path_.size()) : "no path in: " + what;
    }
  }

  void expectComplaint(const std::string& content, int line, const std::string& reason) {
    const std::string what = complaint(content);
    EXPECT_EQ(what.rfind(":" + std::to_string(line) + ":", 0), 0u) << what << "\nexpected line " << line << " in:\n"
                                                                   << content;
    EXPECT_NE(what.find(reason), std::string::npos) << what << "\nexpected: " << reason;
  }

  const tws::TemporaryFolder folder_;
  const std::string path_ = folder_.file("scenario.yaml");
};

}  // namespace radar_sim
